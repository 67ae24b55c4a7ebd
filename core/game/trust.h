/* trust.h -- is what a controller says a hand, or nonsense? Pure; a few words of memory a player.
 *
 * A cable that breaks, a sensor that freezes, bits that flip and reports that come late are
 * weather. A hand is lost while its link is away, a number is none or absurd, its reports stay out,
 * a sensor that trembles stands still to the bit, or it leaps as no arm does. It is believed again
 * when it has said what agrees for a quarter of a second; a leap that stays is then where the hand
 * is. A pointer moves a picture, not an arm, and may leap: it leaves a window at one side and comes
 * back at the other. Its poi goes there as a poi can (hand.c). */
#ifndef KINGYO_CORE_GAME_TRUST_H
#define KINGYO_CORE_GAME_TRUST_H

#include <stdint.h>

#include "core/input.h"

#define TRUST_LATE_TICKS 4u     /* Reports this old are late: 30 a second never are. */
#define TRUST_SILENT_TICKS 60u  /* Half a second without a report: nobody is there. */
#define TRUST_STUCK_TICKS 120u  /* So long a trembling sensor never said the same bits. */
#define TRUST_AGREE_TICKS 30u   /* A quarter of a second brings a lost hand back. */
#define TRUST_ARM_M_S 4.0f      /* No arm is faster, ... */
#define TRUST_POINTER_M_S 16.0f /* A mouse thrown over the whole tank in a twentieth of a second. */
#define TRUST_POINTER_RAD_S 60.0f /* Its turns are made up from its ways, in no time. */
#define TRUST_WRIST_RAD_S 20.0f /* ... and no wrist that holds a wet poi. */
#define TRUST_RANGE_M 100.0f    /* Farther than anyone walks away with a poi. */
#define TRUST_ANGLE_RAD 1000.0f /* No wrist has turned so far. */

enum trust_verdict {
    TRUST_ABSENT = 0,   /* No person's controller. */
    TRUST_LOST = 1,     /* Not to be followed. */
    TRUST_BELIEVED = 2,
};

struct trust {
    uint8_t verdict;         /* enum trust_verdict of the last tick. */
    uint8_t knows;           /* `newest` holds a pose. */
    uint16_t same_ticks;     /* How long it has said the same bits, ... */
    uint16_t agree_ticks;    /* ... and what agrees with what it said before. */
    uint16_t silent_ticks;   /* The age of its reports, as long as they were late. */
    uint16_t late_ticks;     /* In so many it goes the way that it went meanwhile; 0: it has. */
    float rush_m, spin;      /* How far it went and turned beyond what an arm does. */
    struct poi_target newest; /* The last readable pose. */
};

/* Whether each number of it is one, and within TRUST_RANGE_M or TRUST_ANGLE_RAD. */
int trust_can_read(const struct poi_target *target);

/* Whether no hand goes from one readable pose to the next in `seconds` >= 0. */
int trust_is_leap(const struct poi_target *from, const struct poi_target *to, float seconds,
                  int has_wrist);

/* How far apart two directions are: the way of the unit axes' tips, which is radians while small
 * and at most 2. Angles that mean the same are no turn. */
float trust_turn(struct angles from, struct angles to);

/* [0, 1]: how much of the way from its poi's hand to what it says is gone in this tick. The poi of
 * a controller that reports slowly goes about as fast as the hand does, and lags by a report. */
float trust_share(const struct trust *trust);

/* Judges one tick's input of one player; all of a zeroed `trust` is a fresh one. */
enum trust_verdict trust_tick(struct trust *trust, const struct poi_input *input);

uint64_t trust_hash(uint64_t hash, const struct trust *trust);

#endif
