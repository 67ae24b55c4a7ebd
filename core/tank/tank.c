/* tank.c -- advances all fish by one tick, in the order decisions, motion, broad phase, contact
 * solver and velocities. */
#include "core/tank/tank.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/behavior/swim.h"

/* Distance per tick above which a moving obstacle (a poi or a bowl) counts as a poi (paper scoop)
 * that a player moves. The distance corresponds to 12 mm/s, because a tick lasts 1/120 s. */
#define STIRS_M 0.0001f
#define BUBBLE_TICKS 6u /* Ticks between two bubbles of the pump: 20 bubbles per second. */
/* Radius of the circle above the air stone within which bubbles reach the surface. */
#define BUBBLES_M 0.014f
#define STONE_INSET_M 0.045f
#define BUBBLE_RADIUS_M 0.012f
#define BUBBLE_M 0.0011f /* Height by which a bubble lifts the surface. */
#define GULP_RADIUS_M 0.010f
#define GULP_DEPTH_M 0.0004f
/* Smoothing factor of `push_m_s`, the velocity with which nearby fish push a fish. Every full
 * broad-phase query computes a new value. The query then moves `push_m_s` toward the new value by
 * this fraction of the difference. Queries are 33 ms apart and the fraction is 1 - exp(-33 / 79),
 * so `push_m_s` changes with a time constant of 79 ms. */
#define PUSH_SHARE 0.344f
#define BORNE_M_S 0.05f
/* Largest increase per second of `room`, the factor [0, 1] on the largest turning rate of a fish. A
 * fish that turned slowly because of other fish beside it can turn at the full rate again after
 * half a second. */
#define ROOM_PER_S 2.0f

struct tank_bounds tank_bounds(const struct tank *tank)
{
    CORE_ASSERT(tank->size_m.x > 0.0f && tank->size_m.y > 0.0f && tank->size_m.z > 0.0f);
    const vec3 half = v3_scale(tank->size_m, 0.5f);
    return (struct tank_bounds){ { -half.x, -tank->size_m.y, -half.z }, { half.x, 0.0f, half.z } };
}

const struct behavior_params *tank_behavior_params(const struct tank *tank)
{
    return &tank_preset(tank->preset)->params;
}

struct perception tank_perception(const struct tank *tank, uint32_t tick,
                                  const struct obstacle *obstacles, uint32_t obstacle_count)
{
    CORE_ASSERT(obstacle_count <= TANK_OBSTACLE_MAX);
    CORE_ASSERT(obstacles || obstacle_count == 0);
    uint32_t shade_count = TANK_SHADE_MAX; /* Number of entries of tank->shade up to the last shade
                                              that is present. Each fish tests only these entries,
                                              which saves time. */
    while (shade_count > 0 && !tank->shade[shade_count - 1u].cast.present) {
        shade_count--;
    }
    return (struct perception){
        .params = tank_behavior_params(tank),
        .temper = tank->temper,
        .size_m = tank->size_m,
        .wall_follow = tank->wall_follow,
        .ball_spaces = tank->ball_spaces,
        .seed = tank->seed,
        .tick = tick,
        .dt_s = CORE_TICK_S,
        .oxygen_mg_l = tank->oxygen.dissolved_mg_l,
        .obstacles = obstacles,
        .obstacle_count = obstacle_count,
        .shades = tank->shade,
        .shade_count = shade_count,
    };
}

struct broad_phase_search tank_search(const struct tank *tank)
{
    return (struct broad_phase_search){ .search = tank->search, .lanes = tank->lanes };
}

static void update_behaviors(struct tank *tank, struct perception around)
{
    CORE_ASSERT(tank->fish_count <= TANK_FISH_MAX);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *fish = &tank->fish[i];
        if (fish_swims(fish) && fish_behavior_is_due(fish, i, &around)) {
            /* A falling fish that landed on other fish sinks more slowly than BORNE_M_S, because
             * the other fish carry it. A fish that falls freely into the water sinks at 12 cm/s or
             * faster. */
            const bool fell =
                fish->falls && (fish->position_m.y < 0.0f && fish->velocity_m_s.y > -BORNE_M_S);
            around.dt_s = fish_behavior_dt_s(fish, around.tick);
            fish_behavior_tick(fish, i, &around);
            /* A fish that opens its mouth at the surface makes a ring-shaped wave. */
            if (surface_gulps(fish, around.tick, around.dt_s)) {
                const vec3 nose_m =
                    v3_muladd(fish->position_m, fish_forward(fish), 0.5f * fish->length_m);
                water_press(&tank->water, tank->size_m, nose_m, GULP_RADIUS_M, GULP_DEPTH_M);
            }
            if (fell && fish->falls) { /* The fallen fish overlaps the fish that carry it. Reentry
                                          (reentry.c) separates them. */
                fish->alarm = 1.0f;
                reentry_begin(tank, fish, fish->velocity_m_s);
            }
        }
    }
}

/* Updates the list of contacts, which are the pairs of fish that could touch.
 *
 * In the first substep of every fourth tick (BROAD_PHASE_UPDATE_TICKS), the function runs a full
 * broad-phase query, which also computes how each fish avoids its neighbours. At other times, the
 * function reuses the results of the last query if they still contain every pair that could touch.
 * Otherwise the function runs a query that finds only contacts. */
static void update_broad_phase(struct tank *tank, uint32_t substep, const struct perception *around)
{
    CORE_ASSERT(substep < tank->solver.substep_count);
    struct broad_phase *broad_phase = &tank->broad_phase;
    const bool is_time = substep == 0 && around->tick % BROAD_PHASE_UPDATE_TICKS == 0;
    broad_phase_sync(broad_phase, tank->fish);
    if (!is_time && !broad_phase_is_stale(broad_phase)) {
        broad_phase_select_contacts(broad_phase);
        return;
    }
    if (!is_time && broad_phase_update_moved(broad_phase, tank->fish)) {
        return;
    }
    struct broad_phase_search how = tank_search(tank);
    how.contacts_only = !is_time; /* A query between two scheduled queries finds only contacts
                                     and gives no avoidance advice. */
    broad_phase_update(broad_phase, tank->fish, how, around);
    if (!is_time) {
        return;
    }
    /* Applies the results of the full query to the fish: avoidance advice, brakes, pushes and
     * room to turn. */
    struct perception then = *around;
    then.dt_s = (float)BROAD_PHASE_UPDATE_TICKS * CORE_TICK_S;
    CORE_ASSERT(broad_phase->count <= tank->fish_count);
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        if (!(broad_phase->flags[i] & BODY_SWIMMING)) {
            continue;
        }
        const struct neighbours *neighbours = &broad_phase->neighbours[i];
        struct fish *fish = &tank->fish[i];
        fish->push_m_s = v3_lerp(
            fish->push_m_s, v3_limit(neighbours->push_m_s, 0.45f * fish->length_m), PUSH_SHARE);
        fish->room = f_min(neighbours->room, fish->room + ROOM_PER_S * then.dt_s);
        if (fish->gait != GAIT_ESCAPE) {
            avoid_tick(fish, &neighbours->advice, neighbours->brake, &then);
        }
    }
}

vec3 tank_stone_m(vec3 size_m)
{
    return v3(STONE_INSET_M - 0.5f * size_m.x, -size_m.y, STONE_INSET_M - 0.5f * size_m.z);
}

/* Makes a small random wave every 24 ticks, because a real surface is never completely still. If
 * the pump runs, also makes waves above the air stone, where bubbles burst. */
static void make_waves(struct tank *tank, uint32_t tick)
{
    if (tick % 24u == 0) {
        const struct rng_key key = { tank->seed, tick, 0, RNG_WATER_DROP };
        const struct rng_key other = { tank->seed, tick, 1, RNG_WATER_DROP };
        const struct rng_key size = { tank->seed, tick, 2, RNG_WATER_DROP };
        const vec3 point = v3(rng_range(key, -0.5f, 0.5f) * tank->size_m.x, 0.0f,
                              rng_range(other, -0.5f, 0.5f) * tank->size_m.z);
        water_press(&tank->water, tank->size_m, point, 0.025f, rng_range(size, 0.0001f, 0.0006f));
    }
    if (tank->oxygen.pump && tick % BUBBLE_TICKS == 0) {
        const struct rng_key key = { tank->seed, tick, 0, RNG_WATER_BUBBLE };
        const struct rng_key other = { tank->seed, tick, 1, RNG_WATER_BUBBLE };
        const vec3 off = v3(rng_range(key, -BUBBLES_M, BUBBLES_M), 0.0f,
                            rng_range(other, -BUBBLES_M, BUBBLES_M));
        water_press(&tank->water, tank->size_m, v3_add(tank_stone_m(tank->size_m), off),
                    BUBBLE_RADIUS_M, -BUBBLE_M);
    }
}

void tank_tick(struct tank *tank, uint32_t tick, struct obstacle *obstacles,
               uint32_t obstacle_count)
{
    CORE_ASSERT(tank->fish_count <= TANK_FISH_MAX);
    CORE_ASSERT(obstacles || obstacle_count == 0);
    CORE_ASSERT(obstacle_count <= TANK_OBSTACLE_MAX);
    const struct perception around = tank_perception(tank, tick, obstacles, obstacle_count);
    /* While a poi (paper scoop) moves in the water, the contact solver may push fish farther per
     * tick, so that the fish make way for the poi. */
    bool stirs = false; /* True if a player moves a poi in the water: an obstacle in the water moves
                           by more than STIRS_M per tick. A bowl that rocks on ripples moves by
                           less. */
    for (uint32_t o = 0; o < obstacle_count; o++) {
        const vec3 step_m = obstacles[o].step_m;
        stirs |= obstacles[o].centre_m.y < obstacles[o].radius_m &&
                 v3_dot(step_m, step_m) > STIRS_M * STIRS_M;
    }
    const struct solver_context place = { tank->fish,
                                          tank_bounds(tank),
                                          obstacles,
                                          obstacle_count,
                                          stirs ? SOLVER_PUSH_M : SOLVER_CALM_PUSH_M,
                                          tank->lanes };
    make_waves(tank, tick);
    contact_solver_begin(&tank->solver, tank->fish, tank->fish_count);
    update_behaviors(tank, around);
    const struct shoal shoal = {
        .fish = tank->fish,
        .body = tank->broad_phase.body,
        .way_m = tank->broad_phase.way_m,
        .before_m = tank->solver.began_m,
        .count = tank->fish_count,
        .params = tank_behavior_params(tank),
        .space = tank->space,
    };
    swim_move_all(&shoal, tank->lanes);
    const uint32_t substeps = contact_solver_substep_count(&tank->solver, &place);
    for (uint32_t substep = 0; substep < substeps; substep++) {
        contact_solver_substep(&tank->solver, &tank->broad_phase, &place, substep);
        if (substep == 0) {
            broad_phase_mark(&tank->broad_phase, tank->fish, tank->fish_count);
        }
        contact_solver_project(&tank->solver, &tank->broad_phase, &place);
        update_broad_phase(tank, substep, &around);
        contact_solver_finish(&tank->solver, &tank->broad_phase, &place);
    }
    contact_solver_end(&tank->solver, &tank->broad_phase, &place);
    swim_settle_all(&shoal, tank->lanes);
    reentry_tick(tank, obstacles, obstacle_count);
    oxygen_tick(&tank->oxygen, tank->fish, tank->fish_count, tank->size_m, tick);
}

void tank_cast(struct tank *tank, const struct shade_cast casts[TANK_SHADE_MAX])
{
    for (uint32_t i = 0; i < TANK_SHADE_MAX; i++) {
        shade_tick(&tank->shade[i], &casts[i], CORE_TICK_S);
    }
}

uint32_t tank_shade_count(const struct tank *tank, const struct shade_cast *cast)
{
    CORE_ASSERT(tank->fish_count <= TANK_FISH_MAX);
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        count += fish_swims(fish) && shade_covers(cast, fish->position_m);
    }
    return count;
}
