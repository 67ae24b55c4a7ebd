/* fall.h -- a fish that slipped off the ring or through the paper, until it lands. */
#ifndef KINGYO_CORE_POI_FALL_H
#define KINGYO_CORE_POI_FALL_H

#include "core/poi/bowl.h"
#include "core/poi/rider.h"
#include "core/tank/tank.h"

enum fall_end {
    FALL_GOES_ON = 0,
    FALL_INTO_BOWL,  /* The fish is the bowl's now, and counted there. */
    FALL_INTO_WATER, /* It swims, as soon as it is clear. */
};

/* A rider leaves the poi at a world velocity. */
void fall_begin(struct rider *rider, vec3 velocity_m_s);

/* One tick of a falling rider. Only from above, through its mouth, does a fish come into a bowl,
 * whosever that is; then `*bowl_index` tells which. */
enum fall_end fall_tick(struct rider *rider, const struct stall *stall, uint32_t *bowl_index);

/* Puts a fish that was held back into the water, under the surface and inside the walls, in a
 * hurry. */
void fall_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

#endif
