/* afloat.h -- how the bowls float: by their weight, on the ripples, on soft moorings.
 *
 * A bowl sinks by a tenth of a millimetre with each fish, rocks when one drops in, heels with the
 * slope of the water, and drifts home when it was pushed away. The federation's free hand may not
 * touch it: it is moved with the ring of a poi, anybody's. Walls and other bowls stop it. */
#ifndef KINGYO_CORE_POI_AFLOAT_H
#define KINGYO_CORE_POI_AFLOAT_H

#include "core/poi/bowl.h"
#include "core/poi/poi.h"

/* One tick of every bowl at the stall, after the pois' and before the fish's: `poi_count` pois,
 * each of which takes part where `live` says so, push those that they touch. Water beyond what the
 * hull can hold spills into the tank. */
void afloat_tick(const struct stall *stall, const struct poi *pois, const uint8_t *live,
                 uint32_t poi_count);

#endif
