/* board.c -- the desktop board: a window, all kinds of controllers, a keyboard as buttons, sound
 * and disk.
 *
 * Opens all drivers and connects them to struct hal, part by part (parts.h). */
#include "platform/board.h"

#include "board/desktop/parts.h"
#include "drivers/null.h"
#include "platform/os/clock.h"

void board_open(struct hal *hal, const struct board_options *options)
{
    *hal = null_hal();
    hal->clock = clock_device();
    screen_open(hal, options);
    if (!options->off_screen) {
        usb_open(hal, options);
        hands_open(hal, options);
        panel_open(hal, options);
    }
    store_open(hal, options);
    store_open_watchdog(hal);
}

void board_release_store(struct hal *hal)
{
    hal->audio.ops->close(hal->audio.self);
    /* The store may already be closed; a second close() has no effect. */
    hal->storage.ledger.ops->close(hal->storage.ledger.self);
    panel_close();
    hands_close();
    usb_close();
}

void board_close(struct hal *hal)
{
    board_release_store(hal);
    hal->display.ops->close(hal->display.self);
}
