/* fouls.h -- the umpire: detects fouls from the motion of pois and fish.
 *
 * Fouls are recorded in every mode, for the hints. In modes with judging rules a foul is also
 * announced and counted. A foul that lasts counts once, and so does a foul that recurs within
 * FOUL_APART_TICKS. The third counted foul ends a player's round. */
#ifndef KINGYO_CORE_GAME_FOULS_H
#define KINGYO_CORE_GAME_FOULS_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/poi/catch/catch.h"
#include "core/scene.h"

#define FOUL_APART_TICKS (2u * CORE_TICK_HZ)
/* Time for which a shadow must rest over fish before the start to be a foul. */
#define FOUL_SHADE_S 1.5f
/* First 1.2 s of READY, in which the player's stance is not checked. In that time a poi moves from
 * the rest position to its controller, and two of the longest frames pass. */
#define FOUL_SETTLE_TICKS 144u

struct game;
struct world;

/* Records a foul of kind `kind` by player `index`. Counts the foul if the mode's rules judge
 * fouls. */
void fouls_commit(struct game *game, uint32_t index, enum foul kind, struct output *output);

/* Checks before the start for shadows held over fish. A fan's shadow is always a foul. A poi's
 * shadow is a foul only if its controller has moved since READY began. */
void fouls_before_start(struct game *game, const struct world *world, struct output *output);

/* Checks how the fish in `caught` came into the bowls. Call once per tick of the round. */
void fouls_of_catch(struct game *game, const struct world *world,
                    const struct catch_result caught[POI_MAX], struct output *output);

#endif
