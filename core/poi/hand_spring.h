/* hand_spring.h -- the hand spring that pulls the ring against water and weight. */
#ifndef KINGYO_CORE_POI_HAND_SPRING_H
#define KINGYO_CORE_POI_HAND_SPRING_H

#include "core/poi/poi.h"

/* Updates the speed of the ring for one tick. A spring of at most 20 N pulls it toward `target_m`,
 * with the share `immersed` of it in the water. Stores the water forces and loads; the position is
 * unchanged. */
void hand_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed);

/* Returns the world force of the hand on the ring: spring and damper at the present position and
 * speed, so that it also holds for a blocked ring. */
vec3 hand_spring_force_n(const struct poi *poi, const struct basis *axes);

/* Returns the effective mass along `axes`: ring, load and added mass of water. */
vec3 hand_spring_mass_kg(const struct poi *poi);

#endif
