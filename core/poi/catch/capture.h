/* capture.h -- capture: a fish without enough water to stand in becomes a carried fish. */
#ifndef KINGYO_CORE_POI_CATCH_CAPTURE_H
#define KINGYO_CORE_POI_CATCH_CAPTURE_H

#include "core/poi/poi.h"

/* Water over the paper, in body heights, at which a carried fish floats off. */
#define CAPTURE_FLOAT_SHARE 1.50f

/* Captures fish `index`, which is near intact paper and over it, unless the fish can stand or the
 * poi is too steep. If the paper has no room, it acts as a wall and the fish slips off over the
 * ring. `axes` are the poi's, `poi_index` < POI_MAX. */
void capture_fish(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
                  uint32_t index, uint32_t tick);

/* Moves a fish out over the ring into the water, because the paper has no room for it, or because a
 * ring rises under the fish without lifting it. */
void capture_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish);

/* Returns 1 if the ring presses a fish against a wall of the tank. The ring is within 15 mm of the
 * wall and moves toward it, or its hand pushes that way, and the fish is between them, equally
 * near. */
int capture_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                      const struct fish *fish);

#endif
