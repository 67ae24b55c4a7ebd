/* pause.h -- pauses during a round: the clock stops while a controller is lost, for a limited
 * time. */
#ifndef KINGYO_CORE_GAME_PAUSE_H
#define KINGYO_CORE_GAME_PAUSE_H

#include "core/input.h"

/* Longest pause without any active player. The round ends after the pause. */
#define GAME_LOST_TICKS_MAX (60u * CORE_TICK_HZ)
/* Longest single pause for one lost controller while other players could play. */
#define GAME_LOST_TICKS_OTHERS (10u * CORE_TICK_HZ)
/* Longest total pause per round for one lost controller while other players could play. */
#define GAME_WAIT_TICKS_OTHERS (30u * CORE_TICK_HZ)
/* Longest total pause per round without any active player. The limit also ends a round if a loose
 * plug causes many short pauses. */
#define GAME_WAIT_TICKS_MAX POI_WAIT_TICKS_MAX
_Static_assert(GAME_LOST_TICKS_MAX <= GAME_WAIT_TICKS_MAX &&
                   GAME_WAIT_TICKS_OTHERS <= GAME_WAIT_TICKS_MAX,
               "no wait outlasts the seat that is kept");

struct game;
struct world;

/* Runs one tick of the pause logic, before the other steps of a round. The round pauses while time
 * is left and a player who is not out has lost the controller. During a pause the clock stops and
 * dips are blocked. A player is out if the other players have waited too long, in one pause
 * (GAME_LOST_TICKS_OTHERS) or in total (GAME_WAIT_TICKS_OTHERS). */
void pause_tick(struct game *game, const struct world *world);

/* Returns 1 if player `index` has a poi in use: its source is the bot or a connected controller
 * with valid input. */
int pause_holds(const struct world *world, uint32_t index);

/* Returns 1 if no player has been active for so long that the round ends, otherwise 0. */
int pause_is_over(const struct game *game);

#endif
