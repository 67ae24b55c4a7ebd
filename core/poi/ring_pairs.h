/* ring_pairs.h -- contact of two pois in one tank: neither passes through nor holds the other. */
#ifndef KINGYO_CORE_POI_RING_PAIRS_H
#define KINGYO_CORE_POI_RING_PAIRS_H

#include "core/poi/poi.h"

/* Separates two rings after poi_tick() of both, if they overlap or passed through each other in
 * this tick; each moves half. Rings pressed together slide past each other at 0.6 m/s each, so that
 * no hand holds another longer than that takes. The order of a and b has no effect. Returns 1 if
 * they touched; walls and bowls must then be tested again. */
int ring_pairs_separate(struct poi *a, struct poi *b);

#endif
