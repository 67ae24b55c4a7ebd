/* ring_pairs.h -- handles contact between two pois (paper scoops) in one tank.
 *
 * Rings do not pass through each other, and no ring can block another ring for long. */
#ifndef KINGYO_CORE_POI_RING_PAIRS_H
#define KINGYO_CORE_POI_RING_PAIRS_H

#include "core/poi/poi.h"

/* Separates two rings that overlap, or that passed through each other in this tick. Each ring moves
 * by half of the overlap. The caller must have called poi_tick() for both pois. Rings that press
 * against each other slide apart at 0.6 m/s each, so that no player can block another player's ring
 * for long. The order of `a` and `b` has no effect. Returns 1 if the rings touched, otherwise 0. If
 * the result is 1, the caller must apply the constraints of walls and bowls again. */
int ring_pairs_separate(struct poi *a, struct poi *b);

#endif
