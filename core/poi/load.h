/* load.h -- the loads on the ring of the poi (the paper scoop) and on its paper.
 *
 * Forces are in newtons and in world axes unless a comment names other axes. */
#ifndef KINGYO_CORE_POI_LOAD_H
#define KINGYO_CORE_POI_LOAD_H

#include "core/poi/poi.h"

/* Returns the weight of the ring, its water and its fish, multiplied by the share of the disc that
 * is above the water. */
vec3 load_weight_n(const struct poi *poi);

/* Returns the sum of drag, friction and slam of this tick at the present velocity of the ring.
 * `axes` are the poi's axes. */
vec3 load_water_n(const struct poi *poi, const struct basis *axes);

/* Returns the downward pull of the water surface that clings to both faces of a ring leaving the
 * water. The pull is 2 pi a sigma per face for a level ring of radius a, and little for a steep
 * ring. */
float load_meniscus_n(const struct poi *poi, float up_y);

/* Returns the sum of all slap forces along the poi's normal; a negative force presses down on the
 * paper. */
float load_kick_n(const struct poi *poi);

/* Updates the filtered acceleration. Returns the pressure of all loads on the paper, positive
 * toward the poi's up axis. */
float load_paper_pa(struct poi *poi, const struct basis *axes);

#endif
