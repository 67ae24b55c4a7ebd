/* look.c -- capture of a snapshot: selection of fish, speeds, and the state of the paper. */
#include "core/game/look.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/game/patch.h"

#define DEPTH_WEIGHT 4.0f   /* Depth counts four times: a fish 1 cm deeper ranks like one 4 cm
                               farther away. */
#define GULP_M 0.04f        /* Distance bonus of a gulping fish, which attracts attention. */
#define OVER_M 0.045f       /* Depth of the water above the paper that is searched. */
#define RIDE_M 0.025f       /* Greatest height of a fish lying on the paper. */

static struct look_fish see_fish(const struct sight *sight, uint32_t index)
{
    const struct sight_fish fish = sight_fish(sight, index);
    return (struct look_fish){
        .fish = (uint16_t)index,
        .place = fish.place,
        .gulps = fish.gulp > 0.0f,
        .position_m = fish.position_m,
        .heading_rad = fish.angles.yaw_rad,
        .length_m = fish.length_m,
    };
}

/* ---- Speeds --------------------------------------------------------------------------------- */

static const struct look_fish *remembered(const struct look *before, uint16_t fish)
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

static void judge_speed(struct look_fish *now, const struct look *before, uint32_t tick)
{
    const struct look_fish *then = remembered(before, now->fish);
    if (then && tick > before->tick) {
        const float per_s = (float)CORE_TICK_HZ / (float)(tick - before->tick);
        now->velocity_m_s = v3_scale(v3_sub(now->position_m, then->position_m), per_s);
    }
}

/* ---- Nearby fish ---------------------------------------------------------------------------- */

static float strangeness(const struct sight_fish *fish, vec3 attention_m)
{
    const float dx = fish->position_m.x - attention_m.x, dz = fish->position_m.z - attention_m.z;
    const float bonus_m = fish->gulp > 0.0f ? GULP_M : 0.0f;
    return f_sqrt(dx * dx + dz * dz) - DEPTH_WEIGHT * fish->position_m.y - bonus_m;
}

/* Inserts a fish into the list of the LOOK_NEAR_MAX best-ranked fish, in order of rank. */
static void notice(struct look *look, float far_m[LOOK_NEAR_MAX], const struct sight *sight,
                   uint32_t index, float strange_m)
{
    uint32_t at = look->near_count < LOOK_NEAR_MAX ? look->near_count++ : LOOK_NEAR_MAX - 1u;
    if (strange_m >= far_m[at]) {
        return;
    }
    for (; at > 0 && far_m[at - 1u] > strange_m; at--) {
        far_m[at] = far_m[at - 1u];
        look->near[at] = look->near[at - 1u];
    }
    far_m[at] = strange_m;
    look->near[at] = see_fish(sight, index);
}

/* Counts a fish that is on or above the bot's own paper, in the poi's axes. */
static void count_upon(struct look *look, const struct basis *axes, const struct sight_fish *fish)
{
    const vec3 away = v3_sub(fish->position_m, look->poi.position_m);
    const float reach_m = look->poi.radius_m + OVER_M;
    if (fish->place == SCENE_IN_BOWL || v3_dot(away, away) > reach_m * reach_m) {
        return;
    }
    const vec3 place = basis_to_body(axes, away);
    if (place.x * place.x + place.z * place.z > look->poi.radius_m * look->poi.radius_m ||
        place.y < -0.005f) {
        return;
    }
    look->riders += fish->place == SCENE_ON_POI && place.y < RIDE_M;
    look->over += fish->place == SCENE_IN_TANK && place.y < OVER_M;
}

static void see_all(struct look *look, const struct sight *sight, vec3 attention_m)
{
    const struct basis axes = basis_from_angles(look->poi.angles);
    const uint32_t count = sight_fish_count(sight);
    float far_m[LOOK_NEAR_MAX];
    for (uint32_t i = 0; i < LOOK_NEAR_MAX; i++) {
        far_m[i] = 1e9f;
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct sight_fish fish = sight_fish(sight, i);
        if (look->poi.present) {
            count_upon(look, &axes, &fish);
        }
        if (fish.place == SCENE_IN_TANK) {
            notice(look, far_m, sight, i, strangeness(&fish, attention_m));
        }
    }
}

static void see_rivals(struct look *look, const struct sight *sight)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct sight_poi other = sight_poi(sight, i);
        if (i != sight->player && other.present) {
            look->rival_m[look->rival_count++] = other.position_m;
        }
    }
}

/* ---- Paper ---------------------------------------------------------------------------------- */

static float line_m(float radius_m, uint32_t line)
{
    return (((float)line + 0.5f) * 2.0f / (float)SHEET_SIDE - 1.0f) * radius_m;
}

struct picture {
    const struct sight *sight;
    float radius_m;
};

static int is_whole(const void *paper, float x_m, float z_m)
{
    const struct picture *picture = paper;
    const float per_m = 0.5f * (float)SHEET_SIDE / picture->radius_m;
    const float column =
        f_clamp((x_m + picture->radius_m) * per_m, 0.0f, (float)SHEET_SIDE - 1.0f);
    const float row = f_clamp((z_m + picture->radius_m) * per_m, 0.0f, (float)SHEET_SIDE - 1.0f);
    return sight_integrity(picture->sight, (uint32_t)row * SHEET_SIDE + (uint32_t)column) > 0;
}

static void see_paper(struct look *look, const struct sight *sight)
{
    const float radius_m = look->poi.radius_m;
    float wet = 0.0f, count = 0.0f;
    look->paper = (struct look_paper){ .left = look->poi.paper_left };
    if (!look->poi.present) {
        return;
    }
    for (uint32_t cell = 0; cell < SHEET_SIDE * SHEET_SIDE; cell++) {
        const float x = line_m(radius_m, cell % SHEET_SIDE);
        const float z = line_m(radius_m, cell / SHEET_SIDE);
        if (x * x + z * z < radius_m * radius_m && sight_integrity(sight, cell) > 0) {
            wet += (float)sight_wetness(sight, cell) * (1.0f / 255.0f);
            count += 1.0f;
        }
    }
    look->paper.wet = count > 0.0f ? wet / count : 0.0f;
    const struct picture picture = { sight, radius_m };
    struct patch patch = { 0 };
    look->paper.holds = (uint8_t)patch_find(is_whole, &picture, radius_m, &patch);
    look->paper.middle = patch.middle;
    look->paper.x_m = patch.x_m;
    look->paper.z_m = patch.z_m;
}

/* ---- Public --------------------------------------------------------------------------------- */

void look_take(struct look *look, const struct look *before, const struct sight *sight,
               uint16_t prey, vec3 attention_m)
{
    const struct sight_game game = sight_game(sight);
    memset(look, 0, sizeof *look);
    look->tick = game.tick;
    look->phase = game.phase;
    look->mode = game.mode;
    look->seconds_left = game.seconds_left;
    look->tank_m = sight_tank_m(sight);
    look->poi = sight_poi(sight, sight->player);
    look->bowl = sight_bowl(sight, sight->player);
    look->prey.fish = LOOK_NO_FISH;
    see_paper(look, sight);
    see_rivals(look, sight);
    see_all(look, sight, attention_m);
    for (uint32_t i = 0; i < look->near_count; i++) {
        judge_speed(&look->near[i], before, game.tick);
    }
    if (prey != LOOK_NO_FISH) {
        look->prey = see_fish(sight, prey);
        judge_speed(&look->prey, before, game.tick);
    }
}

vec3 look_foresee(const struct look_fish *seen, float age_s)
{
    return v3_mad(seen->position_m, seen->velocity_m_s, f_min(age_s, LOOK_FORESIGHT_S));
}

static uint64_t hash_fish(uint64_t hash, const struct look_fish *fish)
{
    hash = hash_u32(hash, fish->fish);
    hash = hash_u32(hash, fish->place);
    hash = hash_u32(hash, fish->gulps);
    hash = hash_vec3(hash, fish->position_m);
    hash = hash_vec3(hash, fish->velocity_m_s);
    hash = hash_float(hash, fish->heading_rad);
    return hash_float(hash, fish->length_m);
}

static uint64_t hash_own(uint64_t hash, const struct look *look)
{
    const struct sight_poi *poi = &look->poi;
    const struct look_paper *paper = &look->paper;
    const float values[] = { poi->angles.yaw_rad, poi->angles.pitch_rad, poi->angles.roll_rad,
                             poi->radius_m,       poi->paper_left,       poi->water_m,
                             paper->wet,          paper->left,           paper->x_m,
                             paper->z_m,          look->bowl.radius_m };
    hash = hash_u32(hash, poi->present);
    hash = hash_u32(hash, look->bowl.present);
    hash = hash_u32(hash, paper->holds);
    hash = hash_u32(hash, paper->middle);
    hash = hash_vec3(hash, poi->position_m);
    hash = hash_vec3(hash, look->bowl.position_m);
    return hash_floats(hash, values, sizeof values / sizeof values[0]);
}

uint64_t look_hash(uint64_t hash, const struct look *look)
{
    hash = hash_u32(hash, look->tick);
    hash = hash_u32(hash, look->phase);
    hash = hash_u32(hash, look->mode);
    hash = hash_float(hash, look->seconds_left);
    hash = hash_vec3(hash, look->tank_m);
    hash = hash_own(hash, look);
    hash = hash_u32(hash, look->rival_count);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = hash_vec3(hash, look->rival_m[i]);
    }
    hash = hash_u32(hash, look->riders);
    hash = hash_u32(hash, look->over);
    hash = hash_fish(hash, &look->prey);
    hash = hash_u32(hash, look->near_count);
    for (uint32_t i = 0; i < LOOK_NEAR_MAX; i++) {
        hash = hash_fish(hash, &look->near[i]);
    }
    return hash;
}
