/* carried_separation.h -- separation of several fish on one paper, so that they lie side by
 * side. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_SEPARATION_H
#define KINGYO_CORE_POI_CATCH_CARRIED_SEPARATION_H

#include "core/poi/poi.h"

/* Advances one tick: carried fish that overlap push each other aside, the lighter fish more. The
 * ring holds a fish moved against it until there is no room left; then the fish is squeezed over
 * the ring. Fish in the air are ignored. `fish` is the tank's. */
void carried_separation_tick(struct poi *poi, const struct fish *fish);

/* Returns the overlap of two carried fish in the plane of the paper, m; <= 0: apart. */
float carried_separation_overlap_m(const struct carried_fish *a, const struct fish *fish_a,
                                   const struct carried_fish *b, const struct fish *fish_b);

#endif
