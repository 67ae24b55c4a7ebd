/* escape.c -- computes the C-start, the fast escape response of a startled fish: the turn, the bend
 * and the thrust as functions of time. */
#include "core/tank/behavior/startle.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/input.h"

/* Duration of each of the two stages of a C-start, for a fish of the length STAGE_LENGTH_M. In
 * stage 1 the fish bends into a C, and in stage 2 its tail flips back. The duration is proportional
 * to the square root of the fish's length. escape_stage_s() rounds the duration to whole ticks, so
 * that the deepest bend of the body falls on a tick. */
#define STAGE_S 0.020f
#define STAGE_LENGTH_M 0.05f

#define TURN_MIN_RAD (60.0f * F_DEG)
#define TURN_MAX_RAD (120.0f * F_DEG)
#define STRAY_RAD (45.0f * F_DEG)
/* Angle between the direction away from a danger and the final course of a fish that first turned
 * toward the danger. With this angle the fish swims past the danger. */
#define PAST_RAD (100.0f * F_DEG)
/* Largest angle by which the flip of the tail (stage 2 of a C-start) turns the fish in the
 * direction opposite to the first turn (stage 1). */
#define FLIP_BACK_RAD (45.0f * F_DEG)
/* Value that replaces FLIP_BACK_RAD if a wall is near in the direction away from the danger. */
#define FLIP_BARRED_RAD (110.0f * F_DEG)
/* Largest angle by which the flip of the tail (stage 2 of a C-start) turns the fish farther in the
 * direction of the first turn (stage 1). */
#define FLIP_ON_RAD (90.0f * F_DEG)

/* Probability that a fish in a C-start (escape response) first turns away from the danger in open
 * water (Mirjany et al. 2011). Otherwise the fish first turns toward the danger. */
#define AWAY_CHANCE 0.77f
/* Probability (design value) that a fish in a C-start first turns away from the danger if a wall is
 * near in the direction away from the danger. */
#define AWAY_CHANCE_WALL 0.45f
/* Distance to a wall, in body lengths, below which the wall blocks the way of an escaping fish. */
#define WALL_FELT_LENGTHS 2.0f

/* BEND_PER_TURN is the bend of the body into a C divided by the angle by which the head turns.
 * HEAD_SHARE is the fraction of the body's curve that lies in front of the pivot of the bend
 * (assets/shaders/fish.vert.glsl). */
#define BEND_PER_TURN 1.3f
#define HEAD_SHARE 0.38f
/* Recoil of the body after the flip of the tail: the fish bends to the other side by this fraction
 * of the C-bend. */
#define RECOIL 0.4f
/* Duration of the recoil (the bend after the flip of stage 2), as a multiple of the duration of a
 * stage. */
#define RECOIL_STAGES 2.0f

/* Lowest and highest peak speed of individual fish during a C-start (escape), in body lengths per
 * second. */
#define PEAK_LENGTHS_MIN 8.0f
#define PEAK_LENGTHS_MAX 10.0f
/* Time from the beginning of a C-start (escape) to the end of its thrust. */
#define PEAK_TIME_S 0.12f
/* Speed goal of an escaping fish after the thrust of its C-start, in body lengths per second. */
#define DASH_LENGTHS 2.0f
#define DASH_BEAT_MIN_S 0.70f
#define DASH_SPREAD_S 0.08f
/* Stamina that a C-start (escape) costs a fish. The cost equals that of one second of GAIT_BURST
 * (BURST_COST_PER_S in gait.c). */
#define COST 0.010f
#define REFRACTORY_S 0.5f /* Time after an escape in which the fish cannot begin another C-start. */

float escape_stage_s(float length_m)
{
    const float stage_s = STAGE_S * f_sqrt(length_m / STAGE_LENGTH_M);
    return CORE_TICK_S * f_max(1.0f, f_floor(stage_s * (float)CORE_TICK_HZ + 0.5f));
}

/* Returns true if the time since the beginning of the C-start is below `end_s`. The comparison
 * has a tolerance of half a tick, because times are rounded sums of ticks. */
static bool is_escape_before(const struct fish *fish, float end_s)
{
    return fish->escape_s < end_s - 0.5f * CORE_TICK_S;
}

enum escape_stage escape_stage(const struct fish *fish)
{
    const float stage_s = escape_stage_s(fish->length_m);
    return fish->gait != GAIT_ESCAPE                ? ESCAPE_NONE
           : is_escape_before(fish, stage_s)        ? ESCAPE_BEND
           : is_escape_before(fish, 2.0f * stage_s) ? ESCAPE_FLIP
                                                    : ESCAPE_DASH;
}

bool escape_on_path(const struct fish *fish)
{
    const float end_s = (2.0f + RECOIL_STAGES) * escape_stage_s(fish->length_m);
    return fish->gait == GAIT_ESCAPE && is_escape_before(fish, end_s);
}

/* Returns how far a fish can swim along its course until it reaches a wall, m. The function handles
 * one horizontal axis and the two walls perpendicular to that axis. `at_m` is the coordinate of the
 * fish on the axis, `course` the component of the course's unit vector, and `half_m` the distance
 * of both walls from the origin. */
static float room_m(float at_m, float course, float half_m)
{
    CORE_ASSERT(half_m > 0.0f);
    const float gap_m = course > 0.0f ? half_m - at_m : half_m + at_m;
    return f_abs(course) > 1e-3f ? f_max(gap_m, 0.0f) / f_abs(course) : 1e3f;
}

static void enter_escape_gait(struct fish *fish, uint32_t index, const struct perception *around)
{
    fish->gait = GAIT_ESCAPE;
    fish->air = AIR_ENOUGH;
    fish->gait_left_s =
        DASH_BEAT_MIN_S +
        rng_range(perception_key(around, index, RNG_ESCAPE_DURATION), 0.0f, DASH_SPREAD_S);
    fish->refractory_s = fish->gait_left_s + REFRACTORY_S;
    fish->avoiding = AVOID_NONE;
    fish->avoid_left_s = 0.0f;
    fish->startle = 0;
    fish->startle_s = 0.0f;
    fish->drawn_rad = 0.0f; /* A startled fish is no longer attracted by shades. */
    fish->bend_goal_rad = 0.0f;
}

void escape_start(struct fish *fish, vec3 from_m, uint32_t index, const struct perception *around)
{
    CORE_ASSERT(v3_is_finite(from_m));
    CORE_ASSERT(around->dt_s > 0.0f);
    enter_escape_gait(fish, index, around);
    /* The side and the angle of the first turn, and the final course of the C-start, are random. */
    const float yaw_rad = fish->angles.yaw_rad;
    const vec3 off = v3_sub(fish->position_m, from_m);
    const float away_rad = f_wrap_angle(f_atan2(-off.x, -off.z) - yaw_rad);
    const vec3 course = v3_heading(yaw_rad + away_rad);
    const float open = f_min(room_m(fish->position_m.x, course.x, 0.5f * around->size_m.x),
                             room_m(fish->position_m.z, course.z, 0.5f * around->size_m.z)) /
                       (WALL_FELT_LENGTHS * fish->length_m);
    const float chance = f_lerp(AWAY_CHANCE_WALL, AWAY_CHANCE, f_clamp(open, 0.0f, 1.0f));
    const bool toward = rng_unit(perception_key(around, index, RNG_FISH_ESCAPE)) >= chance;
    const float side = (away_rad < 0.0f ? -1.0f : 1.0f) * (toward ? -1.0f : 1.0f);
    const float turn_rad = side * rng_range(perception_key(around, index, RNG_ESCAPE_TURN),
                                            TURN_MIN_RAD, TURN_MAX_RAD);
    const float stray_rad =
        rng_range(perception_key(around, index, RNG_ESCAPE_STRAY), -STRAY_RAD, STRAY_RAD);
    float goal_rad = away_rad + stray_rad;
    if (toward) { /* A fish that first turned toward the danger swims past the danger, to the left
                     or to the right. The fish chooses the course that is nearer to its first
                     turn. */
        const float left_rad = away_rad + PAST_RAD, right_rad = away_rad - PAST_RAD;
        goal_rad =
            f_abs(f_wrap_angle(left_rad - turn_rad)) < f_abs(f_wrap_angle(right_rad - turn_rad))
                ? left_rad
                : right_rad;
    }
    /* If a wall blocks the final course, the fish swims along the wall and slightly away from the
     * wall. */
    const float felt_m = WALL_FELT_LENGTHS * fish->length_m;
    vec3 last = v3_heading(yaw_rad + goal_rad);
    if (room_m(fish->position_m.x, last.x, 0.5f * around->size_m.x) < felt_m) {
        last.x *= -0.3f;
    }
    if (room_m(fish->position_m.z, last.z, 0.5f * around->size_m.z) < felt_m) {
        last.z *= -0.3f;
    }
    const float course_rad = f_atan2(-last.x, -last.z) - yaw_rad;
    const float rest_rad = side * f_wrap_angle(course_rad - turn_rad);
    fish->escape_from_rad = yaw_rad;
    fish->escape_turn_rad = turn_rad;
    const float back_rad = open < 1.0f ? FLIP_BARRED_RAD : FLIP_BACK_RAD;
    fish->escape_course_rad = turn_rad + side * f_clamp(rest_rad, -back_rad, FLIP_ON_RAD);
    fish->escape_s = -around->dt_s; /* escape_tick() adds `dt_s`, so the negative value makes the
                                       C-start begin at time 0 in the next tick. */
    fish->stamina = f_max(0.0f, fish->stamina - COST);
}

void escape_dash(struct fish *fish, uint32_t index, const struct perception *around)
{
    enter_escape_gait(fish, index, around);
    fish->escape_s = (2.0f + RECOIL_STAGES) * escape_stage_s(fish->length_m);
    fish->escape_from_rad = fish->angles.yaw_rad;
    fish->escape_turn_rad = fish->escape_course_rad = 0.0f;
    fish->heading_rad = fish->angles.yaw_rad;
}

static float peak_m_s(const struct fish *fish)
{
    CORE_ASSERT(fish->stamina >= 0.0f && fish->stamina <= 1.0f);
    const float keen = (float)(fish->look >> 22 & 255u) / 255.0f;
    return fish->length_m * (0.8f + 0.2f * fish->stamina) *
           f_lerp(PEAK_LENGTHS_MIN, PEAK_LENGTHS_MAX, keen);
}

void escape_tick(struct fish *fish, const struct perception *around)
{
    CORE_ASSERT(fish->gait == GAIT_ESCAPE);
    CORE_ASSERT(around->dt_s > 0.0f);
    fish->escape_s += around->dt_s;
    const float stages = (fish->escape_s + around->dt_s) / escape_stage_s(fish->length_m);
    const float bent = f_clamp(stages, 0.0f, 1.0f);
    const float flipped = f_clamp(stages - 1.0f, 0.0f, 1.0f);
    const float recoiled = f_clamp((stages - 2.0f) / RECOIL_STAGES, 0.0f, 1.0f);
    if (!escape_on_path(fish)) { /* The prescribed turn of the C-start has ended. From now on walls
                                    may change the course of the fish again. */
        fish->bend_goal_rad = 0.0f;
        return;
    }
    const float curve_rad = BEND_PER_TURN * fish->escape_turn_rad;
    const float bend_yaw_rad = fish->escape_turn_rad - HEAD_SHARE * curve_rad;
    const float yaw_rad = f_lerp(bent * bend_yaw_rad, fish->escape_course_rad, flipped);
    fish->heading_rad = f_wrap_angle(fish->escape_from_rad + yaw_rad);
    fish->bend_goal_rad = -curve_rad * (bent - (1.0f + RECOIL) * flipped + RECOIL * recoiled);
    fish->speed_m_s = f_max(fish->speed_m_s, flipped * peak_m_s(fish));
}

float escape_speed_m_s(const struct fish *fish)
{
    return escape_stage(fish) != ESCAPE_DASH     ? fish->speed_m_s
           : is_escape_before(fish, PEAK_TIME_S) ? peak_m_s(fish)
                                                 : DASH_LENGTHS * fish->length_m;
}

bool escape_beats(const struct fish *fish)
{
    return !is_escape_before(fish, escape_stage_s(fish->length_m)) &&
           is_escape_before(fish, PEAK_TIME_S);
}
