/* load.h -- computes the loads on the ring of the poi (the paper scoop) and on its paper.
 *
 * Forces are in newtons and in world axes unless a comment names other axes. */
#ifndef KINGYO_CORE_POI_LOAD_H
#define KINGYO_CORE_POI_LOAD_H

#include "core/poi/poi.h"

/* Returns the weight of the ring with its carried water and fish, multiplied by the fraction of the
 * disc that is above the water. */
vec3 load_weight_n(const struct poi *poi);

/* Returns the sum of the drag, the friction and the slam force of the water on the ring in this
 * tick, at the present velocity of the ring. `axes` are the poi's axes. */
vec3 load_water_n(const struct poi *poi, const struct basis *axes);

/* Returns the downward pull of the meniscus: the water surface that clings to both faces of a ring
 * leaving the water. For a level ring of radius a, the pull is 2 * pi * a * sigma per face, where
 * sigma is the surface tension. For a steep ring, the pull is small. `up_y` is the vertical
 * component of the ring's unit normal. */
float load_meniscus_n(const struct poi *poi, float up_y);

/* Returns the sum of all slap forces along the poi's normal. A negative force presses the paper
 * down. */
float load_kick_n(const struct poi *poi);

/* Updates the low-pass filtered acceleration of the ring. Returns the pressure of all loads on the
 * paper, positive toward the poi's up axis. */
float load_paper_pa(struct poi *poi, const struct basis *axes);

#endif
