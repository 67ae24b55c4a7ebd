/* tank.c -- the order of a tick for all fish: feel, decide, move, meet, part, settle. */
#include "core/tank/tank.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/morph/morph.h"
#include "core/tank/gait.h"
#include "core/tank/swim.h"

#define PLACE_TRIES 12u /* For a spot clear of the bowl; then any will do. */
#define START_ROUNDS_MAX 200u
#define ALARM_FADE_PER_S 0.6f
#define ALARM_START_MIN 0.45f /* The timid start at this alarm, the bold at 0.9. */
#define PUSH_SHARE 0.10f      /* A tick: pushes come and go within a twelfth of a second. */
#define HULL_SHUN_DEPTH_M                                                                          \
    0.01f /* A fish that passes deeper below a bowl than this need not turn. */

static struct tank_bounds tank_bounds(const struct tank *tank)
{
    const vec3 half = v3_scale(tank->size_m, 0.5f);
    return (struct tank_bounds){ { -half.x, -tank->size_m.y, -half.z }, { half.x, 0.0f, half.z } };
}

static int under_bowl(vec3 point_m, vec3 bowl_m, float clear_m)
{
    const float dx = point_m.x - bowl_m.x, dz = point_m.z - bowl_m.z;
    return dx * dx + dz * dz < clear_m * clear_m;
}

static vec3 place(const struct tank *tank, const struct fish *fish, uint32_t index,
                  const struct tank_preset *preset)
{
    const float inset_m = 0.5f * fish->length_m;
    const float half_m = 0.5f * FISH_HEIGHT_PER_LENGTH * fish->length_m;
    const float x = 0.5f * tank->size_m.x - inset_m, z = 0.5f * tank->size_m.z - inset_m;
    vec3 point = { 0.0f, 0.0f, 0.0f };
    for (uint32_t attempt = 0; attempt < PLACE_TRIES; attempt++) {
        const uint32_t seed = tank->seed;
        point.x = rng_range((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_X }, -x, x);
        point.y = rng_range((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_Y },
                            half_m - tank->size_m.y, -half_m);
        point.z = rng_range((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_Z }, -z, z);
        if (!under_bowl(point, preset->bowl_m, preset->bowl_radius_m + inset_m)) {
            break;
        }
    }
    return point;
}

static struct fish hatch(const struct tank *tank, const struct tank_preset *preset, uint32_t index)
{
    const struct gait_luck luck = { tank->seed, 0, index };
    const float old = rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_AGE });
    struct fish fish = { .look = rng_u32((struct rng_key){ tank->seed, 0, index, RNG_FISH_LOOK }) };
    fish.age_days = tank_preset_age_days(preset, old);
    fish.length_m = growth_length_m(&species_wakin.growth, fish.age_days);
    fish.stamina = rng_range((struct rng_key){ tank->seed, 0, index, RNG_FISH_STAMINA },
                             preset->stamina_min, preset->stamina_max);
    fish.position_m = place(tank, &fish, index, preset);
    fish.angles.yaw_rad =
        rng_range((struct rng_key){ tank->seed, 0, index, RNG_FISH_YAW }, -F_PI, F_PI);
    fish.heading_rad = fish.angles.yaw_rad;
    fish.brake = 1.0f;
    fish.room = 1.0f;
    fish.tail_beat_hz = 0.5f;
    fish.tail_amplitude = 0.15f;
    fish.tail_phase_rad = (float)(fish.look & 1023u) * (F_TAU / 1024.0f);
    /* A third already swim, as in the long run; all are somewhere in the middle of what they do. */
    const struct rng_key start = { tank->seed, 0, index, RNG_FISH_START_GAIT };
    const int swims = rng_unit(start) < 0.31f;
    gait_enter(&fish, swims ? GAIT_SWIM : GAIT_REST, luck, tank->size_m.y);
    fish.gait_left_s *= rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_START_LEFT });
    return fish;
}

static void take_bodies(struct tank *tank)
{
    for (uint32_t i = 0; i < tank->crowd.count; i++) {
        tank->fish[tank->crowd.body[i].fish].position_m = tank->crowd.body[i].box.centre_m;
    }
}

/* Random places overlap; parting them until none does is quicker than drawing until none would. */
static void spread_out(struct tank *tank)
{
    const struct tank_bounds bounds = tank_bounds(tank);
    for (uint32_t round = 0; round < START_ROUNDS_MAX; round++) {
        crowd_gather(&tank->crowd, tank->fish, tank->fish_count, tank->space, NULL);
        crowd_clear(&tank->crowd, &bounds, 0, 0);
        crowd_meet(&tank->crowd, tank->size_m, tank->seed, round);
        if (round > 0 && tank->crowd.overlap_count == 0) {
            return;
        }
        crowd_part(&tank->crowd, &bounds, 0, 0);
        take_bodies(tank);
    }
}

void tank_init(struct tank *tank, uint8_t preset_id, uint32_t fish_count, uint32_t seed)
{
    CORE_ASSERT(fish_count >= 1u);
    const struct tank_preset *preset = tank_preset(preset_id);
    CORE_ASSERT(fish_count <= tank_preset_fish_max(preset));
    memset(tank, 0, sizeof *tank);
    tank->seed = seed;
    tank->preset = preset_id;
    tank->size_m = preset->size_m;
    tank->wall_height_m = preset->wall_height_m;
    tank->fish_count = fish_count;
    water_init(&tank->water);
    for (uint32_t i = 0; i < fish_count; i++) {
        tank->fish[i] = hatch(tank, preset, i);
    }
    tank->space = crowd_space(tank->fish, fish_count, tank->size_m);
    spread_out(tank);
}

static void shun_bowl(struct swim_shun *shun, const struct fish *fish, const struct obstacle *bowl)
{
    const float half_m = 0.5f * FISH_HEIGHT_PER_LENGTH * fish->length_m;
    const float bottom_m = bowl->centre_m.y - bowl->depth_m;
    if (fish->position_m.y + half_m < bottom_m - HULL_SHUN_DEPTH_M) {
        return;
    }
    const vec3 to =
        v3(bowl->centre_m.x - fish->position_m.x, 0.0f, bowl->centre_m.z - fish->position_m.z);
    const vec3 normal = v3_normalize_or(to, v3(1.0f, 0.0f, 0.0f));
    swim_shun_add(shun, fish, normal, v3_length(to) - bowl->radius_m);
}

/* Turns away from walls and bowls. */
static void shun(struct fish *fish, vec3 size_m, const struct obstacle *obstacles,
                 uint32_t obstacle_count)
{
    struct swim_shun all = { 0 };
    swim_shun_walls(&all, fish, size_m);
    for (uint32_t i = 0; i < obstacle_count; i++) {
        if (obstacles[i].kind == OBSTACLE_BOWL) {
            shun_bowl(&all, fish, &obstacles[i]);
        }
    }
    swim_shun_turn(fish, &all);
}

/* Takes fright at the poi, or steps aside. */
static void feel(struct fish *fish, struct gait_luck luck, const struct obstacle *obstacles,
                 uint32_t obstacle_count)
{
    const float boldness = (float)(fish->look >> 3 & 31u) / 31.0f;
    fish->alarm = f_max(0.0f, fish->alarm - ALARM_FADE_PER_S * CORE_TICK_S);
    for (uint32_t i = 0; i < obstacle_count; i++) {
        const vec3 aside_m_s = obstacle_sidestep_m_s(&obstacles[i], fish->position_m);
        fish->push_m_s = v3_mad(fish->push_m_s, aside_m_s, PUSH_SHARE);
        fish->alarm = f_min(1.0f, fish->alarm + obstacle_alarm(&obstacles[i], fish->position_m));
        if (fish->gait != GAIT_ESCAPE && fish->alarm > ALARM_START_MIN * (1.0f + boldness)) {
            gait_escape(fish, obstacles[i].centre_m, luck);
        }
    }
}

static void act(struct tank *tank, uint32_t index, uint32_t tick, const struct obstacle *obstacles,
                uint32_t obstacle_count)
{
    struct fish *fish = &tank->fish[index];
    const struct gait_luck luck = { tank->seed, tick, index };
    if (swim_fall(fish)) {
        gait_escape(fish, v3_add(fish->position_m, fish_forward(fish)), luck);
        fish->heading_rad = fish->angles.yaw_rad;
        fish->depth_goal_m = -0.6f * tank->size_m.y;
        return;
    }
    feel(fish, luck, obstacles, obstacle_count);
    gait_tick(fish, luck, tank->size_m.y);
    swim_wander(fish, tank->seed, tick, index);
    shun(fish, tank->size_m, obstacles, obstacle_count);
    swim_move(fish, gait_speed_m_s(fish, tick), gait_run_up_s(fish->length_m));
}

/* Bodies take their final places; advice and pushes are for the next tick. */
static void settle(struct tank *tank, uint32_t tick)
{
    for (uint32_t i = 0; i < tank->crowd.count; i++) {
        const struct crowd_body *body = &tank->crowd.body[i];
        struct fish *fish = &tank->fish[body->fish];
        fish->position_m = body->box.centre_m;
        fish->push_m_s =
            v3_lerp(fish->push_m_s, v3_limit(body->push_m_s, 0.45f * fish->length_m), PUSH_SHARE);
        swim_settle(fish, v3_sub(fish->position_m, tank->before_m[body->fish]), body->forward,
                    gait_beats(fish, tick));
        fish->room = f_min(body->room, fish->room + 2.0f * CORE_TICK_S);
        if (fish->gait != GAIT_ESCAPE) {
            avoid_tick(fish, &body->advice, body->brake, tank->size_m.y);
        }
    }
}

/* A surface that is never quite still. */
static void drip(struct tank *tank, uint32_t tick)
{
    if (tick % 24u != 0) {
        return;
    }
    const struct rng_key key = { tank->seed, tick, 0, RNG_WATER_DROP };
    const struct rng_key other = { tank->seed, tick, 1, RNG_WATER_DROP };
    const struct rng_key size = { tank->seed, tick, 2, RNG_WATER_DROP };
    const vec3 point = v3(rng_range(key, -0.5f, 0.5f) * tank->size_m.x, 0.0f,
                          rng_range(other, -0.5f, 0.5f) * tank->size_m.z);
    water_press(&tank->water, tank->size_m, point, 0.025f, rng_range(size, 0.0001f, 0.0006f));
}

void tank_tick(struct tank *tank, uint32_t tick, const struct obstacle *obstacles,
               uint32_t obstacle_count)
{
    CORE_ASSERT(obstacle_count <= TANK_OBSTACLE_MAX);
    const struct tank_bounds bounds = tank_bounds(tank);
    drip(tank, tick);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        tank->before_m[i] = tank->fish[i].position_m;
        if (fish_swims(&tank->fish[i])) {
            act(tank, i, tick, obstacles, obstacle_count);
        }
    }
    crowd_gather(&tank->crowd, tank->fish, tank->fish_count, tank->space, tank->before_m);
    crowd_clear(&tank->crowd, &bounds, obstacles, obstacle_count);
    crowd_meet(&tank->crowd, tank->size_m, tank->seed, tick);
    crowd_part(&tank->crowd, &bounds, obstacles, obstacle_count);
    settle(tank, tick);
}

uint64_t tank_hash_quick(uint64_t hash, const struct tank *tank)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        hash = fish_hash_quick(hash, &tank->fish[i]);
    }
    return hash;
}

uint64_t tank_hash(uint64_t hash, const struct tank *tank)
{
    hash = hash_u32(hash, tank->seed);
    hash = hash_u32(hash, tank->preset);
    hash = hash_vec3(hash, tank->size_m);
    hash = hash_float(hash, tank->wall_height_m);
    hash = hash_float(hash, tank->space);
    hash = hash_u32(hash, tank->fish_count);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        hash = fish_hash(hash, &tank->fish[i]);
    }
    return water_hash(hash, &tank->water);
}
