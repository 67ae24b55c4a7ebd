/* steady.h -- removes converter noise from a position without delaying fast motion. The functions
 * are pure.
 *
 * The One Euro filter (Casiez, Roussel, Vogel 2012) is a first-order low-pass filter whose corner
 * frequency rises with the speed. At rest, the 0.3 mm of a 12-bit step must not appear as a hand
 * tremor of 75 mm/s. In a dip, the delay must stay below one tick of the game. */
#ifndef KINGYO_BOARD_POI_GADGET_STEADY_H
#define KINGYO_BOARD_POI_GADGET_STEADY_H

#include "core/base/vec.h"

#define STEADY_REST_HZ 4.0f     /* Corner frequency at rest. */
#define STEADY_HZ_PER_M_S 60.0f /* Increase of the corner frequency for each m/s of speed. */
#define STEADY_SPEED_HZ 6.0f    /* Corner frequency of the speed filter. */

struct steady {
    int begun;
    vec3 place_m, speed_m_s, raw_m;
};

/* Returns the filtered position `seconds` > 0 after the previous step. */
vec3 steady_step(struct steady *steady, vec3 raw_m, float seconds);

#endif
