/* fouls.h -- the umpire: what was done against the rules, found in the motion itself.
 *
 * It is noted in every mode, for the coach; where the rules judge, it is called. What lasts, or
 * follows within FOUL_APART_TICKS, is one incident and called once. The third call ends a player's
 * round. */
#ifndef KINGYO_CORE_GAME_FOULS_H
#define KINGYO_CORE_GAME_FOULS_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/poi/catch.h"
#include "core/scene.h"

#define FOUL_APART_TICKS (2u * CORE_TICK_HZ)
#define FOUL_SHADE_S 1.5f /* A shadow that rests so long over fish before the start is held. */
#define FOUL_SETTLE_TICKS 144u /* 1.2 s of READY: a poi then has come from the stall's hand to its
                                  own, and two of the longest frames are over. */

struct core;

/* Player `index` does in this tick what is a foul of this kind. */
void foul_commit(struct core *core, uint32_t index, enum foul kind, struct output *output);

/* Before the start: who holds a shadow over fish? A fan has nothing to do there, however it came; a
 * poi has to be somewhere, so that of a hand which has rested since READY began is no foul. */
void fouls_before_start(struct core *core, struct output *output);

/* In the round: how fish came into the bowls. */
void fouls_of_catch(struct core *core, const struct catch_result caught[POI_MAX],
                    struct output *output);

#endif
