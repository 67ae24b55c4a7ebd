/* load.h -- what bears on the ring and its paper. Forces are in newtons, world axes unless said. */
#ifndef KINGYO_CORE_POI_LOAD_H
#define KINGYO_CORE_POI_LOAD_H

#include "core/poi/poi.h"

/* The ring's, its water's and its fish's, as far as they are in air. */
vec3 load_weight_n(const struct poi *poi);

/* Drag, friction and slam as they were met in this tick, at the speed that the ring has. */
vec3 load_water_n(const struct poi *poi, const struct basis *axes);

/* The surface that clings to both faces of a ring that leaves the water, one behind the other
 * along its edge: 2 pi a sigma a face for a level one, little for a steep one. Pulls down. */
float load_meniscus_n(const struct poi *poi, float up_y);

/* Blows of tails, all together, along the normal; < 0 presses. */
float load_kick_n(const struct poi *poi);

/* Feels the jolt of the ring's true way, and what it makes of all this: the pressure on the paper,
 * positive toward its up. */
float load_paper_pa(struct poi *poi, const struct basis *axes);

#endif
