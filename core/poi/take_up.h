/* take_up.h -- a fish that no longer has water enough to stand in becomes a rider. */
#ifndef KINGYO_CORE_POI_TAKE_UP_H
#define KINGYO_CORE_POI_TAKE_UP_H

#include "core/poi/poi.h"

#define TAKE_UP_FLOAT_SHARE 1.50f /* Water over the paper, in body heights: a rider floats off. */

/* Fish `index`, over paper that holds and near it, which the poi takes up unless it can stand or
 * the poi is too steep; for one for which the paper has no room it is a wall, and it slips off over
 * the ring. `axes` are the poi's, `poi_index` < POI_MAX. */
void take_up(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
             uint32_t index, uint32_t tick);

/* Out over the ring, into the water: a fish for which the paper has no room, or one that a ring
 * comes up under and does not lift. */
void take_up_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish);

/* Whether the ring presses a fish against a wall of the tank: it is within 15 mm of one and goes
 * toward it, or its hand pushes that way, and the fish is between, as near to it. */
int take_up_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                      const struct fish *fish);

#endif
