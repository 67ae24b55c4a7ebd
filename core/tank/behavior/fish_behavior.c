/* fish_behavior.c -- computes the decision of a fish, which senses, avoids and chooses goals in
 * order of urgency.
 *
 * Walls can attract fish: the heading of a swimming fish turns toward the walls, and the fish then
 * swims along them. With the constants in this file, a single fish spends the more time at a place,
 * the nearer the place is to a wall. The time falls to 1 / e over 7 cm (test_wall_following.c). */
#include "core/tank/behavior/fish_behavior.h"

#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/behavior/swim.h"
#include "core/tank/shade.h"
#include "core/tank/water.h"

/* Time constant with which a fish reacts to a change of the attraction of a shade on the water. The
 * delay keeps a fish from turning at every small change of the attraction. */
#define DRAWN_TAU_S 0.5f
/* Decay rate, 1/s, of `push_m_s`, the velocity that the flow around a poi (paper scoop) and
 * sidesteps add to a fish. Each decision adds the velocity of the flow times this rate and the time
 * step. Therefore `push_m_s` approaches the velocity of a constant flow. */
#define PUSH_PER_S 12.0f
/* Smallest distance between the hull (the underside) of a floating bowl and the back of a fish at
 * which the fish can swim under the bowl. A fish whose back is less deep turns away from the
 * bowl. */
#define HULL_SHUN_DEPTH_M 0.01f

bool fish_behavior_is_due(const struct fish *fish, uint32_t index, const struct perception *around)
{
    if ((index + around->tick) % FISH_BEHAVIOR_TICKS == 0 || fish->gait == GAIT_ESCAPE ||
        fish->position_m.y > -0.5f * fish->width_m || fish->falls) {
        return true;
    }
    return startle_alert(fish, around);
}

float fish_behavior_dt_s(const struct fish *fish, uint32_t tick)
{
    /* Ticks since the last decision of the fish, modulo 256. A fish that a poi (paper scoop) or a
     * bowl carried did not decide for a long time. For such a fish, the result is limited to
     * FISH_BEHAVIOR_TICKS. */
    const uint32_t ticks = (uint8_t)(tick - fish->thought_tick);
    return CORE_TICK_S * f_clamp((float)ticks, 1.0f, (float)FISH_BEHAVIOR_TICKS);
}

/* Turns the fish away from walls and bowls. */
static void avoidance(struct fish *fish, const struct perception *around)
{
    struct swim_avoidance all = { 0 };
    swim_avoid_walls(&all, fish, around->params, around->size_m);
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        const struct obstacle *bowl = &around->obstacles[i];
        const float bottom_m = bowl->centre_m.y - bowl->depth_m;
        if (bowl->kind == OBSTACLE_BOWL &&
            fish->position_m.y + 0.5f * fish->height_m >= bottom_m - HULL_SHUN_DEPTH_M) {
            const vec3 to = v3_flat(v3_sub(bowl->centre_m, fish->position_m));
            swim_avoid_add(&all, fish, around->params, v3_normalize_or(to, v3(1.0f, 0.0f, 0.0f)),
                           v3_length(to) - bowl->radius_m);
        }
    }
    swim_avoid_turn(fish, &all, around->dt_s);
}

/* Changes the goals of the fish by the attraction of shades. A fish that avoids another fish by yaw
 * keeps its heading and changes only its speed. */
static void follow_shade(struct fish *fish, const struct perception *around)
{
    const bool glides = fish->gait == GAIT_SWIM && fish->beats <= 0.0f;
    struct shade_course course = { fish->heading_rad,
                                   glides ? fish->speed_m_s : fish->speed_goal_m_s };
    float goal_rad = 0.0f;
    /* Fish that escape or breathe at the surface ignore shades. A fish in a burst ignores shades
     * unless params->shade_draws_bursts is set. */
    if ((fish->air == AIR_ENOUGH &&
         (fish->gait == GAIT_SWIM || fish->gait == GAIT_REST ||
          (fish->gait == GAIT_BURST && around->params->shade_draws_bursts))) &&
        shade_draw(around->shades, around->shade_count, around->params, fish, &course)) {
        goal_rad = fish->avoiding == AVOID_YAW
                       ? 0.0f
                       : f_wrap_angle(course.heading_rad - fish->heading_rad);
        swim_resolve_drawn(fish, course.speed_m_s);
    }
    const float off_rad = f_wrap_angle(goal_rad - fish->drawn_rad);
    fish->drawn_rad =
        f_wrap_angle(fish->drawn_rad + off_rad * f_min(1.0f, around->dt_s / DRAWN_TAU_S));
}

void fish_behavior_tick(struct fish *fish, uint32_t index, const struct perception *around)
{
    CORE_ASSERT(fish_swims(fish));
    CORE_ASSERT(around->dt_s > 0.0f);
    fish->thought_tick = (uint8_t)around->tick;
    fish->falls = swim_fall(fish);
    if (fish->falls) {
        escape_dash(fish, index, around);
        fish->depth_goal_m = -0.6f * around->size_m.y;
        return;
    }
    /* A moving poi (paper scoop) moves the fish in two ways: the flow of the water around the poi
     * carries the fish along, and the fish steps aside. */
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        const struct obstacle *disc = &around->obstacles[i];
        const vec3 aside_m_s = obstacle_sidestep_m_s(disc, fish->position_m);
        const vec3 drift_m_s =
            v3_scale(water_flow_m_s(disc, fish->position_m), around->params->flow_share);
        fish->push_m_s =
            v3_muladd(fish->push_m_s, v3_add(aside_m_s, drift_m_s), PUSH_PER_S * around->dt_s);
    }
    startle_tick(fish, index, around);
    gait_tick(fish, index, around);
    gait_cycle_turn(fish, index, around);
    behavior_wall_follow(fish, around);
    avoidance(fish, around);
    if (fish->gait == GAIT_ESCAPE) {
        escape_tick(fish, around);
    }
    swim_resolve(fish, around);
    follow_shade(fish, around);
}

/* ---- Attraction of walls --------------------------------------------------------------------- */

#define FALL_OFF_M 0.09f /* Distance over which the attraction of a wall falls to 1 / e. */
/* Distance from a wall, in body lengths, within which the wall no longer attracts the fish. */
#define BESIDE_LENGTHS 0.8f
/* Largest turning rate, rad/s, that the attraction of a wall causes. A fish turns at this rate if
 * it is at the wall, its heading is perpendicular to the direction of the attraction, and
 * `wall_follow` is 1. */
#define TURN_PER_S 6.0f

float behavior_wall_pull(float gap_m, float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const float off_m = gap_m - BESIDE_LENGTHS * length_m;
    return off_m <= 0.0f || gap_m > WALL_RANGE_M ? 0.0f : f_exp(-off_m / FALL_OFF_M);
}

void behavior_wall_follow(struct fish *fish, const struct perception *around)
{
    if (around->wall_follow <= 0.0f || (fish->gait != GAIT_SWIM && fish->gait != GAIT_BURST)) {
        return;
    }
    /* `x` and `z` are the attractions of the walls along the horizontal axes. The attractions of
     * two opposite walls are subtracted. */
    const float length_m = fish->length_m;
    const vec3 half_m = v3_scale(around->size_m, 0.5f), at_m = fish->position_m;
    const float x = behavior_wall_pull(half_m.x - at_m.x, length_m) -
                    behavior_wall_pull(half_m.x + at_m.x, length_m);
    const float z = behavior_wall_pull(half_m.z - at_m.z, length_m) -
                    behavior_wall_pull(half_m.z + at_m.z, length_m);
    /* Only the component of the attraction perpendicular to the heading turns the fish. */
    const float s = f_sin(fish->heading_rad), c = f_cos(fish->heading_rad);
    const float left = -x * c + z * s;
    fish->heading_rad += around->wall_follow * TURN_PER_S * left * around->dt_s;
}
