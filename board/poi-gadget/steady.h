/* steady.h -- removes the noise of the converter from a position without delaying fast motion. The
 * functions are pure.
 *
 * The One Euro filter (Casiez, Roussel, Vogel 2012) is a first-order low-pass filter whose corner
 * frequency increases with the speed. At rest, one step of a 12-bit converter (0.3 mm) must not
 * appear as a hand tremor of 75 mm/s. During a fast dip, the delay of the filter must stay below
 * one tick of the game (1/120 s). */
#ifndef KINGYO_BOARD_POI_GADGET_STEADY_H
#define KINGYO_BOARD_POI_GADGET_STEADY_H

#include "core/base/vec.h"

#define STEADY_REST_HZ 4.0f     /* Corner frequency of the position filter at rest, in Hz. */
#define STEADY_HZ_PER_M_S 60.0f /* Increase of the corner frequency in Hz for each m/s of speed. */
#define STEADY_SPEED_HZ 6.0f    /* Corner frequency of the speed filter, in Hz. */

struct steady {
    int begun;
    vec3 place_m, speed_m_s, raw_m;
};

/* Returns the filtered position. `seconds` is the time since the previous call and must be above
 * 0. */
vec3 steady_step(struct steady *steady, vec3 raw_m, float seconds);

#endif
