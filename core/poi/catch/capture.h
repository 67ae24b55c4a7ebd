/* capture.h -- captures fish: a swimming fish over the paper becomes a carried fish if the water is
 * too shallow for the fish to stand upright. */
#ifndef KINGYO_CORE_POI_CATCH_CAPTURE_H
#define KINGYO_CORE_POI_CATCH_CAPTURE_H

#include "core/poi/poi.h"

/* Depth of water over the paper above which a carried fish floats off the paper, in body
 * heights. */
#define CAPTURE_FLOAT_SHARE 1.50f

/* Tries to capture fish `index` of the tank. The caller guarantees that the fish is over intact
 * paper and near it, and that `poi_index` < POI_MAX. Does nothing if the water is deep enough for
 * the fish or if the poi is too steep. If the poi already carries POI_CARRIED_MAX fish, the fish
 * slips off over the ring instead. `axes` are the poi's axes. */
void capture_fish(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
                  uint32_t index, uint32_t tick);

/* Puts a fish that the poi cannot carry back into the water and moves it away from the ring's
 * centre. A caller uses the function if the paper has no room, or if the ring presses the fish
 * against the water surface without lifting it. */
void capture_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish);

/* Returns 1 if the ring presses a fish against a wall of the tank, otherwise 0. The ring and the
 * fish must be within 15 mm of the wall, and the fish must be nearer to the wall than the ring's
 * centre. The ring must move toward the wall, or the hand must push the ring toward the wall. */
int capture_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                      const struct fish *fish);

#endif
