/* hand_spring.h -- the hand spring, which pulls the ring of the poi toward the player's hand.
 *
 * The poi is the paper scoop. Water forces and weight act against the spring. */
#ifndef KINGYO_CORE_POI_HAND_SPRING_H
#define KINGYO_CORE_POI_HAND_SPRING_H

#include "core/poi/poi.h"

/* Updates the velocity of the ring for one tick (1/120 s). A spring of at most 20 N pulls the ring
 * toward `target_m`. `immersed` is the share [0, 1] of the disc that is in the water. Stores the
 * water forces in `poi` but does not change the position. */
void hand_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed);

/* Returns the force of the hand on the ring in world axes. The force of the spring and the damper
 * is taken at the present position and velocity of the ring, so that the result also holds for a
 * blocked ring. */
vec3 hand_spring_force_n(const struct poi *poi, const struct basis *axes);

/* Returns the effective mass on each of the ring's axes (right, up, back): the ring, its load and
 * the added mass of water. */
vec3 hand_spring_mass_kg(const struct poi *poi);

#endif
