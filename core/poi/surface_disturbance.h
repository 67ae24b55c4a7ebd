/* surface_disturbance.h -- the effect of a poi (paper scoop) on the water surface.
 *
 * The ring presses the surface as it moves up or down, cuts the surface as it moves sideways, and
 * drips. */
#ifndef KINGYO_CORE_POI_SURFACE_DISTURBANCE_H
#define KINGYO_CORE_POI_SURFACE_DISTURBANCE_H

#include "core/poi/poi.h"

/* Applies the disturbances of one tick (1/120 s) by `poi` to `water`. */
void surface_disturbance_tick(const struct poi *poi, struct water *water, vec3 tank_size_m);

#endif
