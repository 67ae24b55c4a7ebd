/* input_validation.h -- input validation: detects lost, frozen, late and implausible input of a
 * controller.
 *
 * Broken cables, frozen sensors, flipped bits and late reports are expected. Input is lost while
 * the link is disconnected, a number is NaN or out of range, or reports are missing. Input is also
 * lost if a noisy sensor repeats identical bits, or if the pose jumps faster than an arm can move.
 * Input becomes valid again after a quarter of a second of consistent reports. If a pose stays
 * after a jump, it is accepted as the new pose. A pointer is not limited by an arm and may jump,
 * for example when it leaves and re-enters a window. The poi of a pointer follows at a limited
 * speed (controller.c).
 *
 * All state is in struct input_validation; the functions have no other side effects. */
#ifndef KINGYO_CORE_GAME_CONTROL_INPUT_VALIDATION_H
#define KINGYO_CORE_GAME_CONTROL_INPUT_VALIDATION_H

#include <stdint.h>

#include "core/input.h"

/* Age in ticks from which a report is late. At 30 or more reports per second, no report is late. */
#define INPUT_LATE_TICKS 4u
/* Age in ticks, half a second, after which missing reports mean that the input is lost. */
#define INPUT_SILENT_TICKS 60u
/* Time after which identical bits of a noisy sensor mean that it is frozen. */
#define INPUT_STUCK_TICKS 120u
/* Ticks of consistent reports, a quarter of a second, after which lost input is valid again. */
#define INPUT_AGREE_TICKS 30u
#define INPUT_ARM_M_S_MAX 4.0f /* Highest speed of an arm. */
/* Highest speed of a pointer: a mouse moved across the whole tank in 50 ms. */
#define INPUT_POINTER_M_S_MAX 16.0f
/* Highest rotation rate of a pointer's poi. The rotation is computed from the pointer's motion and
 * has no inertia. */
#define INPUT_POINTER_RAD_S_MAX 60.0f
#define INPUT_WRIST_RAD_S_MAX 20.0f /* Highest rotation rate of a wrist that holds a wet poi. */
/* Largest valid coordinate, longer than any controller's cord. */
#define INPUT_RANGE_M_MAX 100.0f
#define INPUT_ANGLE_RAD_MAX 1000.0f /* Largest valid angle, larger than any accumulated rotation. */

enum input_status {
    INPUT_ABSENT = 0, /* No person's controller is connected. */
    INPUT_LOST = 1,   /* The input is not valid and must not be used. */
    INPUT_VALID = 2,
};

struct input_validation {
    uint8_t verdict;          /* Result of the last tick (enum input_status). */
    uint8_t knows;            /* 1 if `newest` is valid, otherwise 0. */
    uint16_t same_ticks;      /* Number of consecutive ticks in which the sensor has repeated
                                 identical bits. */
    uint16_t agree_ticks;     /* Number of consecutive ticks with consistent reports, up to
                                 INPUT_AGREE_TICKS. */
    uint16_t silent_ticks;    /* Age of the newest report in ticks if the report is late, otherwise
                                 0. */
    uint16_t late_ticks;      /* Ticks left in which the pose catches up with the motion that was
                                 missed while reports were late; 0 when it has caught up. */
    float excess_m, spin;     /* Accumulated motion (`excess_m`) and rotation (`spin`) beyond the
                                 limits of an arm. A negative value is the motion or rotation still
                                 allowed for the time in which no reports arrived. */
    struct poi_target newest; /* The last pose with valid numbers. */
};

/* Returns 1 if each number is finite and within INPUT_RANGE_M_MAX or INPUT_ANGLE_RAD_MAX, otherwise
 * 0. */
int input_pose_is_finite(const struct poi_target *target);

/* Returns 1 if the motion between two valid poses in `seconds` >= 0 is too fast, otherwise 0. The
 * limit is the speed of an arm (`has_wrist` 1) or of a pointer (`has_wrist` 0). */
int input_pose_is_jump(const struct poi_target *from, const struct poi_target *to, float seconds,
                       int has_wrist);

/* Returns the difference of two orientations, which is the largest distance between the tips of
 * their unit axes. The value is at most 2, and equals radians for small rotations. Different angles
 * that describe the same orientation give 0. */
float input_turn(struct angles from, struct angles to);

/* Returns the share of the remaining distance to the reported pose that the poi covers in this
 * tick, [0, 1]. With a low report rate the poi moves at about the arm's speed and lags by one
 * report. */
float input_validation_blend(const struct input_validation *validation);

/* Validates one tick's input of one player and returns the result. In the initial state all fields
 * of `validation` are 0. */
enum input_status input_validation_tick(struct input_validation *validation,
                                        const struct poi_input *input);

/* Returns `hash` continued over the position and the angles of `pose`. */
uint64_t input_pose_hash(uint64_t hash, const struct poi_target *pose);

uint64_t input_validation_hash(uint64_t hash, const struct input_validation *validation);

#endif
