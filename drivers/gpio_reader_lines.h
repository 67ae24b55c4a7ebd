/* gpio_reader_lines.h -- requests and releases the reader's lines. A private part of
 * gpio_reader.c. */
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

/* Returns the outputs that start active. */
uint32_t gpio_reader_begin_bits(void);

/* Returns the wired lines that are not held. */
uint32_t gpio_reader_missing_bits(const struct gpio_reader *reader);

/* Requests missing lines. Returns the result of gpio_lines_ops.open. */
int gpio_reader_ask(struct gpio_reader *reader);

/* Releases the lines of removed chips and counts one fault. */
void gpio_reader_lose_lines(struct gpio_reader *reader);

#endif
