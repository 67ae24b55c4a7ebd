/* yield.h -- where the ring may not go. */
#ifndef KINGYO_CORE_POI_YIELD_H
#define KINGYO_CORE_POI_YIELD_H

#include "core/poi/poi.h"

/* Takes a ring that has just moved from `before_m` back out of floor, walls, its bowl and what lies
 * beyond an arm's reach, and stops what ran into them. `up` is its unit normal. */
void poi_yield(struct poi *poi, const struct tank *tank, const struct bowl *bowl, vec3 before_m,
               vec3 up);

/* After poi_tick(): out of one bowl more, another player's. */
void poi_yield_to_bowl(struct poi *poi, const struct bowl *bowl);

/* The same of walls, floor and its own bowl, for a ring that something moved after poi_tick(). */
void poi_yield_again(struct poi *poi, const struct tank *tank, const struct bowl *bowl);

#endif
