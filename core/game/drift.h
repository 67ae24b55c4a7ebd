/* drift.h -- how a poi goes that nobody leads: out of the water by itself, and back to its hand.
 *
 * Both are slow enough that no wet paper of any grade would tear by them, broadside or not, and the
 * poi is marked as spared besides: what a broken cable does costs nobody's paper. */
#ifndef KINGYO_CORE_GAME_DRIFT_H
#define KINGYO_CORE_GAME_DRIFT_H

#include "core/poi/poi.h"

#define DRIFT_HOVER_M 0.060f       /* Where it waits: its lowest edge is clear of the water. */
#define DRIFT_BACK_TICKS_MIN 48u   /* Back to its hand it takes 0.4 s at least. */
#define DRIFT_SPARE_TICKS_MAX 360u /* Its paper is spared on the way for 3 s at most: then a hand
                                      that flees from it is followed with more haste. */

/* Where the hand of a poi is that is lost in this tick: with the ring, whatever it said last. */
struct poi_target drift_begin(const struct poi *poi, struct poi_target hand);

/* Where the hand of a poi that nobody leads is in the next tick, which is at `hand` in this one.
 * What was moving glides to rest first. With fish on it the ring goes level and straight up;
 * without, it slants and leaves the water along its own plane, toward the tank's middle. */
struct poi_target drift_out(const struct poi *poi, struct poi_target hand);

/* The same of a poi that goes back to where its hand is again, `ticks` after it began. */
struct poi_target drift_back(struct poi_target hand, struct poi_target wanted, uint32_t ticks);

/* Whether it is back: from then on the hand leads. */
int drift_is_back(struct poi_target hand, struct poi_target wanted, uint32_t ticks);

#endif
