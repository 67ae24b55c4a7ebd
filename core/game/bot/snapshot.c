/* snapshot.c -- captures a snapshot: selects fish, and computes speeds and the state of the
 * paper. */
#include "core/game/bot/snapshot.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/game/bot/paper_patch.h"

/* Weight of the depth in the ranking of nearby fish. A fish that is 1 cm deeper has the same rank
 * as a fish that is 4 cm farther away. */
#define DEPTH_WEIGHT 4.0f
/* Distance that is subtracted for a gulping fish, because gulping attracts attention. */
#define GULP_M 0.04f
#define OVER_M 0.045f /* Height of the water above the paper in which fish are counted. */
#define RIDE_M 0.025f /* Greatest height above the paper of a fish that lies on the paper. */

static struct snapshot_fish see_fish(const struct vision *vision, uint32_t index)
{
    const struct vision_fish fish = vision_fish(vision, index);
    return (struct snapshot_fish){
        .fish = (uint16_t)index,
        .place = fish.place,
        .gulps = fish.gulp > 0.0f,
        .position_m = fish.position_m,
        .heading_rad = fish.angles.yaw_rad,
        .length_m = fish.length_m,
    };
}

/* ---- Velocity of a fish ---------------------------------------------------------------------- */

static const struct snapshot_fish *remembered(const struct snapshot *before, uint16_t fish)
{
    if (before->prey.fish == fish) {
        return &before->prey;
    }
    for (uint32_t i = 0; i < before->near_count; i++) {
        if (before->near[i].fish == fish) {
            return &before->near[i];
        }
    }
    return NULL;
}

static void judge_speed(struct snapshot_fish *now, const struct snapshot *before, uint32_t tick)
{
    const struct snapshot_fish *then = remembered(before, now->fish);
    if (then && tick > before->tick) {
        const float per_s = (float)CORE_TICK_HZ / (float)(tick - before->tick);
        now->velocity_m_s = v3_scale(v3_sub(now->position_m, then->position_m), per_s);
    }
}

/* ---- Nearby fish ---------------------------------------------------------------------------- */

static float strangeness(const struct vision_fish *fish, vec3 attention_m)
{
    const float dx = fish->position_m.x - attention_m.x, dz = fish->position_m.z - attention_m.z;
    const float bonus_m = fish->gulp > 0.0f ? GULP_M : 0.0f;
    return f_sqrt(dx * dx + dz * dz) - DEPTH_WEIGHT * fish->position_m.y - bonus_m;
}

/* Inserts a fish into the list of nearby fish, which is sorted by rank. The list keeps the best
 * SNAPSHOT_NEAR_MAX fish. */
static void notice(struct snapshot *snapshot, float far_m[SNAPSHOT_NEAR_MAX],
                   const struct vision *vision, uint32_t index, float strange_m)
{
    uint32_t at =
        snapshot->near_count < SNAPSHOT_NEAR_MAX ? snapshot->near_count++ : SNAPSHOT_NEAR_MAX - 1u;
    if (strange_m >= far_m[at]) {
        return;
    }
    for (; at > 0 && far_m[at - 1u] > strange_m; at--) {
        far_m[at] = far_m[at - 1u];
        snapshot->near[at] = snapshot->near[at - 1u];
    }
    far_m[at] = strange_m;
    snapshot->near[at] = see_fish(vision, index);
}

/* Counts a fish if it is on or above the bot's own paper. `axes` are the axes of the bot's poi. */
static void count_upon(struct snapshot *snapshot, const struct basis *axes,
                       const struct vision_fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, snapshot->poi.position_m);
    const float reach_m = snapshot->poi.radius_m + OVER_M;
    if (fish->place == SCENE_IN_BOWL || v3_dot(away, away) > reach_m * reach_m) {
        return;
    }
    const vec3 place = vec_basis_to_body(axes, away);
    if (place.x * place.x + place.z * place.z > snapshot->poi.radius_m * snapshot->poi.radius_m ||
        place.y < -0.005f) {
        return;
    }
    snapshot->carried_count += fish->place == SCENE_ON_POI && place.y < RIDE_M;
    snapshot->over += fish->place == SCENE_IN_TANK && place.y < OVER_M;
}

static void see_all(struct snapshot *snapshot, const struct vision *vision, vec3 attention_m)
{
    const struct basis axes = vec_basis_from_angles(snapshot->poi.angles);
    const uint32_t count = vision_fish_count(vision);
    float far_m[SNAPSHOT_NEAR_MAX];
    for (uint32_t i = 0; i < SNAPSHOT_NEAR_MAX; i++) {
        far_m[i] = 1e9f;
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct vision_fish fish = vision_fish(vision, i);
        if (snapshot->poi.present) {
            count_upon(snapshot, &axes, &fish);
        }
        if (fish.place == SCENE_IN_TANK) {
            notice(snapshot, far_m, vision, i, strangeness(&fish, attention_m));
        }
    }
}

static void see_rivals(struct snapshot *snapshot, const struct vision *vision)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct vision_poi other = vision_poi(vision, i);
        if (i != vision->player && other.present) {
            snapshot->rival_m[snapshot->rival_count++] = other.position_m;
        }
    }
}

/* ---- Paper ---------------------------------------------------------------------------------- */

static float line_m(float radius_m, uint32_t line)
{
    return (((float)line + 0.5f) * 2.0f / (float)SHEET_SIDE - 1.0f) * radius_m;
}

struct picture {
    const struct vision *vision;
    float radius_m;
};

static int snapshot_patch_is_whole(const void *paper, float x_m, float z_m)
{
    const struct picture *picture = paper;
    const float per_m = 0.5f * (float)SHEET_SIDE / picture->radius_m;
    const float column = f_clamp((x_m + picture->radius_m) * per_m, 0.0f, (float)SHEET_SIDE - 1.0f);
    const float row = f_clamp((z_m + picture->radius_m) * per_m, 0.0f, (float)SHEET_SIDE - 1.0f);
    return vision_integrity(picture->vision, (uint32_t)row * SHEET_SIDE + (uint32_t)column) > 0;
}

static void see_paper(struct snapshot *snapshot, const struct vision *vision)
{
    const float radius_m = snapshot->poi.radius_m;
    float wet = 0.0f, count = 0.0f;
    snapshot->paper = (struct snapshot_paper){ .left = snapshot->poi.paper_left };
    if (!snapshot->poi.present) {
        return;
    }
    for (uint32_t cell = 0; cell < SHEET_SIDE * SHEET_SIDE; cell++) {
        const float x = line_m(radius_m, cell % SHEET_SIDE);
        const float z = line_m(radius_m, cell / SHEET_SIDE);
        if (x * x + z * z < radius_m * radius_m && vision_integrity(vision, cell) > 0) {
            wet += (float)vision_wetness(vision, cell) * (1.0f / 255.0f);
            count += 1.0f;
        }
    }
    snapshot->paper.wet = count > 0.0f ? wet / count : 0.0f;
    const struct picture picture = { vision, radius_m };
    struct patch patch = { 0 };
    snapshot->paper.holds =
        (uint8_t)paper_patch_find(snapshot_patch_is_whole, &picture, radius_m, &patch);
    snapshot->paper.middle = patch.middle;
    snapshot->paper.x_m = patch.x_m;
    snapshot->paper.z_m = patch.z_m;
}

/* ---- Public functions ------------------------------------------------------------------------ */

void snapshot_take(struct snapshot *snapshot, const struct snapshot *before,
                   const struct vision *vision, uint16_t prey, vec3 attention_m)
{
    const struct vision_game game = vision_game(vision);
    memset(snapshot, 0, sizeof *snapshot);
    snapshot->tick = game.tick;
    snapshot->phase = game.phase;
    snapshot->mode = game.mode;
    snapshot->seconds_left = game.seconds_left;
    snapshot->tank_m = vision_tank_m(vision);
    snapshot->poi = vision_poi(vision, vision->player);
    snapshot->bowl = vision_bowl(vision, vision->player);
    snapshot->prey.fish = SNAPSHOT_NO_FISH;
    see_paper(snapshot, vision);
    see_rivals(snapshot, vision);
    see_all(snapshot, vision, attention_m);
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        judge_speed(&snapshot->near[i], before, game.tick);
    }
    if (prey != SNAPSHOT_NO_FISH) {
        snapshot->prey = see_fish(vision, prey);
        judge_speed(&snapshot->prey, before, game.tick);
    }
}

vec3 snapshot_predict(const struct snapshot_fish *seen, float age_s)
{
    return v3_muladd(seen->position_m, seen->velocity_m_s, f_min(age_s, SNAPSHOT_PREDICT_S));
}

static uint64_t hash_fish(uint64_t hash, const struct snapshot_fish *fish)
{
    hash = hash_u32(hash, fish->fish);
    hash = hash_u32(hash, fish->place);
    hash = hash_u32(hash, fish->gulps);
    hash = hash_vec3(hash, fish->position_m);
    hash = hash_vec3(hash, fish->velocity_m_s);
    hash = hash_float(hash, fish->heading_rad);
    return hash_float(hash, fish->length_m);
}

static uint64_t hash_own(uint64_t hash, const struct snapshot *snapshot)
{
    const struct vision_poi *poi = &snapshot->poi;
    const struct snapshot_paper *paper = &snapshot->paper;
    const float values[] = { poi->angles.yaw_rad,
                             poi->angles.pitch_rad,
                             poi->angles.roll_rad,
                             poi->radius_m,
                             poi->paper_left,
                             poi->water_m,
                             paper->wet,
                             paper->left,
                             paper->x_m,
                             paper->z_m,
                             snapshot->bowl.radius_m };
    hash = hash_u32(hash, poi->present);
    hash = hash_u32(hash, snapshot->bowl.present);
    hash = hash_u32(hash, paper->holds);
    hash = hash_u32(hash, paper->middle);
    hash = hash_vec3(hash, poi->position_m);
    hash = hash_vec3(hash, snapshot->bowl.position_m);
    return hash_floats(hash, values, sizeof values / sizeof values[0]);
}

uint64_t snapshot_hash(uint64_t hash, const struct snapshot *snapshot)
{
    hash = hash_u32(hash, snapshot->tick);
    hash = hash_u32(hash, snapshot->phase);
    hash = hash_u32(hash, snapshot->mode);
    hash = hash_float(hash, snapshot->seconds_left);
    hash = hash_vec3(hash, snapshot->tank_m);
    hash = hash_own(hash, snapshot);
    hash = hash_u32(hash, snapshot->rival_count);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = hash_vec3(hash, snapshot->rival_m[i]);
    }
    hash = hash_u32(hash, snapshot->carried_count);
    hash = hash_u32(hash, snapshot->over);
    hash = hash_fish(hash, &snapshot->prey);
    hash = hash_u32(hash, snapshot->near_count);
    for (uint32_t i = 0; i < SNAPSHOT_NEAR_MAX; i++) {
        hash = hash_fish(hash, &snapshot->near[i]);
    }
    return hash;
}
