/* controller.h -- the sources of the pois' poses: a person's controller, the bot, or none. Computes
 * the target pose of each poi from the pose of its source. */
#ifndef KINGYO_CORE_GAME_CONTROL_CONTROLLER_H
#define KINGYO_CORE_GAME_CONTROL_CONTROLLER_H

#include "core/input.h"

struct world;
struct core_config;
struct settings;
struct game;

/* Returns 1 if the poi is in use, otherwise 0. A poi is in use if it has a bowl and a source; a
 * lost controller counts as a source. */
int controller_is_active(const struct world *world, uint32_t index);

/* Returns a copy of the input `said` with each slot's calibration applied to its pose. */
struct input controller_calibrate(const struct settings *settings, const struct input *said);

/* Validates the pose of each controller (input_validation.h). Call once per tick before all other
 * steps of the game. */
void controller_validate(struct game *game, const struct input *input);

/* Returns 1 if a poi in use has lost its controller, otherwise 0. A controller is lost while it is
 * disconnected or its input is invalid. The poi then moves out of the water, takes no damage, and
 * waits. */
int controller_is_lost(const struct world *world, uint32_t index);

/* Returns 1 if the pose of a person's controller moves down through GAME_DIP_Y_M in this tick,
 * otherwise 0. The slot need not have a poi. */
int controller_dip_pressed(const struct game *game, const struct input *input, uint32_t index);

/* Writes the source of each poi in the current phase. In attract mode the built-in bot controls the
 * first poi, even if controllers are connected, and no other poi is in use. */
void controller_assign(const struct game *game, struct world *world, const struct input *input);

/* Moves each poi's target pose toward the pose of its source. The target stays within arm's reach,
 * and above the water while dips are not allowed. After a change of the source, the old and the new
 * pose are blended. An input loss moves the poi out of the water, and restored input moves the poi
 * gently back. A motion too fast for an arm or wrist is ignored for a fifteenth of a second if the
 * motion could damage paper or lose a fish. */
void controller_tick_all(struct game *game, struct world *world, const struct core_config *config,
                         const struct input *input, struct poi_target targets[POI_MAX],
                         uint8_t live[POI_MAX]);

/* Cancels the return of a poi that has a new source or a new position. */
void controller_forget_path(struct game *game, uint32_t index);

#endif
