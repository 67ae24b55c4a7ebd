/* bowl_fish.h -- the motion of the fish in a bowl.
 *
 * Each fish circles at its own depth, radius and speed, and the fish do not overlap. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_FISH_H
#define KINGYO_CORE_POI_BOWL_BOWL_FISH_H

#include "core/poi/bowl/bowl.h"

/* Advances the fish of one bowl by one tick (1/120 s). The fish move along with the bowl, swim, and
 * stay clear of each other and of the hull. Updates the bowl's mass of fish. Does nothing for an
 * absent or empty bowl. */
void bowl_fish_tick(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* Returns the overlap of two level fish in metres; a result of at most 0 means that the fish are
 * apart. */
float bowl_fish_overlap_m(const struct fish *a, const struct fish *b);

#endif
