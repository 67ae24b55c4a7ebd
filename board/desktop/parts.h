/* parts.h -- the parts of the desktop board. Each file owns the devices of one part and connects
 * them to struct hal. board.c calls the functions in this order. */
#ifndef KINGYO_BOARD_DESKTOP_PARTS_H
#define KINGYO_BOARD_DESKTOP_PARTS_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/buttons_mux.h"
#include "drivers/gamepad/gamepads.h"
#include "drivers/input_mux.h"
#include "platform/board.h"

/* Opens the display and SDL's video. */
void screen_open(struct hal *hal, const struct board_options *options);

/* Drops events of these SDL types before they are queued, because no driver reads them. */
void screen_ignore(const uint32_t *types, size_t count);

/* Opens the USB controllers. Call before hands_open(), so that SDL skips the devices that are
 * claimed here. */
void usb_open(struct hal *hal, const struct board_options *options);

/* Add the USB controllers to the slots, and their buttons to the panel. */
void usb_add_seats(struct input_mux *seats);
void usb_add_buttons(struct buttons_mux *join);

/* Returns the number of USB devices, present or configured, that no other driver may open. */
uint32_t usb_exclusions(struct gamepad_exclusion out[GAMEPADS_EXCLUSION_MAX]);

/* Returns the devices to the kernel drivers and ends the thread. */
void usb_close(void);

/* Assigns all poi devices and fans to the slots. */
void hands_open(struct hal *hal, const struct board_options *options);

/* Adds the buttons of gamepads to the panel. */
void hands_add_buttons(struct buttons_mux *join);

/* Closes the devices of hands_open(). */
void hands_close(void);

/* Combines all buttons to one panel, and opens the cabinet's outputs. Call after hands_open(). */
void panel_open(struct hal *hal, const struct board_options *options);

/* Switches the lamps off and the coin lockout on, and ends the thread. */
void panel_close(void);

/* Opens sound and store. */
void store_open(struct hal *hal, const struct board_options *options);

/* Connects the watchdog of the service manager, or the null watchdog. */
void store_open_watchdog(struct hal *hal);

#endif
