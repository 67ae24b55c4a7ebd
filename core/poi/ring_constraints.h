/* ring_constraints.h -- constraints on the position of the ring. */
#ifndef KINGYO_CORE_POI_RING_CONSTRAINTS_H
#define KINGYO_CORE_POI_RING_CONSTRAINTS_H

#include "core/poi/poi.h"

/* Moves a ring that just came from `before_m` out of floor, walls, its bowl and the region beyond
 * an arm's reach, and stops motion into them. `up` is its unit normal. */
void poi_constrain(struct poi *poi, const struct tank *tank, const struct bowl *bowl, vec3 before_m,
                   vec3 up);

/* Moves the ring out of another player's bowl; called after poi_tick(). */
void poi_constrain_to_bowl(struct poi *poi, const struct bowl *bowl);

/* Applies walls, floor and the ring's own bowl again, for a ring that was moved after
 * poi_tick(). */
void poi_constrain_again(struct poi *poi, const struct tank *tank, const struct bowl *bowl);

#endif
