/* input_validation.c -- the checks that detect invalid or lost input. */
#include "core/game/control/input_validation.h"

#include "core/base/fmath.h"
#include "core/base/hash.h"
#include "core/base/mem.h"
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

static float pace_m_s(int has_wrist)
{
    return has_wrist ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX;
}

static float leap_m(int has_wrist)
{
    return has_wrist ? ARM_LEAP_M : POINTER_LEAP_M;
}

int input_pose_is_jump(const struct poi_target *from, const struct poi_target *to, float seconds,
                       int has_wrist)
{
    const float way_m = v3_length(v3_sub(to->position_m, from->position_m));
    return way_m > pace_m_s(has_wrist) * seconds + leap_m(has_wrist) ||
           input_turn(from->angles, to->angles) > WRIST_PER_S * seconds + LEAP_TURN;
}

/* Adds the motion `step` to the sum `before`, less the motion `free` that is allowed per tick. A
 * negative result is motion that is still allowed because reports were missing. The negative part
 * decays within the frame in which the pose catches up. */
static float beyond(float before, float step, float free)
{
    const float sum = before + step - free;
    return sum >= 0.0f ? sum : CREDIT_KEEP * f_min(before + step, 0.0f);
}

static int leaps(struct input_validation *validation, const struct poi_input *input)
{
    const float pace = pace_m_s(input->has_wrist);
    const float unseen_s = (float)validation->silent_ticks * CORE_TICK_S;
    const vec3 way_m = v3_sub(input->target.position_m, validation->newest.position_m);
    const float turn = input_turn(validation->newest.angles, input->target.angles);
    validation->excess_m =
        f_min(validation->excess_m, unseen_s > 0.0f ? -pace * unseen_s : validation->excess_m);
    validation->spin =
        f_min(validation->spin, unseen_s > 0.0f ? -WRIST_PER_S * unseen_s : validation->spin);
    validation->excess_m = beyond(validation->excess_m, v3_length(way_m), pace * CORE_TICK_S);
    validation->spin = beyond(validation->spin, turn, WRIST_PER_S * CORE_TICK_S);
    const int leapt =
        validation->excess_m > leap_m(input->has_wrist) || validation->spin > LEAP_TURN;
    if (leapt) {
        validation->excess_m = validation->spin =
            0.0f; /* The sums restart at the new pose, because the sensor may stay there. */
    }
    return leapt && input->has_wrist;
}

static int is_stuck(struct input_validation *validation, const struct poi_input *input)
{
    const int same = memcmp(&validation->newest, &input->target, sizeof input->target) == 0;
    validation->same_ticks = same && validation->same_ticks < UINT16_MAX
                                 ? validation->same_ticks + 1u
                             : same ? UINT16_MAX
                                    : 0u;
    return input->trembles && validation->same_ticks > INPUT_STUCK_TICKS;
}

/* Returns 1 if the sensor is neither frozen nor jumping, otherwise 0. Both tests run in every tick,
 * because each test updates counters. */
static int goes_on(struct input_validation *validation, const struct poi_input *input)
{
    const int stuck = is_stuck(validation, input);
    const int leapt = leaps(validation, input);
    return !stuck && !leapt;
}

/* Returns 1 if the current input is consistent with the earlier input, otherwise 0. */
static int agrees(struct input_validation *validation, const struct poi_input *input)
{
    if (input->link != POI_SOURCE_LIVE || !input_pose_is_finite(&input->target)) {
        return 0;
    }
    const int is_sane = !validation->knows || goes_on(validation, input);
    validation->knows = 1;
    validation->newest = input->target;
    return is_sane && input->age_ticks <= INPUT_SILENT_TICKS;
}

/* Tracks late reports. The motion that was missed while reports were late is replayed in three
 * quarters of the missed time. The replay follows a straight line, which is shorter than the actual
 * path. A replay in the full time would therefore be slower and wear the paper less. */
static void count_late(struct input_validation *validation, const struct poi_input *input)
{
    const uint16_t before = validation->silent_ticks;
    const uint16_t now = input->age_ticks >= INPUT_LATE_TICKS ? input->age_ticks : 0u;
    if (input->age_ticks < before && before <= INPUT_SILENT_TICKS) {
        validation->late_ticks = (uint16_t)(3u * (before + 1u) / 4u);
    } else if (validation->late_ticks > 0) {
        validation->late_ticks--;
    }
    validation->silent_ticks = now;
}

float input_validation_blend(const struct input_validation *validation)
{
    return validation->late_ticks > 1 ? 1.0f / (float)validation->late_ticks : 1.0f;
}

enum input_status input_validation_tick(struct input_validation *validation,
                                        const struct poi_input *input)
{
    if (input->link == POI_SOURCE_ABSENT || input->link == POI_SOURCE_BOT) {
        *validation = (struct input_validation){ .verdict = INPUT_ABSENT };
        return INPUT_ABSENT;
    }
    const int was_lost = validation->verdict == INPUT_LOST;
    const int agreed = agrees(validation, input);
    count_late(validation, input);
    validation->agree_ticks = agreed && validation->agree_ticks < INPUT_AGREE_TICKS
                                  ? validation->agree_ticks + 1u
                              : agreed ? INPUT_AGREE_TICKS
                                       : 0u;
    const int lost = !agreed || (was_lost && validation->agree_ticks < INPUT_AGREE_TICKS);
    validation->verdict = lost ? INPUT_LOST : INPUT_VALID;
    return (enum input_status)validation->verdict;
}

uint64_t input_validation_hash(uint64_t hash, const struct input_validation *validation)
{
    hash = hash_u32(hash, validation->verdict);
    hash = hash_u32(hash, validation->knows);
    hash = hash_u32(hash, validation->same_ticks);
    hash = hash_u32(hash, validation->agree_ticks);
    hash = hash_u32(hash, validation->silent_ticks);
    hash = hash_u32(hash, validation->late_ticks);
    hash = hash_float(hash, validation->excess_m);
    hash = hash_float(hash, validation->spin);
    hash = hash_vec3(hash, validation->newest.position_m);
    return hash_vec3(hash,
                     v3(validation->newest.angles.yaw_rad, validation->newest.angles.pitch_rad,
                        validation->newest.angles.roll_rad));
}
