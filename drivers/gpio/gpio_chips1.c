/* gpio_chips1.c -- lists the lines of a chip with libgpiod 1.6. */
#include "drivers/gpio/gpio_chips.h"

#include <gpiod.h>

#include "drivers/gpio/gpio_dev.h"

static uint32_t tell_lines(struct gpiod_chip *chip,
                           void (*tell)(void *context, const struct gpio_line_info *line),
                           void *context)
{
    uint32_t count = 0;
    for (uint32_t offset = 0; offset < gpiod_chip_num_lines(chip); offset++) {
        struct gpiod_line *line = gpiod_chip_get_line(chip, offset);
        if (!line) {
            continue;
        }
        struct gpio_line_info info = {
            .offset = offset,
            .used = gpiod_line_is_used(line),
            .is_output = gpiod_line_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT,
            .active_low = gpiod_line_active_state(line) == GPIOD_LINE_ACTIVE_STATE_LOW,
        };
        gpio_dev_text(info.device, gpiod_chip_name(chip));
        gpio_dev_text(info.chip, gpiod_chip_label(chip));
        gpio_dev_text(info.name, gpiod_line_name(line));
        gpio_dev_text(info.consumer, gpiod_line_consumer(line));
        tell(context, &info);
        count++;
    }
    return count;
}

uint32_t gpio_chips_list(const char *path,
                         void (*tell)(void *context, const struct gpio_line_info *line),
                         void *context)
{
    struct gpiod_chip *chip = gpiod_chip_open(path);
    if (!chip) {
        return 0;
    }
    const uint32_t count = tell_lines(chip, tell, context);
    gpiod_chip_close(chip);
    return count;
}
