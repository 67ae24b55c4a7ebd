/* bowl_buoyancy.h -- bowl buoyancy: weight, ripples and soft moorings.
 *
 * A bowl sinks by a tenth of a millimetre with each fish, rocks when a fish drops in, heels with
 * the slope of the water, and drifts back after a push. By the federation's rules the free hand may
 * not touch a bowl, so only the ring of a poi moves it, the ring of any player. Walls and other
 * bowls stop it. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_BUOYANCY_H
#define KINGYO_CORE_POI_BOWL_BOWL_BUOYANCY_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"

/* Advances every bowl of the stall by one tick, after the pois and before the fish. Each of the
 * `poi_count` pois with a set `live` entry pushes the bowls that it touches. Water above the
 * capacity of the hull spills into the tank. */
void bowl_buoyancy_tick(const struct stall *stall, const struct poi *pois, const uint8_t *live,
                        uint32_t poi_count);

#endif
