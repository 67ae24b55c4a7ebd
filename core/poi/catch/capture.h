/* capture.h -- capture: a fish over the paper without enough water to stand in becomes a carried
 * fish. */
#ifndef KINGYO_CORE_POI_CATCH_CAPTURE_H
#define KINGYO_CORE_POI_CATCH_CAPTURE_H

#include "core/poi/poi.h"

/* Depth of water over the paper, in body heights, above which a carried fish floats off. */
#define CAPTURE_FLOAT_SHARE 1.50f

/* Captures fish `index` of the tank. The caller guarantees that the fish is over intact paper and
 * near it, and that `poi_index` < POI_MAX. Does nothing if the fish can stand or if the poi is too
 * steep. If the poi already carries POI_CARRIED_MAX fish, the fish slips off over the ring instead.
 * `axes` are the poi's axes. */
void capture_fish(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
                  uint32_t index, uint32_t tick);

/* Puts a fish that the paper cannot carry back into the water, away from the ring's centre. The
 * paper may have no room, or the ring may press the fish against the surface without lifting it. */
void capture_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish);

/* Returns 1 if the ring presses a fish against a wall of the tank, otherwise 0. Both the ring and
 * the fish must be within 15 mm of the wall, with the fish nearer than the ring's centre. The ring
 * must move toward the wall, or the hand must push the ring toward the wall. */
int capture_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                      const struct fish *fish);

#endif
