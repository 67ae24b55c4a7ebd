/* bowl_fish.h -- the fish in a bowl: each circles at its own depth, radius and speed, without
 * overlap. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_FISH_H
#define KINGYO_CORE_POI_BOWL_BOWL_FISH_H

#include "core/poi/bowl/bowl.h"

/* Advances one tick: the fish move along with the bowl, swim, and keep clear of each other and of
 * the hull. Counts and weighs them. */
void bowl_fish_tick(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* Returns the penetration depth of two fish that swim level, m; <= 0: apart. */
float bowl_fish_overlap_m(const struct fish *a, const struct fish *b);

#endif
