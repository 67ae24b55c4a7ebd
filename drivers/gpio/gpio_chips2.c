/* gpio_chips2.c -- lists the lines of a chip with libgpiod 2.x. */
#include "drivers/gpio/gpio_chips.h"

#include <gpiod.h>

#include "drivers/gpio/gpio_dev.h"

static uint32_t tell_lines(struct gpiod_chip *chip, struct gpiod_chip_info *chip_info,
                           void (*tell)(void *context, const struct gpio_line_info *line),
                           void *context)
{
    const size_t line_count = gpiod_chip_info_get_num_lines(chip_info);
    uint32_t count = 0;
    for (unsigned int offset = 0; offset < line_count; offset++) {
        struct gpiod_line_info *line = gpiod_chip_get_line_info(chip, offset);
        if (!line) {
            continue;
        }
        struct gpio_line_info info = {
            .offset = offset,
            .used = gpiod_line_info_is_used(line),
            .is_output = gpiod_line_info_get_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT,
            .active_low = gpiod_line_info_is_active_low(line),
        };
        gpio_dev_text(info.device, gpiod_chip_info_get_name(chip_info));
        gpio_dev_text(info.chip, gpiod_chip_info_get_label(chip_info));
        gpio_dev_text(info.name, gpiod_line_info_get_name(line));
        gpio_dev_text(info.consumer, gpiod_line_info_get_consumer(line));
        gpiod_line_info_free(line);
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
    struct gpiod_chip_info *info = chip ? gpiod_chip_get_info(chip) : NULL;
    const uint32_t count = info ? tell_lines(chip, info, tell, context) : 0u;
    if (info) {
        gpiod_chip_info_free(info);
    }
    if (chip) {
        gpiod_chip_close(chip);
    }
    return count;
}
