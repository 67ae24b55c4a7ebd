/* fish_behavior.c -- the decision of a fish. A fish senses, avoids and chooses goals in order of
 * urgency.
 *
 * The attraction of walls turns headings, so that a wandering fish drifts to the walls and then
 * swims along them. With the constants in this file, the density of a single fish falls to 1 / e
 * within 7 cm of a wall (test_wall_following.c). */
#include "core/tank/behavior/fish_behavior.h"

#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/behavior/swim.h"
#include "core/tank/shade.h"
#include "core/tank/water.h"

/* Time constant with which `drawn_rad` follows the attraction of a shade. The delay keeps a fish
 * from turning at every small change of the attraction. */
#define DRAWN_TAU_S 0.5f
/* Decay rate of `push_m_s`, the velocity that the flow around a poi and the sidestep add to a fish.
 * Each decision adds their velocity multiplied by this rate. Therefore a constant push moves the
 * fish at exactly the speed of the push. */
#define PUSH_PER_S 12.0f
/* Vertical distance between the fish's back and the bottom of a bowl. A fish that is deeper than
 * the bottom by at least this distance does not turn away from the bowl. */
#define HULL_SHUN_DEPTH_M 0.01f

int fish_behavior_is_due(const struct fish *fish, uint32_t index, const struct perception *around)
{
    if ((index + around->tick) % FISH_BEHAVIOR_TICKS == 0 || fish->gait == GAIT_ESCAPE ||
        fish->falls || fish->position_m.y > -0.5f * fish->width_m) {
        return 1;
    }
    return startle_alert(fish, around);
}

float fish_behavior_dt_s(const struct fish *fish, uint32_t tick)
{
    /* Ticks since the last decision, modulo 256. The limit FISH_BEHAVIOR_TICKS applies to a fish
     * that did not decide for a long time, because a poi or bowl carried it. */
    const uint32_t ticks = (uint8_t)(tick - fish->thought_tick);
    return CORE_TICK_S * f_clamp((float)ticks, 1.0f, (float)FISH_BEHAVIOR_TICKS);
}

static void shun_bowl(struct swim_avoidance *avoidance, const struct fish *fish,
                      const struct behavior_params *params, const struct obstacle *bowl)
{
    CORE_ASSERT(bowl->kind == OBSTACLE_BOWL);
    const float half_m = 0.5f * fish->height_m;
    const float bottom_m = bowl->centre_m.y - bowl->depth_m;
    if (fish->position_m.y + half_m < bottom_m - HULL_SHUN_DEPTH_M) {
        return;
    }
    const vec3 to =
        v3(bowl->centre_m.x - fish->position_m.x, 0.0f, bowl->centre_m.z - fish->position_m.z);
    const vec3 normal = v3_normalize_or(to, v3(1.0f, 0.0f, 0.0f));
    swim_avoid_add(avoidance, fish, params, normal, v3_length(to) - bowl->radius_m);
}

/* Turns the fish away from walls and bowls. */
static void avoidance(struct fish *fish, const struct perception *around)
{
    struct swim_avoidance all = { 0 };
    swim_avoid_walls(&all, fish, around->params, around->size_m);
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        if (around->obstacles[i].kind == OBSTACLE_BOWL) {
            shun_bowl(&all, fish, around->params, &around->obstacles[i]);
        }
    }
    swim_avoid_turn(fish, &all, around->dt_s);
}

/* Changes the goals of the fish by the attraction of shades. A fish that avoids another fish by yaw
 * keeps its heading and changes only its speed. */
static void follow_shade(struct fish *fish, const struct perception *around)
{
    const int glides = fish->gait == GAIT_SWIM && fish->beats <= 0.0f;
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
    fish->falls = (uint8_t)swim_fall(fish);
    if (fish->falls) {
        escape_dash(fish, index, around);
        fish->depth_goal_m = -0.6f * around->size_m.y;
        return;
    }
    /* Pois affect the fish: the flow carries the fish, the fish steps aside, or the fish is
     * startled. */
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
/* Turning rate of a fish at a wall, rad/s, if its heading is perpendicular to the attraction and
 * `wall_follow` is 1. */
#define TURN_PER_S 6.0f

float behavior_wall_pull(float gap_m, float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const float off_m = gap_m - BESIDE_LENGTHS * length_m;
    return off_m <= 0.0f || gap_m > WALL_RANGE_M ? 0.0f : f_exp(-off_m / FALL_OFF_M);
}

/* Returns the sum of the attractions of both walls of one axis. A result > 0 points in the positive
 * direction of the axis. */
static float pull_along(float at_m, float half_m, float length_m)
{
    return behavior_wall_pull(half_m - at_m, length_m) -
           behavior_wall_pull(half_m + at_m, length_m);
}

void behavior_wall_follow(struct fish *fish, const struct perception *around)
{
    if (around->wall_follow <= 0.0f || (fish->gait != GAIT_SWIM && fish->gait != GAIT_BURST)) {
        return;
    }
    const float length_m = fish->length_m;
    const float x = pull_along(fish->position_m.x, 0.5f * around->size_m.x, length_m);
    const float z = pull_along(fish->position_m.z, 0.5f * around->size_m.z, length_m);
    /* Only the component of the attraction perpendicular to the heading turns the fish. */
    const float s = f_sin(fish->heading_rad), c = f_cos(fish->heading_rad);
    const float left = -x * c + z * s;
    fish->heading_rad += around->wall_follow * TURN_PER_S * left * around->dt_s;
}
