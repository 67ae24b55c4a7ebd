/* steady.h -- takes a converter's noise out of a place without holding a fast hand back. Pure.
 *
 * The One Euro filter (Casiez, Roussel, Vogel 2012): a first-order low pass whose corner rises with
 * the speed. At rest 0.3 mm of a 12-bit step are not to look like a hand that trembles at 75 mm/s;
 * in a dip the lag must stay under a tick of the game. */
#ifndef KINGYO_POI_GADGET_STEADY_H
#define KINGYO_POI_GADGET_STEADY_H

#include "core/base/vec.h"

#define STEADY_REST_HZ 4.0f      /* Corner at rest ... */
#define STEADY_HZ_PER_M_S 60.0f  /* ... and so much more for each m/s. */
#define STEADY_SPEED_HZ 6.0f     /* Corner of the speed itself. */

struct steady {
    int begun;
    vec3 place_m, speed_m_s, raw_m;
};

/* The place `seconds` > 0 after the last one. */
vec3 steady_step(struct steady *steady, vec3 raw_m, float seconds);

#endif
