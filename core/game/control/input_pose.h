/* input_pose.h -- the checks and corrections of the pose that a controller reports: calibration and
 * input validation. The core uses no pose that these functions have not accepted.
 *
 * Calibration corrects the position over the tank and the tilt. Input validation detects lost,
 * frozen, late and implausible input. All state is in struct input_validation; the functions have
 * no other side effects. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/settings.h"

/* ---- Input validation --------------------------------------------------------------------------
 *
 * Broken cables, frozen sensors, flipped bits and late reports are expected. Input is lost while
 * the link is disconnected, a number is NaN or out of range, or reports are missing. Input is also
 * lost if a noisy sensor repeats identical bits, or if the pose jumps faster than an arm can move.
 *
 * Input becomes valid again after a quarter of a second of consistent reports. If a pose stays
 * after a jump, it is accepted as the new pose.
 *
 * If the kiosk was delayed, the motion during the delay was not observed. The new pose is then
 * accepted, and the poi moves slowly to it.
 *
 * A pointer is not limited by an arm and may jump, for example when it leaves and re-enters a
 * window. The poi of a pointer follows at a limited speed (controller.c). */

/* Age in ticks from which a controller's report is late. At 30 or more reports per second, no
 * report is late. */
#define INPUT_LATE_TICKS 4u
/* Age in ticks, half a second, after which missing reports mean that the input is lost. */
#define INPUT_SILENT_TICKS 60u
/* Time after which identical bits of a noisy sensor mean that the sensor is frozen. */
#define INPUT_STUCK_TICKS 120u
/* Ticks of consistent reports, a quarter of a second, after which lost input is valid again. */
#define INPUT_AGREE_TICKS 30u
#define INPUT_ARM_M_S_MAX 4.0f /* Highest plausible speed of a player's arm, in m/s. */
/* Highest plausible speed of a pointer: a mouse moved across the whole tank in 50 ms. */
#define INPUT_POINTER_M_S_MAX 16.0f
/* Highest rotation rate of a pointer's poi. The rotation is computed from the pointer's motion and
 * has no inertia. */
#define INPUT_POINTER_RAD_S_MAX 60.0f
/* Highest plausible rotation rate of a wrist that holds a wet poi. */
#define INPUT_WRIST_RAD_S_MAX 20.0f
/* Largest valid coordinate, longer than any controller's cord. */
#define INPUT_RANGE_M_MAX 100.0f
#define INPUT_ANGLE_RAD_MAX 1000.0f /* Largest valid angle, larger than any accumulated rotation. */

enum input_status {
    INPUT_ABSENT = 0, /* No controller of a person is connected. */
    INPUT_LOST = 1,   /* The input is not valid and must not be used. */
    INPUT_VALID = 2,
};

struct input_validation {
    uint8_t verdict;    /* Result of the validation in the last tick (enum input_status). */
    uint8_t has_newest; /* 1 if the pose in `newest` has been set, otherwise 0. */
    /* Number of consecutive ticks in which the sensor has repeated identical bits. */
    uint16_t same_ticks;
    /* Number of consecutive ticks with consistent reports, up to INPUT_AGREE_TICKS. */
    uint16_t agree_ticks;
    /* Age of the newest report in ticks if the report is late, otherwise 0. */
    uint16_t silent_ticks;
    /* Ticks left in which the pose catches up with the motion that was missed while reports were
     * late; 0 when it has caught up. */
    uint16_t late_ticks;
    /* Motion (`excess_m`) and rotation (`spin`, in the unit of input_turn()) beyond the speed
     * limits, summed over the ticks. A large sum means that the pose jumped. A negative sum is an
     * allowance for the next report, because no reports arrived for some time. */
    float excess_m, spin;
    struct poi_target newest; /* The last reported pose whose numbers were all valid. */
};

/* Returns true if each number of the pose is finite and within INPUT_RANGE_M_MAX or
 * INPUT_ANGLE_RAD_MAX. */
bool input_pose_is_finite(const struct poi_target *target);

/* Returns true if the motion between two valid poses in `seconds` >= 0 is too fast. The limit is
 * the speed of an arm if `has_wrist` is true, otherwise the speed of a pointer. */
bool input_pose_is_jump(const struct poi_target *from, const struct poi_target *to, float seconds,
                        bool has_wrist);

/* Returns the pose on the way between the poses of two successive reports, which are `seconds`
 * apart. `share` is 0 at the first report and 1 at the second report. If a pose is invalid or the
 * motion is a jump, the poses are not interpolated, so that an invalid pose reaches the input
 * validation unchanged. In this case the result is the first pose until `share` is 1. If the first
 * pose is invalid, the result is the second pose. */
struct poi_target input_pose_between(const struct poi_target *from, const struct poi_target *to,
                                     float share, float seconds, bool has_wrist);

/* Returns the difference of two orientations, which is the largest distance between the tips of
 * their unit axes. The value is at most 2, and equals radians for small rotations. Different angles
 * that describe the same orientation give 0. */
float input_turn(struct angles from, struct angles to);

/* Returns the share of the distance to the newest reported pose that the poi covers in this tick,
 * [0, 1]. With a low report rate the poi moves at about the arm's speed and lags by one report. */
float input_validation_blend(const struct input_validation *validation);

/* Validates the input of one player in this tick and returns the result. All fields of `validation`
 * must be 0 before the first call. */
enum input_status input_validation_tick(struct input_validation *validation,
                                        const struct poi_input *input);

/* ---- Calibration -------------------------------------------------------------------------------
 *
 * A sensor measures in its own frame, which is shifted, rotated, scaled and skewed against the
 * tank. The operator places the poi on four marks of the tank and then flat on the still water. The
 * measured poses determine the correction. Nine settings per slot, beginning at SET_CALIBRATION,
 * store the correction in millionths of a metre, of a radian or of 1. A value of 0 means no
 * correction. The corrected pose (x', y', z', pitch', roll') is:
 *
 *   x' = (1 + xx) * x + xz * z + x0      y' = y + y0      pitch' = pitch + p
 *   z' = zx * x + (1 + zz) * z + z0                       roll'  = roll + r
 *
 * Each setting is a separate ledger entry, and a power cut may occur between two entries. A check
 * value is therefore written last (SET_CALIBRATION_CHECK). If the check value does not match the
 * nine settings, the correction is incomplete and is not applied.
 *
 * The handle's direction is mapped like x and z, which corrects the yaw. Recordings store the
 * uncorrected pose; the core corrects the pose in every tick. */

#define CALIBRATE_CORNERS 4u
/* Distance of a calibration mark from each of the two nearest walls. At this distance the ring can
 * lie flat. */
#define CALIBRATE_INSET_M 0.08f
/* Smallest allowed distance between two measured corners. If two corners are nearer, they were
 * probably measured at the same mark. */
#define CALIBRATE_NEAR_M 0.02f
/* Largest allowed root mean square distance between the corrected corners and their marks. With
 * careful aiming and a working sensor the distance stays below this value. */
#define CALIBRATE_RESIDUAL_M 0.015f
/* Largest allowed tilt of the poi on the water. A larger tilt means that the poi did not lie
 * flat. */
#define CALIBRATE_TILT_RAD (45.0f * F_DEG)

enum calibration_value {
    CALIBRATION_XX = 0,
    CALIBRATION_XZ,
    CALIBRATION_X0,
    CALIBRATION_ZX,
    CALIBRATION_ZZ,
    CALIBRATION_Z0,
    CALIBRATION_Y0,
    CALIBRATION_PITCH,
    CALIBRATION_ROLL,
    CALIBRATION_VALUES,
};

/* Results of a calibration: CALIBRATION_GOOD, or the reason for its rejection, in the order of the
 * checks. */
enum calibration_fault {
    CALIBRATION_GOOD = 0,
    CALIBRATION_NEAR, /* Two measured corners are at the same place. */
    /* The corners were not measured in the order of a rectangle's corners, or all lie on one
     * line. */
    CALIBRATION_CROSSED,
    /* The corners are in mirrored order, which no rotation of the sensor can cause. */
    CALIBRATION_MIRRORED,
    /* A value of the correction exceeds the range of its setting, which is 10 m, 10 rad or a factor
     * of 10. */
    CALIBRATION_FAR,
    CALIBRATION_UNEVEN, /* No linear map brings all four corners close to their marks. */
    CALIBRATION_TILTED, /* The poi did not lie flat on the water. */
    CALIBRATION_FAULTS,
};

/* Uncorrected poses that were measured during a calibration. */
struct calibration_sample {
    /* Measured positions on the marks, in the order of input_calibration_mark(). */
    vec3 corner_m[CALIBRATE_CORNERS];
    /* Measured pose while the poi lies flat anywhere on the still water. */
    struct poi_target water;
    uint8_t has_wrist; /* 1 if the controller measures angles, otherwise 0. */
};

/* Returns the position of mark `corner` on the water: far left, far right, near right, near
 * left. */
vec3 input_calibration_mark(vec3 tank_size_m, uint32_t corner);

/* Computes the correction by least squares over the corners. Returns CALIBRATION_GOOD and fills
 * `out`, or returns the reason for the rejection and leaves `out` unchanged. */
enum calibration_fault input_calibration_solve(const struct calibration_sample *sample,
                                               vec3 tank_size_m, int32_t out[CALIBRATION_VALUES]);

/* Returns the id of the first calibration setting of slot `slot`, which must be < POI_MAX. */
static inline uint32_t input_calibration_setting(uint32_t slot)
{
    return SET_CALIBRATION + slot * CALIBRATION_VALUES;
}

static inline uint32_t input_calibration_check_setting(uint32_t slot)
{
    return SET_CALIBRATION_CHECK + slot;
}

/* Returns the check value for nine calibration values. The check value is 0 only if all nine values
 * are 0. */
int32_t input_calibration_check(const int32_t value[CALIBRATION_VALUES]);

/* Returns true if slot `slot` has a complete calibration whose values are not all 0. */
bool input_calibration_is_set(const struct settings *settings, uint32_t slot);

/* Returns true if slot `slot` has calibration values without a matching check value. */
bool input_calibration_is_torn(const struct settings *settings, uint32_t slot);

/* Corrects the pose of a live controller in place. An invalid pose stays unchanged. Without a
 * calibration of the slot, every pose stays unchanged bit for bit. */
void input_calibration_apply(const struct settings *settings, uint32_t slot, struct poi_input *poi);
