/* carried_separation.h -- separates the fish on one poi (paper scoop), so that they lie side by
 * side. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_SEPARATION_H
#define KINGYO_CORE_POI_CATCH_CARRIED_SEPARATION_H

#include "core/poi/poi.h"

/* Separates overlapping carried fish for one tick; the lighter fish moves more. The ring stops a
 * fish that is pushed outward. A fish without enough room is pushed over the ring. Fish in the air
 * are ignored. `fish` is the tank's array of fish. */
void carried_separation_tick(struct poi *poi, const struct fish *fish);

/* Returns the overlap of two carried fish in the plane of the paper, in metres. A result of 0 or
 * less means that the fish do not overlap. */
float carried_separation_overlap_m(const struct carried_fish *a, const struct fish *fish_a,
                                   const struct carried_fish *b, const struct fish *fish_b);

#endif
