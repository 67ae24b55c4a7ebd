/* parts.h -- the desktop board, part by part: each file keeps the devices of one part, and wires
 * them into struct hal. board.c calls them in this order. */
#ifndef KINGYO_BOARD_DESKTOP_PARTS_H
#define KINGYO_BOARD_DESKTOP_PARTS_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/buttons_join.h"
#include "drivers/pads.h"
#include "drivers/seats.h"
#include "platform/board.h"

/* The display, and SDL's video with it. */
void screen_open(struct hal *hal, const struct board_options *options);

/* Events of these SDL types are not even queued: nobody takes them. */
void screen_ignore(const uint32_t *types, size_t count);

/* Controllers on USB: before hands_open(), so that SDL leaves alone what is claimed here. */
void usb_open(struct hal *hal, const struct board_options *options);
void usb_add_seats(struct seats *seats);
void usb_add_buttons(struct buttons_join *join);

/* What USB has or will have, which no other driver may touch. Returns how many. */
uint32_t usb_bars(struct pad_bar out[PADS_BAR_MAX]);

/* Gives kernel drivers back, ends the thread. */
void usb_close(void);

/* Whoever may hold a poi, shared out among the seats, and his fan. */
void hands_open(struct hal *hal, const struct board_options *options);
void hands_add_buttons(struct buttons_join *join);
void hands_close(void);

/* Every button there is, as one panel, and what the cabinet switches; after hands_open(). */
void panel_open(struct hal *hal, const struct board_options *options);

/* Lamps go out, coins fall through, the thread ends. */
void panel_close(void);

/* Sound and store. */
void store_open(struct hal *hal, const struct board_options *options);

void watchdog_open(struct hal *hal);

#endif
