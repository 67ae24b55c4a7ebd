/* board.c -- the desktop board: a window, all kinds of controllers, a keyboard as buttons, sound
 * and disk.
 *
 * Opens all drivers and connects each driver to its part of struct hal (parts.h). Also merges all
 * buttons (the keyboard, the GPIO lines and the buttons of controllers) into one button device,
 * opens the sound and the store, and connects the watchdog of the service manager.
 *
 * On a desktop the keyboard works with every poi, because Esc must quit. A cabinet ignores all
 * keyboards. */
#include "platform/board.h"

#include <SDL.h>
#include <stdbool.h>
#include <stdlib.h>

#include "board/desktop/parts.h"
#include "core/base/panic.h"
#include "drivers/gpio/gpio_thread.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/null.h"
#include "drivers/pointer/buttons_keyboard.h"
#include "platform/audio.h"
#include "platform/kiosk/recorder/pin_sweep.h"
#include "platform/os/clock.h"
#include "platform/os/log.h"
#include "platform/store/storage.h"
#include "platform/watchdog.h"

static struct {
    struct audio audio;
    struct storage storage;
    struct watchdog watchdog;
    struct pin_sweep sweep;
    struct input_buttons buttons;
    struct buttons_keyboard keyboard;
    struct gpio_thread gpio;
    bool has_gpio;
} devices;

/* ---- Buttons --------------------------------------------------------------------------------- */

static int read_wires(struct gpio_wire wires[GPIO_ROLE_COUNT], const char (*line)[BOARD_LINE_SIZE],
                      uint32_t count, char why[HAL_TEXT_SIZE])
{
    for (uint32_t i = 0; i < count; i++) {
        if (!gpio_wire_read(line[i], wires, why)) {
            return -1;
        }
    }
    return gpio_config_agrees(wires, why) ? 0 : -1;
}

int board_check_lines(const char (*line)[BOARD_LINE_SIZE], uint32_t count, char why[HAL_TEXT_SIZE])
{
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    return read_wires(wires, line, count, why);
}

/* Logs each GPIO line that is missing. Missing lines are requested again while the kiosk runs. */
static void log_missing_lines(const struct gpio_wire wires[GPIO_ROLE_COUNT])
{
    char why[HAL_TEXT_SIZE];
    for (uint32_t role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (wires[role].wired) {
            gpio_thread_why(&devices.gpio, (enum gpio_role)role, why);
            if (why[0]) {
                log_print(LOG_LEVEL_WARNING, "line %s: %s", gpio_role_name((enum gpio_role)role),
                          why);
            }
        }
    }
}

static void open_lines(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(hal->clock.ops);
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE];
    if (options->line_count == 0 || read_wires(wires, options->line, options->line_count, why)) {
        return; /* board_check_lines() has already validated the options, so an error is impossible
                   here. */
    }
    devices.has_gpio =
        gpio_thread_start(&devices.gpio, gpio_lines_device(), wires, hal->clock) == HAL_OK;
    if (!devices.has_gpio) {
        hal->switches = null_hal("no GPIO lines: the GPIO thread cannot be started").switches;
        return;
    }
    log_missing_lines(wires);
    input_buttons_add(&devices.buttons, gpio_thread_buttons(&devices.gpio));
    hal->switches = gpio_thread_switches(&devices.gpio);
}

/* Merges all buttons into one device, and opens the cabinet's GPIO lines. Must be called after
 * controllers_open(). */
static void panel_open(struct hal *hal, const struct board_options *options)
{
    /* The keyboard is disabled, so no driver reads key events. SDL therefore drops them. */
    static const Uint32 types[] = { SDL_KEYDOWN,     SDL_KEYUP,           SDL_TEXTINPUT,
                                    SDL_TEXTEDITING, SDL_TEXTEDITING_EXT, SDL_KEYMAPCHANGED };
    CORE_ASSERT(options);
    devices.buttons = (struct input_buttons){ 0 };
    if (options->keyboard == BOARD_KEYBOARD_OFF) {
        screen_ignore(types, sizeof types / sizeof types[0]);
    } else {
        devices.keyboard = (struct buttons_keyboard){ 0 };
        input_buttons_add(&devices.buttons, buttons_keyboard_device(&devices.keyboard));
    }
    controllers_add_buttons(&devices.buttons);
    /* The GPIO lines are added last, because input_mux joins the descriptions in the order of
     * addition. The earlier descriptions name the keys to press. The description of the GPIO lines
     * names the missing lines. */
    open_lines(hal, options);
    hal->buttons = input_buttons_device(&devices.buttons);
}

/* ---- Sound, store and watchdog --------------------------------------------------------------- */

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
        hal->storage = null_hal("no store: HOME is not set; --data DIR keeps the scores").storage;
    }
}

void board_open(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(hal && options);
    *hal = null_hal(NULL);
    hal->clock = clock_device();
    screen_open(hal, options);
    if (!options->off_screen) {
        controllers_open(hal, options);
        panel_open(hal, options);
    }
    store_open(hal, options);
    /* If the service manager has no watchdog, the null watchdog of struct hal stays connected. */
    const char *usec = getenv("WATCHDOG_USEC");
    if (watchdog_init(&devices.watchdog, hal->clock, getenv("NOTIFY_SOCKET"),
                      usec ? strtoull(usec, NULL, 10) : 0) == HAL_OK) {
        hal->watchdog = watchdog_device(&devices.watchdog);
    }
}

void board_release_store(struct hal *hal)
{
    hal->audio.ops->close(hal->audio.self);
    /* Closes the store. The frame loop may have closed the store before, in which case this call
     * has no effect. */
    hal->storage.ledger.ops->close(hal->storage.ledger.self);
    if (devices.has_gpio) { /* Switches the lamps off, locks out coins, and ends the GPIO thread. */
        gpio_thread_stop(&devices.gpio);
        devices.has_gpio = false;
    }
    controllers_close();
}

void board_close(struct hal *hal)
{
    board_release_store(hal);
    hal->display.ops->close(hal->display.self);
}
