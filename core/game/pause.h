/* pause.h -- a hand is lost in the round: the clock stands still, but not for ever. */
#ifndef KINGYO_CORE_GAME_PAUSE_H
#define KINGYO_CORE_GAME_PAUSE_H

#include "core/input.h"

#define GAME_LOST_TICKS_MAX (60u * CORE_TICK_HZ)    /* Nobody comes back: the round ends. */
#define GAME_LOST_TICKS_OTHERS (10u * CORE_TICK_HZ) /* So long the others wait for one hand. */
#define GAME_WAIT_TICKS_OTHERS (30u * CORE_TICK_HZ) /* So long in all of a round; ... */
#define GAME_WAIT_TICKS_MAX POI_WAIT_TICKS_MAX      /* ... and so long while nobody is there: a plug
                                                       that comes and goes ends a round too. */
_Static_assert(GAME_LOST_TICKS_MAX <= GAME_WAIT_TICKS_MAX &&
                   GAME_WAIT_TICKS_OTHERS <= GAME_WAIT_TICKS_MAX,
               "no wait outlasts the seat that is kept");

struct core;

/* One tick of the round before all else: notes who holds a poi, and whether somebody is waited for:
 * whoever plays, is not out and has time left. While so, the round's clock is held back and nothing
 * can be scooped. Whom the others have waited for long enough, at once or in all, is out. */
void pause_tick(struct core *core);

/* Whether player `index` has its poi in hand: a live controller's or the bot's. */
int pause_holds(const struct core *core, uint32_t index);

/* Whether everybody has been away for so long that the round is over. */
int pause_is_over(const struct core *core);

#endif
