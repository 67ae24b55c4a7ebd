/* huddle.h -- several fish on one paper: they lie beside one another, not in one another. */
#ifndef KINGYO_CORE_POI_HUDDLE_H
#define KINGYO_CORE_POI_HUDDLE_H

#include "core/poi/poi.h"

/* One tick: riders that share a place on the paper push each other aside, the lighter more. The
 * ring holds whom that moves against it, until there is no room at all: then it is squeezed over.
 * Who is in the air is in nobody's way. `fish` is the tank's. */
void huddle_tick(struct poi *poi, const struct fish *fish);

/* How deep two riders lie in one another, in the paper's plane; <= 0: apart. */
float huddle_overlap_m(const struct rider *a, const struct fish *fish_a, const struct rider *b,
                       const struct fish *fish_b);

#endif
