/* load.h -- the loads on the ring and its paper. Forces are in newtons, in world axes unless
 * stated. */
#ifndef KINGYO_CORE_POI_LOAD_H
#define KINGYO_CORE_POI_LOAD_H

#include "core/poi/poi.h"

/* Returns the weight of the ring, its water and its fish, as far as they are in air. */
vec3 load_weight_n(const struct poi *poi);

/* Returns drag, friction and slam of this tick at the present speed of the ring. */
vec3 load_water_n(const struct poi *poi, const struct basis *axes);

/* Returns the pull of the surface that clings to both faces of a ring leaving the water: 2 pi a
 * sigma per face for a level ring, little for a steep ring. Acts downward. */
float load_meniscus_n(const struct poi *poi, float up_y);

/* Returns the sum of all slaps along the normal; < 0 presses. */
float load_kick_n(const struct poi *poi);

/* Updates the filtered acceleration, and returns the pressure of all loads on the paper, positive
 * toward its up. */
float load_paper_pa(struct poi *poi, const struct basis *axes);

#endif
