/* gpio_chips2.c -- what libgpiod 2.x says of every line. */
#include "drivers/gpio_chips.h"

#include <gpiod.h>
#include <stdio.h>

#include "drivers/gpio_dev.h"

static void copy_text(char out[GPIO_TEXT_SIZE], const char *text)
{
    snprintf(out, GPIO_TEXT_SIZE, "%s", text ? text : "");
}

static uint32_t list_chip(struct gpiod_chip *chip, struct gpiod_chip_info *chip_info,
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
        copy_text(info.device, gpiod_chip_info_get_name(chip_info));
        copy_text(info.chip, gpiod_chip_info_get_label(chip_info));
        copy_text(info.name, gpiod_line_info_get_name(line));
        copy_text(info.consumer, gpiod_line_info_get_consumer(line));
        gpiod_line_info_free(line);
        tell(context, &info);
        count++;
    }
    return count;
}

int gpio_chips_list(void (*tell)(void *context, const struct gpio_line_info *line), void *context)
{
    struct gpio_dev_walk walk = { 0 };
    uint32_t count = 0;
    while (gpio_dev_next(&walk)) {
        struct gpiod_chip *chip = gpiod_chip_open(walk.path);
        struct gpiod_chip_info *info = chip ? gpiod_chip_get_info(chip) : NULL;
        count += info ? list_chip(chip, info, tell, context) : 0u;
        if (info) {
            gpiod_chip_info_free(info);
        }
        if (chip) {
            gpiod_chip_close(chip);
        }
    }
    return walk.count > 0 ? (int)count : HAL_ERR_NONE;
}
