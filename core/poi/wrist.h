/* wrist.h -- rotates the ring of a poi (paper scoop).
 *
 * The player's wrist rotates the ring, and the water resists the rotation. A poi without wrist
 * input tips its fish into the bowl automatically. */
#ifndef KINGYO_CORE_POI_WRIST_H
#define KINGYO_CORE_POI_WRIST_H

#include "core/poi/poi.h"

/* Updates the progress and the direction of the automatic tip over the bowl. A poi is tipped while
 * it carries fish, and for half a second after the last fish left. The poi rotates back if it
 * carries no fish or if `has_wrist` is 1. */
void wrist_tip(struct poi *poi, const struct bowl *bowl, int has_wrist);

/* Returns `target` rotated toward the bowl by the progress of the tip that wrist_tip() stored in
 * `poi`. */
struct poi_target wrist_target(const struct poi *poi, const struct bowl *bowl,
                               struct poi_target target);

/* Rotates the ring toward `goal` for one tick. The wrist is a critically damped spring with a lag
 * of 25 ms in air. Under water, the added inertia and the drag of the water act against the
 * rotation. */
void wrist_turn(struct poi *poi, struct angles goal);

#endif
