/* hand.h -- the hands on the pois: a person's, the bot's, or none. */
#ifndef KINGYO_CORE_GAME_HAND_H
#define KINGYO_CORE_GAME_HAND_H

#include "core/input.h"

struct core;
struct game;

/* Whether a poi takes part: it has a bowl, and someone to hold it, lost or not. */
int hand_plays(const struct core *core, uint32_t index);

/* What the controllers said, as each seat's calibration sets it right; all else as it is. */
struct input hand_set_right(const struct core *core, const struct input *said);

/* Judges what each controller says (trust.h); once a tick, before all else. */
void hand_read(struct core *core, const struct input *input);

/* Whether the controller of a poi that takes part is away or talks nonsense. Its poi drifts out of
 * the water, its paper is spared, and it waits. */
int hand_is_lost(const struct core *core, uint32_t index);

/* Whether a person's hand goes down through GAME_DIP_Y_M in this tick, poi or no poi. */
int hand_dips(const struct core *core, const struct input *input, uint32_t index);

/* Writes into each poi who holds it in the present phase. In attract the stall's own bot has the
 * first poi, whoever holds a controller, and there is no other. */
void hand_links(struct core *core, const struct input *input);

/* Moves each hand to what its holder wants: within an arm's reach, above the water while nothing
 * may be scooped, smoothly after a change of holder, out of the water while the controller is lost,
 * and gently back to it when it is there again. What no arm or wrist does in a tick is doubted for
 * a sixteenth of a second first, where it could cost paper or a fish. */
void hand_tick_all(struct core *core, const struct input *input,
                   struct poi_target targets[POI_MAX], uint8_t live[POI_MAX]);

/* A poi that is taken over anew, or put elsewhere, is on no way back to any hand. */
void hand_forget_way(struct game *game, uint32_t index);

#endif
