/* pause.h -- pauses during a round: the clock stops while a controller is lost, for a limited
 * time. */
#ifndef KINGYO_CORE_GAME_PAUSE_H
#define KINGYO_CORE_GAME_PAUSE_H

#include "core/input.h"

/* Longest pause without any active player; then the round ends. */
#define GAME_LOST_TICKS_MAX (60u * CORE_TICK_HZ)
/* Longest single pause for one controller while others could play. */
#define GAME_LOST_TICKS_OTHERS (10u * CORE_TICK_HZ)
/* Longest total pause per round for one controller while others could play. */
#define GAME_WAIT_TICKS_OTHERS (30u * CORE_TICK_HZ)
/* Longest total pause per round without any active player, so that a loose plug ends a round
 * too. */
#define GAME_WAIT_TICKS_MAX POI_WAIT_TICKS_MAX
_Static_assert(GAME_LOST_TICKS_MAX <= GAME_WAIT_TICKS_MAX &&
                   GAME_WAIT_TICKS_OTHERS <= GAME_WAIT_TICKS_MAX,
               "no wait outlasts the seat that is kept");

struct game;
struct world;

/* Runs one tick of the pause logic, before the other steps of a round. The round pauses while a
 * player who is not out and has time left has lost the controller. During a pause the clock stops
 * and dips are blocked. A player for whom the others have waited too long, at once or in total, is
 * out. */
void pause_tick(struct game *game, const struct world *world);

/* Returns 1 if player `index` has a poi in use: a live controller or the bot. */
int pause_holds(const struct world *world, uint32_t index);

/* Returns 1 if all players have been away for so long that the round ends. */
int pause_is_over(const struct game *game);

#endif
