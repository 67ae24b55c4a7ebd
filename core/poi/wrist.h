/* wrist.h -- how the ring is turned: after the hand, against the water, and over its bowl. */
#ifndef KINGYO_CORE_POI_WRIST_H
#define KINGYO_CORE_POI_WRIST_H

#include "core/poi/poi.h"

/* Of a hand that cannot turn: how far the poi tips over its bowl now, and which way: while
 * fish lie on it, and for half a second more. Empty, or with `has_wrist`, it tips back. */
void wrist_tip(struct poi *poi, const struct bowl *bowl, int has_wrist);

/* The hand's target, tipped toward the bowl as far as wrist_tip() says. */
struct poi_target wrist_target(const struct poi *poi, const struct bowl *bowl,
                               struct poi_target target);

/* Turns the ring toward `goal` for a tick: a critically damped wrist, that lags by 25 ms in air. A
 * disc that turns about its own diameter under water takes water along and pushes it. */
void wrist_turn(struct poi *poi, struct angles goal);

#endif
