/* gpio_chips1.c -- what libgpiod 1.6 says of every line. */
#include "drivers/gpio_chips.h"

#include <gpiod.h>
#include <stdio.h>

#include "drivers/gpio_dev.h"

static void copy_text(char out[GPIO_TEXT_SIZE], const char *text)
{
    snprintf(out, GPIO_TEXT_SIZE, "%s", text ? text : "");
}

static uint32_t list_chip(struct gpiod_chip *chip,
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
        copy_text(info.device, gpiod_chip_name(chip));
        copy_text(info.chip, gpiod_chip_label(chip));
        copy_text(info.name, gpiod_line_name(line));
        copy_text(info.consumer, gpiod_line_consumer(line));
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
        if (chip) {
            count += list_chip(chip, tell, context);
            gpiod_chip_close(chip);
        }
    }
    return walk.count > 0 ? (int)count : HAL_ERR_NONE;
}
