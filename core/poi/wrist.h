/* wrist.h -- rotation of the ring of a poi (paper scoop).
 *
 * The player's wrist turns the ring, the water resists, and a poi without wrist input tips its fish
 * into the bowl automatically. */
#ifndef KINGYO_CORE_POI_WRIST_H
#define KINGYO_CORE_POI_WRIST_H

#include "core/poi/poi.h"

/* Updates progress and direction of the automatic tip over the bowl. A poi tips while fish lie
 * on it and for half a second more. The poi tips back if it carries no fish or if `has_wrist` is
 * set. */
void wrist_tip(struct poi *poi, const struct bowl *bowl, int has_wrist);

/* Returns `target` tipped toward the bowl by the progress that wrist_tip() stored in `poi`. */
struct poi_target wrist_target(const struct poi *poi, const struct bowl *bowl,
                               struct poi_target target);

/* Rotates the ring toward `goal` for one tick. The wrist is a critically damped spring that lags
 * by 25 ms in air. Under water, the added inertia and the drag of the water act against the
 * rotation. */
void wrist_turn(struct poi *poi, struct angles goal);

#endif
