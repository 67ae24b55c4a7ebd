/* hand_spring.h -- simulates the hand spring, which pulls the ring of the poi toward the player's
 * hand.
 *
 * The poi is the paper scoop. Water forces and the weight act on the ring in addition to the
 * spring. */
#ifndef KINGYO_CORE_POI_HAND_SPRING_H
#define KINGYO_CORE_POI_HAND_SPRING_H

#include "core/poi/poi.h"

/* Updates the velocity of the ring for one tick (1/120 s). A spring with a force of at most 20 N
 * pulls the ring toward `target_m`. `axes` are the poi's axes, and `immersed` is the fraction [0,
 * 1] of the disc that is in the water. Stores the water forces in `poi`. Does not change the
 * position. */
void hand_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed);

/* Returns the force of the hand on the ring, in world axes: the force of the spring and of its
 * damping at the present position and velocity of the ring. The result is therefore also valid for
 * a blocked ring. `axes` are the poi's axes. */
vec3 hand_spring_force_n(const struct poi *poi, const struct basis *axes);

/* Returns the effective mass of the ring for motion along each of its axes (right, up, back). The
 * effective mass consists of the ring, the carried water and fish, and the added mass of water. */
vec3 hand_spring_mass_kg(const struct poi *poi);

#endif
