/* ring_constraints.h -- limits the position of a poi's ring by the tank, the bowls and the reach of
 * the player's arm. */
#ifndef KINGYO_CORE_POI_RING_CONSTRAINTS_H
#define KINGYO_CORE_POI_RING_CONSTRAINTS_H

#include "core/poi/poi.h"

/* Moves the ring out of the floor, the walls and the player's own bowl, and back into the reach of
 * the arm. Removes the part of the ring's velocity that points beyond these limits. `before_m` is
 * the position of the ring at the start of the tick, and `up` is its unit normal. */
void poi_constrain(struct poi *poi, const struct tank *tank, const struct bowl *bowl, vec3 before_m,
                   vec3 up);

/* Moves the ring out of another player's bowl `bowl`. The caller must have called poi_tick() in
 * this tick. */
void poi_constrain_to_bowl(struct poi *poi, const struct bowl *bowl);

/* Applies the limits of walls, floor and the player's own bowl again. A caller needs this function
 * if it moved the ring after poi_tick(). */
void poi_constrain_again(struct poi *poi, const struct tank *tank, const struct bowl *bowl);

#endif
