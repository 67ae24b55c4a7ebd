/* gpio_chips.h -- lists the lines of a GPIO chip.
 *
 * gpio_chips1.c implements the function for libgpiod 1.6, and gpio_chips2.c for libgpiod 2.x. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_CHIPS_H
#define KINGYO_DRIVERS_GPIO_GPIO_CHIPS_H

#include "drivers/gpio/gpio_lines.h"

/* Calls `tell` for every line of the chip at `path`. Returns the number of lines, or 0 if the chip
 * cannot be opened. */
uint32_t gpio_chips_list(const char *path,
                         void (*tell)(void *context, const struct gpio_line_info *line),
                         void *context);

#endif
