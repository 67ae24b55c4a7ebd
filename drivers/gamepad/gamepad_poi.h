/* gamepad_poi.h -- provides each game pad as a poi device (the paper scoop) and a fan device of
 * struct hal. All game pads together are one button device. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_POI_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_POI_H

#include "drivers/gamepad/gamepads.h"
#include "platform/hal.h"

/* Returns the poi device of game pad `index` (0 to GAMEPADS_MAX - 1). */
struct hal_poi gamepad_poi_device(struct gamepads *gamepads, uint32_t index);
/* Returns the fan device of game pad `index` (0 to GAMEPADS_MAX - 1). */
struct hal_fan gamepad_poi_fan(struct gamepads *gamepads, uint32_t index);
/* Returns 1 if the game pad `pad` (a struct gamepad) is plugged in, otherwise 0. Processes pending
 * events first. */
int gamepad_poi_is_present(void *pad);

/* Returns the device that reports START, LEFT, RIGHT, OK and LANGUAGE of all game pads. The poi
 * devices must be polled before this device. */
struct hal_buttons gamepad_poi_buttons(struct gamepads *gamepads);

#endif
