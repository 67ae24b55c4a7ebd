/* gamepad_poi.h -- a game pad as the poi, fan and button devices of struct hal. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_POI_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_POI_H

#include "drivers/gamepad/gamepads.h"
#include "platform/hal.h"

/* Return the poi and the fan of pad `index` < GAMEPADS_MAX. */
struct hal_poi gamepad_poi_device(struct gamepads *gamepads, uint32_t index);
struct hal_fan gamepad_poi_fan(struct gamepads *gamepads, uint32_t index);
/* Returns 1 if the pad `pad` (&pads->pad[index]) is plugged in. Processes pending events first. */
int gamepad_poi_is_present(void *pad);

/* Returns START, LEFT, RIGHT, OK and LANGUAGE of all pads. Must be polled after the pois. */
struct hal_buttons gamepad_poi_buttons(struct gamepads *gamepads);

#endif
