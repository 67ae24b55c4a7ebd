/* surface_disturbance.h -- surface disturbance by the ring: pressing, cutting and dripping. */
#ifndef KINGYO_CORE_POI_SURFACE_DISTURBANCE_H
#define KINGYO_CORE_POI_SURFACE_DISTURBANCE_H

#include "core/poi/poi.h"

/* Applies the disturbances of one tick. */
void surface_disturbance_tick(const struct poi *poi, struct water *water, vec3 tank_size_m);

#endif
