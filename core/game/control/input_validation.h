/* input_validation.h -- input validation: detects lost, frozen, late and implausible input of a
 * controller.
 *
 * Broken cables, frozen sensors, flipped bits and late reports are expected. Input is lost while
 * the link is down, a number is NaN or out of range, or reports are missing. Input is also lost if
 * a noisy sensor repeats identical bits, or if the pose jumps faster than an arm can move. Input is
 * valid again after a quarter of a second of consistent reports; a pose that stays after a jump is
 * then the new pose. A pointer moves a picture, not an arm, and may jump, for example when it
 * leaves and re-enters a window. The poi of a pointer follows at a poi's speed (controller.c).
 *
 * All state is in struct input_validation; the functions have no other side effects. */
#ifndef KINGYO_CORE_GAME_CONTROL_INPUT_VALIDATION_H
#define KINGYO_CORE_GAME_CONTROL_INPUT_VALIDATION_H

#include <stdint.h>

#include "core/input.h"

/* Age from which a report is late; 30 reports per second are never late. */
#define INPUT_LATE_TICKS 4u
#define INPUT_SILENT_TICKS 60u /* Half a second without a report means that the input is lost. */
/* Time after which identical bits of a noisy sensor mean that it is frozen. */
#define INPUT_STUCK_TICKS 120u
/* A quarter of a second of consistent reports makes lost input valid again. */
#define INPUT_AGREE_TICKS 30u
#define INPUT_ARM_M_S_MAX 4.0f /* Highest speed of an arm. */
/* Highest speed of a pointer: a mouse moved across the whole tank in 50 ms. */
#define INPUT_POINTER_M_S_MAX 16.0f
/* Highest rotation rate of a pointer's poi. The rotation is derived from the motion and has no
 * inertia. */
#define INPUT_POINTER_RAD_S_MAX 60.0f
#define INPUT_WRIST_RAD_S_MAX 20.0f /* Highest rotation rate of a wrist that holds a wet poi. */
#define INPUT_RANGE_M_MAX 100.0f    /* Largest valid coordinate, beyond the length of any cord. */
#define INPUT_ANGLE_RAD_MAX 1000.0f /* Largest valid angle, beyond any accumulated rotation. */

enum input_status {
    INPUT_ABSENT = 0, /* No person's controller is connected. */
    INPUT_LOST = 1,   /* The input must not be used. */
    INPUT_VALID = 2,
};

struct input_validation {
    uint8_t verdict;          /* enum input_status of the last tick. */
    uint8_t knows;            /* 1: `newest` is valid. */
    uint16_t same_ticks;      /* Ticks for which the sensor has repeated identical bits. */
    uint16_t agree_ticks;     /* Ticks of consistent reports, up to INPUT_AGREE_TICKS. */
    uint16_t silent_ticks;    /* Age of the newest report in ticks while it is late; else 0. */
    uint16_t late_ticks;      /* Ticks left in which the pose catches up with the motion that was
                                 missed while reports were late; 0 when it has caught up. */
    float excess_m, spin;     /* Motion and rotation beyond the limits of an arm, accumulated;
                                 negative: allowance for unseen motion. */
    struct poi_target newest; /* The last pose with valid numbers. */
};

/* Returns 1 if each number is finite and within INPUT_RANGE_M_MAX or INPUT_ANGLE_RAD_MAX. */
int input_pose_is_finite(const struct poi_target *target);

/* Returns 1 if the motion from one valid pose to the other in `seconds` >= 0 is faster than an arm
 * (`has_wrist` 1) or a pointer (`has_wrist` 0) can move. */
int input_pose_is_jump(const struct poi_target *from, const struct poi_target *to, float seconds,
                       int has_wrist);

/* Returns the difference of two orientations: the largest distance between the tips of their unit
 * axes. The value equals radians for small rotations and is at most 2. Equivalent angles give 0. */
float input_turn(struct angles from, struct angles to);

/* Returns the share of the distance to the reported pose that is covered in this tick, [0, 1].
 * The poi of a controller with a low report rate moves at about the arm's speed and lags by one
 * report. */
float input_validation_blend(const struct input_validation *validation);

/* Validates one tick's input of one player and returns the result. An all-zero `validation` is the
 * initial state. */
enum input_status input_validation_tick(struct input_validation *validation,
                                        const struct poi_input *input);

uint64_t input_validation_hash(uint64_t hash, const struct input_validation *validation);

#endif
