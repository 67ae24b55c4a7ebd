/* wake.h -- what the ring does to the surface: it presses, cuts and drips. */
#ifndef KINGYO_CORE_POI_WAKE_H
#define KINGYO_CORE_POI_WAKE_H

#include "core/poi/poi.h"

/* One tick; */
void wake_tick(const struct poi *poi, struct water *water, vec3 tank_size_m);

#endif
