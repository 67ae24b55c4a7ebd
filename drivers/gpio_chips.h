/* gpio_chips.h -- a look at every line of a GPIO chip; gpio_chips1.c and gpio_chips2.c, a libgpiod
 * each. */
#ifndef KINGYO_DRIVERS_GPIO_CHIPS_H
#define KINGYO_DRIVERS_GPIO_CHIPS_H

#include "drivers/gpio_lines.h"

/* Tells every line of the chip at `path`. Returns how many there are; 0 where it may not be
 * opened. */
uint32_t gpio_chips_tell(const char *path,
                         void (*tell)(void *context, const struct gpio_line_info *line),
                         void *context);

#endif
