/* bowl_fish.h -- moves the fish in a bowl.
 *
 * Each fish circles at its own depth, radius and angular speed, and the fish do not overlap. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_FISH_H
#define KINGYO_CORE_POI_BOWL_BOWL_FISH_H

#include "core/poi/bowl/bowl.h"

/* Advances the fish of one bowl by one tick (1/120 s). The fish move along with the bowl, swim, and
 * keep clear of each other and of the hull. Updates `fish_kg` of the bowl. Does nothing if the bowl
 * is absent or empty. */
void bowl_fish_tick(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* Returns the overlap of two level fish in metres. A result of 0 or less means that the fish do not
 * overlap. */
float bowl_fish_overlap_m(const struct fish *a, const struct fish *b);

#endif
