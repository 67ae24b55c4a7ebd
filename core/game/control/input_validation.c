/* input_validation.c -- the checks that detect invalid or lost input. */
#include "core/game/control/input_validation.h"

#include "core/base/fmath.h"
#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/vec.h"

/* Tolerance of the jump test, because reports arrive at uneven intervals. A motion at 3 m/s with
 * one missing report exceeds the limit by 3.4 cm. */
#define ARM_LEAP_M 0.035f
#define POINTER_LEAP_M 0.30f
/* Speed limit for the tips of the pose's unit axes, per second. The value equals rad/s for small
 * rotations. */
#define WRIST_PER_S 40.0f
/* Tolerance of the rotation test; with WRIST_PER_S, 36 degrees in one tick. */
#define LEAP_TURN 0.3f
#define CREDIT_KEEP 0.95f

static int is_within_limit(float value, float limit)
{
    CORE_ASSERT(limit > 0.0f);
    return f_is_finite(value) && f_abs(value) <= limit;
}

int input_pose_is_finite(const struct poi_target *target)
{
    return is_within_limit(target->position_m.x, INPUT_RANGE_M_MAX) &&
           is_within_limit(target->position_m.y, INPUT_RANGE_M_MAX) &&
           is_within_limit(target->position_m.z, INPUT_RANGE_M_MAX) &&
           is_within_limit(target->angles.yaw_rad, INPUT_ANGLE_RAD_MAX) &&
           is_within_limit(target->angles.pitch_rad, INPUT_ANGLE_RAD_MAX) &&
           is_within_limit(target->angles.roll_rad, INPUT_ANGLE_RAD_MAX);
}

float input_turn(struct angles from, struct angles to)
{
    const struct basis a = vec_basis_from_angles(from), b = vec_basis_from_angles(to);
    return f_max(v3_length(v3_sub(a.up, b.up)), v3_length(v3_sub(a.back, b.back)));
}

int input_pose_is_jump(const struct poi_target *from, const struct poi_target *to, float seconds,
                       int has_wrist)
{
    CORE_ASSERT(seconds >= 0.0f);
    const float pace_m_s = has_wrist ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX;
    const float way_m = v3_length(v3_sub(to->position_m, from->position_m));
    return way_m > pace_m_s * seconds + (has_wrist ? ARM_LEAP_M : POINTER_LEAP_M) ||
           input_turn(from->angles, to->angles) > WRIST_PER_S * seconds + LEAP_TURN;
}

/* Adds the motion `step` to the sum `before`, less the motion `free` that is allowed per tick. A
 * negative result is motion that is still allowed because reports were missing. The negative part
 * decays within the frame in which the pose catches up. */
static float excess_motion_sum(float before, float step, float free)
{
    CORE_ASSERT(free >= 0.0f);
    const float sum = before + step - free;
    return sum >= 0.0f ? sum : CREDIT_KEEP * f_min(before + step, 0.0f);
}

/* Updates the sums of excess motion and rotation. Returns 1 if the pose of a controller with
 * rotation jumps, otherwise 0. */
static int detect_pose_jump(struct input_validation *validation, const struct poi_input *input)
{
    CORE_ASSERT(validation->knows);
    const float pace = input->has_wrist ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX;
    const float leap_m = input->has_wrist ? ARM_LEAP_M : POINTER_LEAP_M;
    const float unseen_s = (float)validation->silent_ticks * CORE_TICK_S;
    const vec3 way_m = v3_sub(input->target.position_m, validation->newest.position_m);
    const float turn = input_turn(validation->newest.angles, input->target.angles);
    if (unseen_s > 0.0f) {
        validation->excess_m = f_min(validation->excess_m, -pace * unseen_s);
        validation->spin = f_min(validation->spin, -WRIST_PER_S * unseen_s);
    }
    validation->excess_m =
        excess_motion_sum(validation->excess_m, v3_length(way_m), pace * CORE_TICK_S);
    validation->spin = excess_motion_sum(validation->spin, turn, WRIST_PER_S * CORE_TICK_S);
    const int is_jump = validation->excess_m > leap_m || validation->spin > LEAP_TURN;
    if (is_jump) {
        validation->excess_m = validation->spin =
            0.0f; /* The sums restart at the new pose, because the sensor may stay there. */
    }
    return is_jump && input->has_wrist;
}

static uint16_t next_count(int continues, uint16_t count, uint16_t most)
{
    return !continues ? 0u : count < most ? (uint16_t)(count + 1u) : most;
}

/* Returns 1 if the current input is consistent with the earlier input, otherwise 0. The tests for a
 * frozen sensor and for a jump both run in every tick, because each test updates counters. */
static int agrees(struct input_validation *validation, const struct poi_input *input)
{
    int is_sane = 1;
    if (input->link != POI_SOURCE_LIVE || !input_pose_is_finite(&input->target)) {
        return 0;
    }
    if (validation->knows) {
        const int same = memcmp(&validation->newest, &input->target, sizeof input->target) == 0;
        validation->same_ticks = next_count(same, validation->same_ticks, UINT16_MAX);
        is_sane = !detect_pose_jump(validation, input) &&
                  !(input->trembles && validation->same_ticks > INPUT_STUCK_TICKS);
    }
    validation->knows = 1;
    validation->newest = input->target;
    return is_sane && input->age_ticks <= INPUT_SILENT_TICKS;
}

float input_validation_blend(const struct input_validation *validation)
{
    return validation->late_ticks > 1 ? 1.0f / (float)validation->late_ticks : 1.0f;
}

/* The motion that was missed while reports were late is replayed in three quarters of the missed
 * time. The replay follows a straight line, which is shorter than the actual path. A replay in the
 * full time would therefore be slower and wear the paper less. */
enum input_status input_validation_tick(struct input_validation *validation,
                                        const struct poi_input *input)
{
    if (input->link == POI_SOURCE_ABSENT || input->link == POI_SOURCE_BOT) {
        *validation = (struct input_validation){ .verdict = INPUT_ABSENT };
        return INPUT_ABSENT;
    }
    const int was_lost = validation->verdict == INPUT_LOST;
    const uint16_t before = validation->silent_ticks;
    const int agreed = agrees(validation, input);
    if (input->age_ticks < before && before <= INPUT_SILENT_TICKS) {
        validation->late_ticks = (uint16_t)(3u * (before + 1u) / 4u);
    } else if (validation->late_ticks > 0) {
        validation->late_ticks--;
    }
    validation->silent_ticks = input->age_ticks >= INPUT_LATE_TICKS ? input->age_ticks : 0u;
    validation->agree_ticks = next_count(agreed, validation->agree_ticks, INPUT_AGREE_TICKS);
    const int lost = !agreed || (was_lost && validation->agree_ticks < INPUT_AGREE_TICKS);
    validation->verdict = lost ? INPUT_LOST : INPUT_VALID;
    CORE_ASSERT(lost || validation->knows);
    return (enum input_status)validation->verdict;
}

uint64_t input_pose_hash(uint64_t hash, const struct poi_target *pose)
{
    const struct angles *angles = &pose->angles;
    hash = hash_vec3(hash, pose->position_m);
    return hash_vec3(hash, v3(angles->yaw_rad, angles->pitch_rad, angles->roll_rad));
}

uint64_t input_validation_hash(uint64_t hash, const struct input_validation *validation)
{
    const uint32_t words[] = { validation->verdict,      validation->knows,
                               validation->same_ticks,   validation->agree_ticks,
                               validation->silent_ticks, validation->late_ticks };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    hash = hash_float(hash_float(hash, validation->excess_m), validation->spin);
    return input_pose_hash(hash, &validation->newest);
}
