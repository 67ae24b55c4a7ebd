/* ring_constraints.h -- constraints on the position of a poi's ring: tank, bowls and arm's
 * reach. */
#ifndef KINGYO_CORE_POI_RING_CONSTRAINTS_H
#define KINGYO_CORE_POI_RING_CONSTRAINTS_H

#include "core/poi/poi.h"

/* Moves a ring that came from `before_m` in this tick out of the floor, the walls and its own bowl,
 * and back within an arm's reach. Removes the speed of the ring toward these limits. `up` is the
 * ring's unit normal. */
void poi_constrain(struct poi *poi, const struct tank *tank, const struct bowl *bowl, vec3 before_m,
                   vec3 up);

/* Moves the ring out of another player's bowl. The caller must have called poi_tick() in this
 * tick. */
void poi_constrain_to_bowl(struct poi *poi, const struct bowl *bowl);

/* Applies walls, floor and the player's own bowl once more, for a ring that was moved after its
 * poi_tick(). */
void poi_constrain_again(struct poi *poi, const struct tank *tank, const struct bowl *bowl);

#endif
