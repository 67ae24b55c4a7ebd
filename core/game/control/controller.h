/* controller.h -- the controllers of the pois: a person, the bot, or no one. This module turns
 * their input into the target pose of each poi. */
#ifndef KINGYO_CORE_GAME_CONTROL_CONTROLLER_H
#define KINGYO_CORE_GAME_CONTROL_CONTROLLER_H

#include "core/input.h"

struct world;
struct core_config;
struct settings;
struct game;

/* Returns 1 if the poi is in use: it has a bowl and a controller, which may be lost. */
int controller_is_active(const struct world *world, uint32_t index);

/* Returns a copy of the input with each slot's calibration applied to its pose. */
struct input controller_calibrate(const struct settings *settings, const struct input *said);

/* Validates the pose of each controller (input_validation.h). Call once per tick before all other
 * steps. */
void controller_validate(struct game *game, const struct input *input);

/* Returns 1 if the controller of a poi in use is disconnected or its input is invalid. The poi then
 * moves out of the water, takes no damage, and waits. */
int controller_is_lost(const struct world *world, uint32_t index);

/* Returns 1 if a person's controller moves down through GAME_DIP_Y_M in this tick, whether or not
 * the slot has a poi. */
int controller_dip_pressed(const struct game *game, const struct input *input, uint32_t index);

/* Writes the source of each poi for the present phase. In attract mode the built-in bot controls
 * the first poi, even if controllers are connected, and no other poi is in use. */
void controller_assign(const struct game *game, struct world *world, const struct input *input);

/* Moves each poi's target pose toward its source's pose. The target stays within arm's reach, and
 * above the water while dips are not allowed. A change of the source is blended. An input loss
 * moves the poi out of the water, and restored input moves it gently back. A motion too fast for an
 * arm or wrist is ignored for a sixteenth of a second if it could damage paper or lose a fish. */
void controller_tick_all(struct game *game, struct world *world, const struct core_config *config,
                         const struct input *input, struct poi_target targets[POI_MAX],
                         uint8_t live[POI_MAX]);

/* Cancels the return of a poi that has a new source or a new position. */
void controller_forget_path(struct game *game, uint32_t index);

#endif
