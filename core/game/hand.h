/* hand.h -- the hands on the pois: a person's, the bot's, or none. */
#ifndef KINGYO_CORE_GAME_HAND_H
#define KINGYO_CORE_GAME_HAND_H

#include "core/input.h"

struct core;

/* Whether a poi takes part: it has a bowl, and someone to hold it, lost or not. */
int hand_plays(const struct core *core, uint32_t index);

/* Writes into each poi who holds it in the present phase. In attract the stall's own bot has the
 * first poi, whoever holds a controller, and there is no other. */
void hand_links(struct core *core, const struct input *input);

/* Moves each hand to what its holder wants: within an arm's reach, above the water while nothing
 * may be scooped, smoothly after a change of holder, not at all while the controller is lost. */
void hand_tick_all(struct core *core, const struct input *input,
                   struct poi_target targets[POI_MAX], uint8_t live[POI_MAX]);

#endif
