/* buttons_gpio.h -- the cabinet's buttons, coin acceptors, lamps, coin meter and ticket dispenser
 * on GPIO lines. */
#ifndef KINGYO_DRIVERS_GPIO_BUTTONS_GPIO_H
#define KINGYO_DRIVERS_GPIO_BUTTONS_GPIO_H

#include "drivers/gpio/gpio_thread.h"

struct buttons_gpio {
    struct gpio_thread reader;
    char text[HAL_TEXT_SIZE]; /* Buffer for the text that describe() returns. */
};

/* Requests the wired lines of `wires` (gpio_config.h) and starts the GPIO thread. The caller
 * owns `gpio`, which must not move until buttons_gpio_stop(). Returns HAL_OK even if lines are
 * missing. describe() and buttons_gpio_why() name the missing lines, which are requested again
 * each second. Returns HAL_ERR_IO if the thread cannot be created; buttons_gpio_stop() must then
 * not be called. */
int buttons_gpio_start(struct buttons_gpio *gpio, struct gpio_lines lines,
                       const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* Returns the input device. Each button press and each coin is reported in exactly one sample. */
struct hal_buttons buttons_gpio_device(struct buttons_gpio *gpio);

/* Returns the output device. Its functions return HAL_ERR_ABSENT for roles that are not wired.
 * Lamps and locks change within GPIO_WAIT_MS_MAX. */
struct hal_switches buttons_gpio_switches(struct buttons_gpio *gpio);

/* Copies the reason why the line of `role` is missing to `out`. Writes "" if the line is held
 * (requested successfully) or not wired. */
void buttons_gpio_why(struct buttons_gpio *gpio, enum gpio_role role, char out[HAL_TEXT_SIZE]);

/* Waits at most two seconds for unfinished pulses and ends the GPIO thread. Coins are locked out,
 * lamps are switched off, and the lines are released. The bias (gpio_config.h) then sets the level
 * of each line. */
void buttons_gpio_stop(struct buttons_gpio *gpio);

#endif
