/* gpio_chips.h -- a look at every GPIO line there is; gpio_chips1.c and gpio_chips2.c, a libgpiod
 * each. */
#ifndef KINGYO_DRIVERS_GPIO_CHIPS_H
#define KINGYO_DRIVERS_GPIO_CHIPS_H

#include "drivers/gpio_lines.h"

/* As gpio_lines_ops.list. */
int gpio_chips_list(void (*tell)(void *context, const struct gpio_line_info *line), void *context);

#endif
