/* surface_disturbance.h -- computes the effect of a poi (paper scoop) on the water surface.
 *
 * The ring disturbs the surface when it moves up or down, when its edge cuts through the surface,
 * and when water drips from it. */
#ifndef KINGYO_CORE_POI_SURFACE_DISTURBANCE_H
#define KINGYO_CORE_POI_SURFACE_DISTURBANCE_H

#include "core/poi/poi.h"

/* Applies the disturbances that `poi` causes in one tick (1/120 s) to `water`. */
void surface_disturbance_tick(const struct poi *poi, struct water *water, vec3 tank_size_m);

#endif
