/* gpio_wires.h -- how a cabinet's wiring is written: "start=BTN_START", "coin=pinctrl-bcm2711:17".
 *
 *     ROLE=LINE[,WORD...]
 *
 * ROLE: start left right ok test service tilt coin coin2 coin3 door, start-lamp
 * coin-lockout ticket coin-counter. LINE: the line's name, or CHIP:OFFSET with the chip's label.
 * WORDs:
 *     low, high         the level that means pressed, lit or locked: low for inputs and for
 *                       coin-lockout, high for the other outputs
 *     up, down, float   the bias; inputs that are low when pressed have up, those that are high
 *                       down, coin-lockout the level that locks, outputs what they had (as-is)
 *     debounce=5ms      how long a level must stand before it counts
 *     window=15ms-250ms how long a coin's pulse lasts
 *     pulse=100ms/100ms an output's pulse and the rest behind it
 * coin-lockout drives a coil that lets coins in while it has current: a line is let go with the
 * kiosk, however that ends, and most chips then make an input of it. Nothing drives it from there
 * on but its bias, so that a lock whose rest is open takes coins that nobody counts.
 * A time is a whole number with us, ms or s. Pure. */
#ifndef KINGYO_DRIVERS_GPIO_WIRES_H
#define KINGYO_DRIVERS_GPIO_WIRES_H

#include "drivers/gpio_lines.h"

#define GPIO_TIME_US_MAX 10000000u /* No button, coin or meter takes longer than 10 s. */

/* "coin-lockout"; a role's word in wiring, logs and tables. */
const char *gpio_role_name(enum gpio_role role);

/* GPIO_ROLE_COUNT where `name` (`length` bytes) is no role's. '_' is taken for '-', case is no
 * matter. */
enum gpio_role gpio_role_find(const char *name, size_t length);

/* Reads `text` into its role's wire, every time set: a role that was wired before is wired anew.
 * False: `wires` is untouched and `why` says what is wrong with which word. */
bool gpio_wire_read(const char *text, struct gpio_wire wires[GPIO_ROLE_COUNT],
                    char why[HAL_TEXT_SIZE]);

/* False: two roles are on one line, which `why` names. */
bool gpio_wires_agree(const struct gpio_wire wires[GPIO_ROLE_COUNT], char why[HAL_TEXT_SIZE]);

/* How many roles are wired. */
uint32_t gpio_wires_count(const struct gpio_wire wires[GPIO_ROLE_COUNT]);

/* "BTN_START" or "gpio-sim.0:4": how people are told which line is meant. */
#define GPIO_WIRE_TEXT_SIZE (2u * GPIO_TEXT_SIZE + 12u)
void gpio_wire_text(const struct gpio_wire *wire, char out[GPIO_WIRE_TEXT_SIZE]);

/* A wire whose times of 0 are the role's own. */
struct gpio_wire gpio_wire_filled(const struct gpio_wire *wire, enum gpio_role role);

#endif
