/* pad_tilt.h -- how a pad is held: its gyroscope and accelerometer into a wrist. Pure.
 *
 * The gyroscope says at once how the pad turns, the accelerometer says slowly, and amid all the
 * shaking of a hand, where down is; together they know pitch and roll without drift. Nobody holds a
 * pad level, so what counts is the tilt against the way it is held at rest, which is learned: at
 * once by LEVEL, and slowly while the poi hovers. */
#ifndef KINGYO_DRIVERS_PAD_TILT_H
#define KINGYO_DRIVERS_PAD_TILT_H

#include <stdint.h>

#include "core/base/vec.h"

#define PAD_TILT_MAX_RAD (45.0f * F_DEG) /* A wrist with a poi in it goes no farther in play. */

/* Axes as SDL gives them: +x to the right, +y up out of the buttons, +z toward the player. */
struct pad_tilt {
    vec3 up;             /* The world's up in the pad's axes. */
    uint8_t knows_down;  /* `up` came from an accelerometer. */
    uint8_t knows_rest;
    float rest_pitch_rad, rest_roll_rad;
    uint64_t turn_ns;    /* As far as it was turned. */
    uint64_t weigh_ns;   /* Of the newest weight. */
    uint64_t rest_ns;    /* Since then the rest was not followed. */
    vec3 rate_rad_s;
};

/* The pad turns with `rate_rad_s` from `time_ns` on. -1: a number is none; nothing changes. */
int pad_tilt_turns(struct pad_tilt *tilt, uint64_t time_ns, vec3 rate_rad_s);

/* What the accelerometer says, gravity with it: at rest 9.8 m/s2 upward. -1 as above. */
int pad_tilt_weighs(struct pad_tilt *tilt, uint64_t time_ns, vec3 up_m_s2);

/* From now on this is level. */
void pad_tilt_level(struct pad_tilt *tilt);

/* Pitch and roll at `time_ns`, as a poi's, within PAD_TILT_MAX_RAD; 0 before it is known how it is
 * held. While `hovers` the way that it is held becomes the rest. */
struct angles pad_tilt_at(struct pad_tilt *tilt, uint64_t time_ns, int hovers);

#endif
