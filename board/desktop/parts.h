/* parts.h -- the desktop board, part by part: each file keeps the devices of one part, and wires
 * them into struct hal. board.c calls them in this order. */
#ifndef KINGYO_BOARD_DESKTOP_PARTS_H
#define KINGYO_BOARD_DESKTOP_PARTS_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/buttons_join.h"
#include "platform/board.h"

/* The display, and SDL's video with it. */
void screen_open(struct hal *hal, const struct board_options *options);

/* Events of these SDL types are not even queued: nobody takes them. */
void screen_ignore(const uint32_t *types, size_t count);

/* Whoever may hold a poi, shared out among the seats, and his fan. */
void hands_open(struct hal *hal, const struct board_options *options);

/* The buttons that controllers have themselves. */
void hands_add_buttons(struct buttons_join *join);

void hands_close(void);

/* Every button there is, as one panel; after hands_open(). */
void panel_open(struct hal *hal, const struct board_options *options);

/* Sound and store. */
void store_open(struct hal *hal, const struct board_options *options);

void watchdog_open(struct hal *hal);

#endif
