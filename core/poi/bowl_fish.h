/* bowl_fish.h -- the fish in a bowl: they mill round, each at its own depth, width and pace, and
 * none swims in another. */
#ifndef KINGYO_CORE_POI_BOWL_FISH_H
#define KINGYO_CORE_POI_BOWL_FISH_H

#include "core/poi/bowl.h"

/* One tick: the fish go along with the bowl, swim, and keep out of one another and of the hull.
 * Counts and weighs them. */
void bowl_fish_tick(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* How deep two fish that swim level lie in one another, m; <= 0: apart. */
float bowl_fish_overlap_m(const struct fish *a, const struct fish *b);

#endif
