/* bowl_buoyancy.h -- motion of the bowls under weight, buoyancy, ripples and soft moorings.
 *
 * A bowl sinks by a tenth of a millimetre with each fish and rocks when a fish drops in. A bowl
 * tilts with the slope of the water and drifts back after a push. The rules of the
 * goldfish-scooping federation forbid players to touch a bowl with the free hand. Therefore only
 * the ring of a poi (paper scoop) can push a bowl. The ring of any player can push any bowl. Tank
 * walls and other bowls stop a bowl. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_BUOYANCY_H
#define KINGYO_CORE_POI_BOWL_BOWL_BUOYANCY_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"

/* Advances every bowl of the stall by one tick (1/120 s). The caller calls this function after the
 * tick of the pois and before the tick of the fish. pois[i] pushes the bowls that it touches if
 * live[i] is set, for i < `poi_count`. A bowl above its largest mass loses water. */
void bowl_buoyancy_tick(const struct stall *stall, const struct poi *pois, const uint8_t *live,
                        uint32_t poi_count);

#endif
