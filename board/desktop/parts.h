/* parts.h -- the parts of the desktop board.
 *
 * Each source file owns the devices of one part and connects them to struct hal. board.c calls the
 * open functions in the order of this file. */
#ifndef KINGYO_BOARD_DESKTOP_PARTS_H
#define KINGYO_BOARD_DESKTOP_PARTS_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/buttons_mux.h"
#include "drivers/gamepad/gamepads.h"
#include "drivers/input_mux.h"
#include "platform/board.h"

/* Opens the display and SDL's video subsystem. */
void screen_open(struct hal *hal, const struct board_options *options);

/* Makes SDL drop events of the given types before they are queued, because no driver reads them. */
void screen_ignore(const uint32_t *types, size_t count);

/* Opens the USB controllers. Must be called before hands_open(), so that SDL does not open the
 * devices that the USB driver claims. */
void usb_open(struct hal *hal, const struct board_options *options);

/* Adds the USB controllers to the slots. */
void usb_add_seats(struct input_mux *seats);
/* Adds the buttons of the USB controllers to the merged buttons. */
void usb_add_buttons(struct buttons_mux *join);

/* Copies the USB devices, present or selected, that no other driver may open. Returns their
 * number. */
uint32_t usb_exclusions(struct gamepad_exclusion out[GAMEPADS_EXCLUSION_MAX]);

/* Returns the devices to the kernel drivers and ends the event thread. */
void usb_close(void);

/* Assigns all poi devices and fans to the slots. */
void hands_open(struct hal *hal, const struct board_options *options);

/* Adds the buttons of game pads and of the pointer to the merged buttons. */
void hands_add_buttons(struct buttons_mux *join);

/* Closes the devices of hands_open(). */
void hands_close(void);

/* Merges all buttons into one device, and opens the cabinet's GPIO lines. Must be called after
 * hands_open(). */
void panel_open(struct hal *hal, const struct board_options *options);

/* Switches the lamps off, locks out coins, and ends the GPIO thread. */
void panel_close(void);

/* Opens the sound and the store. */
void store_open(struct hal *hal, const struct board_options *options);

/* Connects the watchdog of the service manager; without one, the null watchdog remains. */
void store_open_watchdog(struct hal *hal);

#endif
