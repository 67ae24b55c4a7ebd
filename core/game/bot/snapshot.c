/* snapshot.c -- captures a snapshot: selects fish, and computes speeds and the state of the
 * paper. */
#include "core/game/bot/bot.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/poi/paper/paper_patch.h"

/* Weight of the depth when the nearby fish are ranked by distance. A fish that is 1 cm deeper has
 * the same rank as a fish that is 4 cm farther away. */
#define DEPTH_WEIGHT 4.0f
/* Distance that is subtracted from the distance of a gulping fish when the nearby fish are ranked,
 * because gulping attracts the bot's attention. */
#define GULP_M 0.04f
/* Largest distance above the paper at which a fish in the water counts as above the paper. */
#define OVER_M 0.045f
/* Largest distance above the paper at which a fish out of the water counts as lying on the
 * paper. */
#define RIDE_M 0.025f

static struct snapshot_fish see_fish(const struct vision *vision, uint32_t index)
{
    CORE_ASSERT(index < SNAPSHOT_NO_FISH);
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

/* Sets the velocity of `now` from the fish's position in the snapshot `before`, if `before`
 * contains the fish. */
static void estimate_velocity(struct snapshot_fish *now, const struct snapshot *before,
                              uint32_t tick)
{
    const struct snapshot_fish *then = before->prey.fish == now->fish ? &before->prey : NULL;
    CORE_ASSERT(before->near_count <= SNAPSHOT_NEAR_MAX);
    for (uint32_t i = 0; i < before->near_count && !then; i++) {
        then = before->near[i].fish == now->fish ? &before->near[i] : NULL;
    }
    if (then && tick > before->tick) {
        const float per_s = (float)CORE_TICK_HZ / (float)(tick - before->tick);
        now->velocity_m_s = v3_scale(v3_sub(now->position_m, then->position_m), per_s);
    }
}

/* ---- List of the nearby fish ----------------------------------------------------------------- */

/* Counts `fish` in `snapshot` if the fish lies on the bot's own paper, or is in the water above
 * this paper. */
static void count_upon(struct snapshot *snapshot, const struct basis *axes,
                       const struct vision_fish *fish)
{
    const float radius_m = snapshot->poi.radius_m, reach_m = radius_m + OVER_M;
    const vec3 away = v3_sub(fish->position_m, snapshot->poi.position_m);
    if (fish->place == SCENE_IN_BOWL || v3_dot(away, away) > reach_m * reach_m) {
        return;
    }
    const vec3 place = vec_basis_to_body(axes, away);
    if (place.x * place.x + place.z * place.z <= radius_m * radius_m && place.y >= -0.005f) {
        snapshot->carried_count += fish->place == SCENE_ON_POI && place.y < RIDE_M;
        snapshot->over += fish->place == SCENE_IN_TANK && place.y < OVER_M;
    }
}

/* Fills the list of nearby fish, which is sorted by rank. The list keeps the best SNAPSHOT_NEAR_MAX
 * fish. */
static void see_all(struct snapshot *snapshot, const struct vision *vision, vec3 attention_m)
{
    const struct basis axes = vec_basis_from_angles(snapshot->poi.angles);
    const uint32_t count = vision_game(vision).fish_count;
    /* Rank of each fish in the list: its distance, corrected for depth and gulping. A lower rank is
     * better. */
    float rank_m[SNAPSHOT_NEAR_MAX];
    for (uint32_t i = 0; i < SNAPSHOT_NEAR_MAX; i++) {
        rank_m[i] = 1e9f;
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct vision_fish fish = vision_fish(vision, i);
        if (snapshot->poi.present) {
            count_upon(snapshot, &axes, &fish);
        }
        if (fish.place != SCENE_IN_TANK) {
            continue;
        }
        const float dx = fish.position_m.x - attention_m.x;
        const float dz = fish.position_m.z - attention_m.z;
        const float rank = f_sqrt(dx * dx + dz * dz) - DEPTH_WEIGHT * fish.position_m.y -
                           (fish.gulp > 0.0f ? GULP_M : 0.0f);
        uint32_t at = snapshot->near_count < SNAPSHOT_NEAR_MAX ? snapshot->near_count++
                                                               : SNAPSHOT_NEAR_MAX - 1u;
        if (rank >= rank_m[at]) {
            continue;
        }
        for (; at > 0 && rank_m[at - 1u] > rank; at--) {
            rank_m[at] = rank_m[at - 1u];
            snapshot->near[at] = snapshot->near[at - 1u];
        }
        rank_m[at] = rank;
        snapshot->near[at] = see_fish(vision, i);
    }
}

/* ---- Search for an undamaged patch of the paper ---------------------------------------------- */

struct picture {
    const struct vision *vision;
    float radius_m;
};

static bool snapshot_patch_is_whole(const void *paper, float x_m, float z_m)
{
    CORE_ASSERT(((const struct picture *)paper)->radius_m > 0.0f);
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
        const uint32_t column = cell % SHEET_SIDE, row = cell / SHEET_SIDE;
        const float x = (((float)column + 0.5f) * 2.0f / (float)SHEET_SIDE - 1.0f) * radius_m;
        const float z = (((float)row + 0.5f) * 2.0f / (float)SHEET_SIDE - 1.0f) * radius_m;
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

/* ---- Taking a snapshot and predicting the position of a fish --------------------------------- */

void snapshot_take(struct snapshot *snapshot, const struct snapshot *before,
                   const struct vision *vision, uint16_t prey, vec3 attention_m)
{
    const struct vision_game game = vision_game(vision);
    CORE_ASSERT(snapshot != before && v3_is_finite(attention_m));
    memset(snapshot, 0, sizeof *snapshot);
    snapshot->tick = game.tick;
    snapshot->phase = game.phase;
    snapshot->mode = game.mode;
    snapshot->seconds_left = game.seconds_left;
    snapshot->tank_m = game.tank_m;
    snapshot->poi = vision_poi(vision, vision->player);
    snapshot->bowl = vision_bowl(vision, vision->player);
    snapshot->prey.fish = SNAPSHOT_NO_FISH;
    see_paper(snapshot, vision);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct vision_poi other = vision_poi(vision, i);
        if (i != vision->player && other.present) {
            snapshot->rival_m[snapshot->rival_count++] = other.position_m;
        }
    }
    see_all(snapshot, vision, attention_m);
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        estimate_velocity(&snapshot->near[i], before, game.tick);
    }
    if (prey != SNAPSHOT_NO_FISH) {
        snapshot->prey = see_fish(vision, prey);
        estimate_velocity(&snapshot->prey, before, game.tick);
    }
}

vec3 snapshot_predict(const struct snapshot_fish *seen, float age_s)
{
    CORE_ASSERT(age_s >= 0.0f);
    return v3_muladd(seen->position_m, seen->velocity_m_s, f_min(age_s, SNAPSHOT_PREDICT_S));
}
