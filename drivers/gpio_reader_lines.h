/* gpio_reader_lines.h -- the reader's lines as they come and go. gpio_reader.c's own. */
#ifndef KINGYO_DRIVERS_GPIO_READER_LINES_H
#define KINGYO_DRIVERS_GPIO_READER_LINES_H

#include "drivers/gpio_reader.h"

static inline uint64_t gpio_reader_now_ns(const struct gpio_reader *reader)
{
    return reader->clock.ops->now_ns(reader->clock.self);
}

static inline uint32_t gpio_role_bit(enum gpio_role role)
{
    return 1u << role;
}

/* Outputs that are active until somebody says otherwise. */
uint32_t gpio_reader_begin_bits(void);

/* Lines that are wired and not held. */
uint32_t gpio_reader_missing_bits(const struct gpio_reader *reader);

/* Asks for what is missing. Answers as gpio_lines_ops.open. */
int gpio_reader_ask(struct gpio_reader *reader);

/* Lets go of what went with its chip: one loss, one fault. */
void gpio_reader_lose_lines(struct gpio_reader *reader);

#endif
