/* panel.c -- merges all buttons into one button device: the keyboard, the GPIO lines, and the
 * buttons of controllers.
 *
 * On a desktop the keyboard works with every poi, because Esc must quit. A cabinet ignores all
 * keyboards. */
#include <SDL.h>
#include <stdio.h>

#include "board/desktop/parts.h"
#include "core/base/panic.h"
#include "drivers/gpio/buttons_gpio.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/null.h"
#include "drivers/pointer/buttons_keyboard.h"
#include "platform/os/log.h"

static struct {
    struct buttons_mux join;
    struct buttons_keyboard keyboard;
    struct buttons_gpio gpio;
    uint8_t has_gpio;
} devices;

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
static void tell_missing(const struct gpio_wire wires[GPIO_ROLE_COUNT])
{
    char why[HAL_TEXT_SIZE];
    for (uint32_t role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (wires[role].wired) {
            buttons_gpio_why(&devices.gpio, (enum gpio_role)role, why);
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
        buttons_gpio_start(&devices.gpio, gpio_lines_device(), wires, hal->clock) == HAL_OK;
    if (!devices.has_gpio) {
        hal->switches = null_switches("no lines: the kernel gives no thread for them");
        return;
    }
    tell_missing(wires);
    buttons_mux_add(&devices.join, buttons_gpio_device(&devices.gpio));
    hal->switches = buttons_gpio_switches(&devices.gpio);
}

/* Makes SDL drop key events, because no driver reads key events while the keyboard is disabled. */
static void ignore_keys(void)
{
    static const Uint32 types[] = { SDL_KEYDOWN,     SDL_KEYUP,           SDL_TEXTINPUT,
                                    SDL_TEXTEDITING, SDL_TEXTEDITING_EXT, SDL_KEYMAPCHANGED };
    screen_ignore(types, sizeof types / sizeof types[0]);
}

static void add_keys(const struct board_options *options)
{
    if (options->keyboard == BOARD_KEYBOARD_OFF) {
        ignore_keys();
    } else {
        devices.keyboard = (struct buttons_keyboard){ 0 };
        buttons_mux_add(&devices.join, buttons_keyboard_device(&devices.keyboard));
    }
}

void panel_open(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(options);
    devices.join = (struct buttons_mux){ 0 };
    add_keys(options);
    controllers_add_buttons(&devices.join);
    /* The GPIO lines are added last, because buttons_mux joins the descriptions in the order of
     * addition. The earlier descriptions name the keys to press. The description of the GPIO lines
     * names the missing lines. */
    open_lines(hal, options);
    hal->buttons = buttons_mux_device(&devices.join);
}

void panel_close(void)
{
    if (devices.has_gpio) {
        buttons_gpio_stop(&devices.gpio);
        devices.has_gpio = 0;
    }
}
