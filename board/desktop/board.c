/* board.c -- the desktop board: a window, all kinds of controllers, a keyboard as buttons, sound
 * and disk.
 *
 * Opens all drivers and connects each driver to its part of struct hal (parts.h). Also opens the
 * sound and the store, and connects the watchdog of the service manager. */
#include "platform/board.h"

#include <stdlib.h>

#include "board/desktop/parts.h"
#include "core/base/panic.h"
#include "drivers/null.h"
#include "platform/audio.h"
#include "platform/kiosk/recorder/pin_sweep.h"
#include "platform/os/clock.h"
#include "platform/store/storage.h"
#include "platform/watchdog.h"

static struct {
    struct audio audio;
    struct storage storage;
    struct watchdog watchdog;
    struct pin_sweep sweep;
} devices;

/* Opens the sound and the store. If a device is missing, its describe() names the problem, and its
 * other functions have no effect. */
static void store_open(struct hal *hal, const struct board_options *options)
{
    if (!options->mute) {
        hal->audio = audio_device(&devices.audio);
        hal->audio.ops->open(hal->audio.self);
    }
    if (options->data_dir) {
        devices.storage.dir = options->data_dir;
        devices.storage.chore = pin_sweep_chore(&devices.sweep);
        hal->storage = storage_device(&devices.storage);
        hal->storage.ledger.ops->open(hal->storage.ledger.self);
    } else {
        hal->storage = null_storage("no store: HOME is not set; --data DIR keeps the scores");
    }
}

/* Connects the watchdog of the service manager. If the service manager has no watchdog, the null
 * watchdog of struct hal stays connected. */
static void store_open_watchdog(struct hal *hal)
{
    const char *usec = getenv("WATCHDOG_USEC");
    if (watchdog_init(&devices.watchdog, hal->clock, getenv("NOTIFY_SOCKET"),
                      usec ? strtoull(usec, NULL, 10) : 0) == HAL_OK) {
        hal->watchdog = watchdog_device(&devices.watchdog);
    }
}

void board_open(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(hal && options);
    *hal = null_hal();
    hal->clock = clock_device();
    screen_open(hal, options);
    if (!options->off_screen) {
        controllers_open(hal, options);
        panel_open(hal, options);
    }
    store_open(hal, options);
    store_open_watchdog(hal);
}

void board_release_store(struct hal *hal)
{
    hal->audio.ops->close(hal->audio.self);
    /* The store may already be closed. A second call of close() has no effect. */
    hal->storage.ledger.ops->close(hal->storage.ledger.self);
    panel_close();
    controllers_close();
}

void board_close(struct hal *hal)
{
    board_release_store(hal);
    hal->display.ops->close(hal->display.self);
}
