/* gpio_config.h -- parses the wiring of a cabinet, such as "start=BTN_START" or
 * "coin=pinctrl-bcm2711:17".
 *
 * Each wiring text has the form
 *
 *     ROLE=LINE[,WORD...]
 *
 * ROLE is one of start, left, right, ok, test, service, tilt, coin, coin2, coin3, door,
 * start-lamp, coin-lockout, ticket and coin-counter. LINE is the name of a GPIO line, or
 * CHIP:OFFSET, where CHIP is the label of the chip. Each WORD is an option. A time in an option is
 * a whole number followed by us, ms or s. The options are:
 *
 *     low, high          Level that means pressed, lit or locked. The default is low for inputs
 *                        and for coin-lockout, and high for other outputs.
 *     up, down, float,   Bias of the line. By default, the bias pulls an input to its released
 *     as-is              level and coin-lockout to its locked level. For each other output, the
 *                        default is as-is, which leaves the bias unchanged.
 *     debounce=5ms       Time for which a level must be stable.
 *     window=15ms-250ms  Shortest and longest width of a coin pulse.
 *     pulse=100ms/100ms  Length of an output pulse, and length of the pause after it.
 *
 * coin-lockout drives the coil of a coin lock, which admits coins only while the coil has current.
 * When the kiosk program ends for any reason, most chips turn the coin-lockout line into an input.
 * Only the bias then sets the level of the line. The bias must lock the coin lock, because no one
 * counts coins while the program is not running.
 *
 * Pure: uses no device and no clock. */
#pragma once

#include "drivers/gpio/gpio_lines.h"

/* Upper limit of all times in a wiring text in microseconds. No button, coin acceptor or coin meter
 * needs more than 10 s. */
#define GPIO_TIME_US_MAX 10000000u

/* Returns the name of a role in wiring texts, logs and tables, such as "coin-lockout". */
const char *gpio_role_name(enum gpio_role role);

/* Returns the role whose name is the first `length` bytes of `name`, or GPIO_ROLE_COUNT if there is
 * none. '_' matches '-', and upper case matches lower case. */
enum gpio_role gpio_role_find(const char *name, size_t length);

/* Parses `text` and stores the wire of the role that the text names in `wires`. Times that the text
 * omits get their defaults. Returns true. On an error, returns false, leaves `wires` unchanged, and
 * writes the invalid word to `why`. */
bool gpio_wire_read(const char *text, struct gpio_wire wires[GPIO_ROLE_COUNT],
                    char why[HAL_TEXT_SIZE]);

/* Returns true if no two roles use the same line. Otherwise returns false and writes the names of
 * the two roles and of the line to `why`. */
bool gpio_config_agrees(const struct gpio_wire wires[GPIO_ROLE_COUNT], char why[HAL_TEXT_SIZE]);

/* Returns the number of wired roles. */
uint32_t gpio_config_count(const struct gpio_wire wires[GPIO_ROLE_COUNT]);

/* Size of the buffer for gpio_wire_text(). */
#define GPIO_WIRE_TEXT_SIZE (2u * GPIO_TEXT_SIZE + 12u)
/* Writes the name of a line for messages, such as "BTN_START" or "gpio-sim.0:4". */
void gpio_wire_text(const struct gpio_wire *wire, char out[GPIO_WIRE_TEXT_SIZE]);

/* Returns a copy of `wire` in which the default of `role` replaces each time of 0. */
struct gpio_wire gpio_wire_filled(const struct gpio_wire *wire, enum gpio_role role);
