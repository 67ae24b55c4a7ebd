/* buttons_gpio.h -- the cabinet's buttons, coins, lamps, coin meter and ticket dispenser on GPIO
 * lines. */
#ifndef KINGYO_DRIVERS_GPIO_BUTTONS_GPIO_H
#define KINGYO_DRIVERS_GPIO_BUTTONS_GPIO_H

#include "drivers/gpio/gpio_thread.h"

struct buttons_gpio {
    struct gpio_thread reader;
    char text[HAL_TEXT_SIZE]; /* Buffer for the result of describe(). */
};

/* Requests the wired lines of `wires` (gpio_config.h) and starts the reader thread. The caller
 * owns `gpio`, which must not move until it is stopped. Returns HAL_OK even if lines are
 * missing. Missing lines are described by describe() and buttons_gpio_why() and are requested
 * again each second. Returns HAL_ERR_IO if there is no thread; nothing must then be stopped. */
int buttons_gpio_start(struct buttons_gpio *gpio, struct gpio_lines lines,
                       const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* Returns the input device. Each press and each coin is in exactly one sample. */
struct hal_buttons buttons_gpio_device(struct buttons_gpio *gpio);

/* Returns the output device. Roles that are not wired return HAL_ERR_ABSENT. Lamps and locks
 * change within GPIO_WAIT_MS_MAX. */
struct hal_switches buttons_gpio_switches(struct buttons_gpio *gpio);

/* Copies to `out` why the line of `role` is missing, or "" if the line is held or not wired. */
void buttons_gpio_why(struct buttons_gpio *gpio, enum gpio_role role, char out[HAL_TEXT_SIZE]);

/* Stops the reader as gpio_thread_stop(): coins are locked out, lamps go off, and the lines are
 * released to their bias (gpio_config.h). */
void buttons_gpio_stop(struct buttons_gpio *gpio);

#endif
