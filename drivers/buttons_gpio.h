/* buttons_gpio.h -- the cabinet's buttons, coins, lamps, meter and dispenser on GPIO lines. */
#ifndef KINGYO_DRIVERS_BUTTONS_GPIO_H
#define KINGYO_DRIVERS_BUTTONS_GPIO_H

#include "drivers/gpio_reader.h"

struct buttons_gpio {
    struct gpio_reader reader;
    char text[HAL_TEXT_SIZE]; /* What was described last. */
};

/* Asks for the wired lines of `wires` (gpio_wires.h) and starts the reader's thread. The caller
 * owns `gpio`, which must not move until it is stopped. HAL_OK even where lines are missing, which
 * describe() and buttons_gpio_why() tell and which are asked for again each second; HAL_ERR_IO:
 * there is no thread, and nothing is to be stopped. */
int buttons_gpio_start(struct buttons_gpio *gpio, struct gpio_lines lines,
                       const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* A press is in exactly one sample, a coin is counted in exactly one. */
struct hal_buttons buttons_gpio_device(struct buttons_gpio *gpio);

/* What is not wired answers HAL_ERR_NONE. Lamps and locks change within GPIO_WAIT_MS_MAX. */
struct hal_switches buttons_gpio_switches(struct buttons_gpio *gpio);

/* Why the line of `role` could not be had; "" where it is, or is not wired. Copied to `out`. */
void buttons_gpio_why(struct buttons_gpio *gpio, enum gpio_role role, char out[HAL_TEXT_SIZE]);

/* As gpio_reader_stop(): coins are locked out, lamps go out; then the lines are let go, and what
 * nobody drives is as its wiring rests (gpio_wires.h). */
void buttons_gpio_stop(struct buttons_gpio *gpio);

#endif
