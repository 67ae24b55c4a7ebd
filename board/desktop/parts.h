/* parts.h -- the parts of the desktop board.
 *
 * Each source file owns the devices of one part and connects them to struct hal. board.c calls the
 * open functions in the order of this file. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "drivers/gamepad/gamepads.h"
#include "drivers/input_mux.h"
#include "platform/board.h"

/* Opens the display and SDL's video subsystem. */
void screen_open(struct hal *hal, const struct board_options *options);

/* Makes SDL drop events of the given types before they are queued, because no driver reads them. */
void screen_ignore(const uint32_t *types, size_t count);

/* Opens the USB controllers, game pads and pointers, and assigns all poi devices and fans to the
 * slots. The USB controllers are opened first, so that SDL does not open the devices that the USB
 * driver claims. */
void controllers_open(struct hal *hal, const struct board_options *options);

/* Adds the buttons of the USB controllers, of the game pads and of the pointer to the merged
 * buttons. */
void controllers_add_buttons(struct input_buttons *buttons);

/* Closes the devices of controllers_open(): returns the USB devices to the kernel drivers and ends
 * the event thread. */
void controllers_close(void);
