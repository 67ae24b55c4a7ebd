/* bowl_buoyancy.h -- moves the floating bowls: weight, buoyancy, ripples, moorings, and pushes by
 * rings.
 *
 * A bowl sinks by a tenth of a millimetre with each fish and rocks when a fish falls into it. A
 * bowl tilts with the slope of the water surface, and its mooring returns the bowl after a push.
 * The rules of the goldfish-scooping federation forbid players to touch a bowl with the free hand.
 * Therefore only the ring of a poi (paper scoop) can push a bowl, and the ring of any player can
 * push any bowl. Tank walls and other bowls stop a bowl. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_BUOYANCY_H
#define KINGYO_CORE_POI_BOWL_BOWL_BUOYANCY_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"

/* Advances every bowl of the stall by one tick (1/120 s). The caller must call this function after
 * the tick of the pois and before the tick of the fish. For each i < `poi_count` with live[i] set,
 * pois[i] pushes the bowls that its ring touches. A bowl above its largest mass loses water. */
void bowl_buoyancy_tick(const struct stall *stall, const struct poi *pois, const uint8_t *live,
                        uint32_t poi_count);

#endif
