/* wrist.h -- rotation of the ring: by the hand, against the water, and over the bowl. */
#ifndef KINGYO_CORE_POI_WRIST_H
#define KINGYO_CORE_POI_WRIST_H

#include "core/poi/poi.h"

/* Updates the tip of a poi without wrist input over its bowl, in angle and direction: while fish
 * lie on it, and for half a second more. Without fish, or with `has_wrist`, it tips back. */
void wrist_tip(struct poi *poi, const struct bowl *bowl, int has_wrist);

/* Returns the hand's target, tipped toward the bowl by the state of wrist_tip(). */
struct poi_target wrist_target(const struct poi *poi, const struct bowl *bowl,
                               struct poi_target target);

/* Rotates the ring toward `goal` for one tick: a critically damped wrist that lags by 25 ms in air.
 * Under water a disc that rotates about its own diameter moves water along and pushes it. */
void wrist_turn(struct poi *poi, struct angles goal);

#endif
