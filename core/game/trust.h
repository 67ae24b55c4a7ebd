/* trust.h -- input validation: detects lost, frozen, late and implausible input of a controller.
 *
 * Broken cables, frozen sensors, flipped bits and late reports are expected. Input is lost while
 * the link is down, a number is NaN or out of range, or reports are missing. Input is also lost if
 * a noisy sensor repeats identical bits, or if the pose jumps faster than an arm can move. Input is
 * valid again after a quarter of a second of consistent reports; a pose that stays after a jump is
 * then the new pose. A pointer moves a picture, not an arm, and may jump, for example when it
 * leaves and re-enters a window. The poi of a pointer follows at a poi's speed (hand.c).
 *
 * All state is in struct trust; the functions have no other side effects. */
#ifndef KINGYO_CORE_GAME_TRUST_H
#define KINGYO_CORE_GAME_TRUST_H

#include <stdint.h>

#include "core/input.h"

#define TRUST_LATE_TICKS 4u     /* Age from which a report is late; 30 reports per second are never
                                   late. */
#define TRUST_SILENT_TICKS 60u  /* Half a second without a report means that the input is lost. */
#define TRUST_STUCK_TICKS 120u  /* Time after which identical bits of a noisy sensor mean that it is
                                   frozen. */
#define TRUST_AGREE_TICKS 30u   /* A quarter of a second of consistent reports makes lost input
                                   valid again. */
#define TRUST_ARM_M_S 4.0f      /* Highest speed of an arm. */
#define TRUST_POINTER_M_S 16.0f /* Highest speed of a pointer: a mouse moved across the whole tank
                                   in 50 ms. */
#define TRUST_POINTER_RAD_S 60.0f /* Highest rotation rate of a pointer's poi. The rotation is
                                     derived from the motion and has no inertia. */
#define TRUST_WRIST_RAD_S 20.0f /* Highest rotation rate of a wrist that holds a wet poi. */
#define TRUST_RANGE_M 100.0f    /* Largest valid coordinate, beyond the length of any cord. */
#define TRUST_ANGLE_RAD 1000.0f /* Largest valid angle, beyond any accumulated rotation. */

enum trust_verdict {
    TRUST_ABSENT = 0,   /* No person's controller is connected. */
    TRUST_LOST = 1,     /* The input must not be used. */
    TRUST_BELIEVED = 2,
};

struct trust {
    uint8_t verdict;         /* enum trust_verdict of the last tick. */
    uint8_t knows;           /* 1: `newest` is valid. */
    uint16_t same_ticks;     /* Ticks for which the sensor has repeated identical bits. */
    uint16_t agree_ticks;    /* Ticks of consistent reports, up to TRUST_AGREE_TICKS. */
    uint16_t silent_ticks;   /* Age of the newest report in ticks while it is late; else 0. */
    uint16_t late_ticks;     /* Ticks left in which the pose catches up with the motion that was
                                missed while reports were late; 0 when it has caught up. */
    float rush_m, spin;      /* Motion and rotation beyond the limits of an arm, accumulated;
                                negative: allowance for unseen motion. */
    struct poi_target newest; /* The last pose with valid numbers. */
};

/* Returns 1 if each number is finite and within TRUST_RANGE_M or TRUST_ANGLE_RAD. */
int trust_can_read(const struct poi_target *target);

/* Returns 1 if the motion from one valid pose to the other in `seconds` >= 0 is faster than an arm
 * (`has_wrist` 1) or a pointer (`has_wrist` 0) can move. */
int trust_is_leap(const struct poi_target *from, const struct poi_target *to, float seconds,
                  int has_wrist);

/* Returns the difference of two orientations: the largest distance between the tips of their unit
 * axes. The value equals radians for small rotations and is at most 2. Equivalent angles give 0. */
float trust_turn(struct angles from, struct angles to);

/* Returns the share of the distance to the reported pose that is covered in this tick, [0, 1].
 * The poi of a controller with a low report rate moves at about the arm's speed and lags by one
 * report. */
float trust_share(const struct trust *trust);

/* Validates one tick's input of one player and returns the result. An all-zero `trust` is the
 * initial state. */
enum trust_verdict trust_tick(struct trust *trust, const struct poi_input *input);

uint64_t trust_hash(uint64_t hash, const struct trust *trust);

#endif
