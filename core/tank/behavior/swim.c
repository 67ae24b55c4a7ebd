/* swim.c -- computes the goals that a fish follows until its next decision. The fish approaches
 * every goal at a bounded rate, so that every path is a smooth arc. */
#include "core/tank/behavior/swim.h"

#include "core/base/panic.h"
#include "core/tank/behavior/avoid.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/behavior/swim_simd.h"

/* Largest yaw rate in each gait (design values; the 2013 thesis on goldfish behavior gives
 * none). */
#define TURN_RATE_REST (45.0f * F_DEG)
#define TURN_RATE_SWIM (180.0f * F_DEG)
#define TURN_RATE_KICK (500.0f * F_DEG)
#define TURN_RATE_BURST (720.0f * F_DEG)
#define TURN_RATE_ESCAPE (1500.0f * F_DEG)
/* Largest yaw rate in a C-start (escape), in which the head turns by 60 to 120 degrees in 20 ms. */
#define TURN_RATE_START (4500.0f * F_DEG)

#define NOTHING_M_S 1e-9f
#define SHUN_TAU_S 0.05f

#define CLIMB_MAX_M_S 0.03f
#define CLIMB_GAIN_PER_S 0.6f
#define PITCH_MAX (24.0f * F_DEG)
/* Value of `haste` (fish.h) in a dash, the fast swimming after a C-start. With this value a fish
 * reaches its full turning rate after 15 ms. */
#define DASH_HASTE 8.0f
/* Time constant of the acceleration in an escape. The fish reaches full speed much earlier than a
 * swimming fish. */
#define START_TAU_S 0.03f
#define DASH_OUT_TAU_S 0.25f
/* Time constant with which a fish slows down from burst speed to swimming speed. */
#define RUN_OUT_TAU_S 0.20f

/* Returns exp(-dt_s / tau_s): the fraction of a difference that remains after `dt_s` if the
 * difference decays with the time constant `tau_s`. The error is below 1e-4 for `dt_s` up to
 * `tau_s`. */
static float decay_fraction(float dt_s, float tau_s)
{
    const float x = f_min(1.0f, dt_s / tau_s), even = 1.0f + x * x * (1.0f / 12.0f);
    return (even - 0.5f * x) / (even + 0.5f * x);
}

void swim_avoid_add(struct swim_avoidance *avoidance, const struct fish *fish,
                    const struct behavior_params *params, vec3 normal, float gap_m)
{
    const float range_m = (params->wall_per_length + 0.05f) * fish->length_m +
                          params->wall_within_s * fish->speed_m_s;
    const float free_m = gap_m - 0.45f * fish->length_m;
    if (free_m >= range_m) {
        return;
    }
    const float weight = 1.0f - f_max(free_m / range_m, 0.0f);
    avoidance->into = v3_muladd(avoidance->into, normal, weight);
    avoidance->weight = f_max(avoidance->weight, weight);
}

void swim_avoid_walls(struct swim_avoidance *avoidance, const struct fish *fish,
                      const struct behavior_params *params, vec3 size_m)
{
    const vec3 p = fish->position_m;
    const float near_x = 0.5f * size_m.x - f_abs(p.x), near_z = 0.5f * size_m.z - f_abs(p.z);
    swim_avoid_add(avoidance, fish, params, v3(p.x < 0.0f ? -1.0f : 1.0f, 0.0f, 0.0f), near_x);
    swim_avoid_add(avoidance, fish, params, v3(0.0f, 0.0f, p.z < 0.0f ? -1.0f : 1.0f), near_z);
}

/* Turns the heading away from near walls and bowls. The component of the heading that points into
 * the wall or bowl decreases until the heading points slightly away from the wall or bowl. */
void swim_avoid_turn(struct fish *fish, const struct swim_avoidance *avoidance, float dt_s)
{
    CORE_ASSERT(dt_s > 0.0f);
    if (avoidance->weight <= 0.0f) {
        return;
    }
    const vec3 normal = v3_normalize_or(avoidance->into, v3(1.0f, 0.0f, 0.0f));
    const float x = -f_sin(fish->heading_rad), z = -f_cos(fish->heading_rad);
    const float into = x * normal.x + z * normal.z;
    const float along = x * -normal.z + z * normal.x;
    if (into < -0.15f) {
        return;
    }
    /* A fish that swims straight toward the wall or bowl turns to a side that is fixed for each
     * fish. */
    const float own_side = fish->look & 1u ? 1.0f : -1.0f;
    const float side = f_abs(along) > 0.05f ? (along > 0.0f ? 1.0f : -1.0f) : own_side;
    const float new_into = into - (into + 0.15f) * avoidance->weight;
    const float new_along = along + side * avoidance->weight * 0.5f * f_max(into, 0.0f);
    const float gx = new_into * normal.x - new_along * normal.z;
    const float gz = new_into * normal.z + new_along * normal.x;
    const float off_rad = f_wrap_angle(f_atan2(-gx, -gz) - fish->heading_rad);
    fish->heading_rad =
        f_wrap_angle(fish->heading_rad + (1.0f - decay_fraction(dt_s, SHUN_TAU_S)) * off_rad);
}

/* Returns true if the fish turns at the full rate of a C-start (escape). The turn is slower after
 * the C-start, and while other fish are close beside the fish. */
static bool turns_at_full_rate(const struct fish *fish)
{
    return fish->room >= 1.0f && escape_on_path(fish);
}

/* Returns true if the fish turns at the full rate of a kick, the fast turn at the beginning of a
 * tail beat. The turn is slower while other fish are close beside the fish, so that they can move
 * away. */
static bool kicks(const struct fish *fish, const struct perception *around)
{
    return around->params->kick_rad > 0.0f && fish->gait == GAIT_SWIM &&
           fish->avoiding == AVOID_NONE && fish->room >= 1.0f &&
           gait_cycle_kicks(fish, around->tick);
}

static float turn_rate_limit_rad_s(const struct fish *fish, const struct perception *around)
{
    switch (fish->gait) {
    case GAIT_ESCAPE:
        return turns_at_full_rate(fish) ? TURN_RATE_START : TURN_RATE_ESCAPE;
    case GAIT_BURST:
        return TURN_RATE_BURST;
    case GAIT_SWIM:
        return kicks(fish, around) ? TURN_RATE_KICK : TURN_RATE_SWIM;
    default:
        return TURN_RATE_REST;
    }
}

/* Returns the factor [0, 1) by which one tick multiplies the difference between the speed and a
 * higher speed goal. A larger factor means slower acceleration. Except in an escape, the factor
 * depends only on the length of the fish, so it is computed once and stored in struct fish. */
static float speed_up_factor(const struct fish *fish)
{
    const float start_keep = decay_fraction(DT, START_TAU_S);
    if (fish->gait == GAIT_ESCAPE) {
        return start_keep;
    }
    const bool known = fish->speed_up_keep > 0.0f && fish->speed_up_keep != start_keep;
    return known ? fish->speed_up_keep : decay_fraction(DT, gait_run_up_s(fish->length_m));
}

/* Returns the factor [0, 1) by which one tick multiplies the difference between the speed and a
 * lower speed goal. A larger factor means slower deceleration. */
static float slow_down_factor(const struct fish *fish, const struct behavior_params *params)
{
    if (fish->gait == GAIT_ESCAPE) {
        return decay_fraction(DT, DASH_OUT_TAU_S);
    }
    const bool runs_out =
        fish->gait == GAIT_SWIM && fish->speed_m_s > gait_speed_max_m_s(fish, params);
    /* In a glide, drag changes the speed v by dv/dt = -v^2 / D. D is gait_glide_m(), the distance
     * of a glide in which the speed falls to 1/e. */
    if (params->glides && fish->gait == GAIT_SWIM && !runs_out) {
        return decay_fraction(DT, gait_glide_m(fish->length_m) / f_max(fish->speed_m_s, 1e-3f));
    }
    return runs_out ? decay_fraction(DT, RUN_OUT_TAU_S) : decay_fraction(DT, SWIM_GLIDE_TAU_S);
}

void swim_resolve(struct fish *fish, const struct perception *around)
{
    CORE_ASSERT(fish->gait < GAIT_COUNT);
    /* Sets tiny speeds and pushes to zero. A value that decays forever becomes a denormal number.
     * Processors take ten times as long for denormal numbers, and some processors flush them to
     * zero. With the limit of one nanometre per second all platforms compute zero. */
    if (v3_dot(fish->push_m_s, fish->push_m_s) < NOTHING_M_S * NOTHING_M_S) {
        fish->push_m_s = v3(0.0f, 0.0f, 0.0f);
    }
    if (fish->speed_m_s < NOTHING_M_S) {
        fish->speed_m_s = 0.0f;
    }
    if (f_abs(fish->climb_m_s) < NOTHING_M_S) {
        fish->climb_m_s = 0.0f;
    }
    const bool starts = fish->gait == GAIT_ESCAPE;
    fish->beats = gait_beats(fish, around) ? 1.0f : 0.0f;
    fish->speed_goal_m_s = gait_speed_m_s(fish, around);
    fish->speed_up_keep = speed_up_factor(fish);
    fish->slow_keep = slow_down_factor(fish, around->params);
    fish->turn_rate_max_rad_s = turn_rate_limit_rad_s(fish, around);
    fish->haste = turns_at_full_rate(fish)      ? HASTE_START
                  : starts                      ? DASH_HASTE
                  : fish->avoiding == AVOID_YAW ? around->params->swerve_haste
                  : kicks(fish, around)         ? GAIT_KICK_HASTE
                                                : 1.0f;
    const float off_m = fish->depth_goal_m - fish->position_m.y;
    const float able_m_s = fish->gait == GAIT_REST ? 0.4f * CLIMB_MAX_M_S : CLIMB_MAX_M_S;
    fish->climb_goal_m_s = fish->avoiding == AVOID_PITCH ? fish->avoid_turn * CLIMB_MAX_M_S
                           : avoid_holds_depth(fish)
                               ? 0.0f
                               : f_clamp(CLIMB_GAIN_PER_S * off_m, -able_m_s, able_m_s);
    /* The pitch follows the direction of the path. The constant that is added to the speed keeps a
     * slow fish nearly level. */
    const float pitch_rad = f_atan2(fish->climb_m_s, fish->speed_m_s + 0.035f);
    fish->pitch_goal_rad = f_clamp(pitch_rad, -PITCH_MAX, PITCH_MAX);
    if (starts) { /* A fish in an escape does not brake. */
        fish->brake = 1.0f;
    } else { /* Removes the bend that a C-start (escape) leaves if it ends early, for example
              * because a poi (paper scoop) lifts the fish. */
        fish->bend_goal_rad = 0.0f;
    }
    surface_resolve(fish, around);
}

void swim_resolve_drawn(struct fish *fish, float speed_goal_m_s)
{
    CORE_ASSERT(speed_goal_m_s >= 0.0f);
    fish->beats = speed_goal_m_s > fish->speed_m_s ? 1.0f : 0.0f;
    fish->speed_goal_m_s = speed_goal_m_s;
    fish->turn_rate_max_rad_s = f_max(fish->turn_rate_max_rad_s, TURN_RATE_SWIM);
}
