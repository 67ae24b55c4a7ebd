/* gpio_thread_lines.h -- requests and releases the lines of the GPIO thread. A private part of
 * gpio_thread.c. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_THREAD_LINES_H
#define KINGYO_DRIVERS_GPIO_GPIO_THREAD_LINES_H

#include "drivers/gpio/gpio_thread.h"

static inline uint64_t gpio_thread_now_ns(const struct gpio_thread *reader)
{
    return reader->clock.ops->now_ns(reader->clock.self);
}

static inline uint32_t gpio_role_bit(enum gpio_role role)
{
    return 1u << role;
}

/* Returns the outputs that start active, one bit for each role. */
uint32_t gpio_thread_begin_bits(void);

/* Returns the missing lines, one bit for each role. A line is missing if the role is wired but the
 * GPIO thread does not own the line at present. */
uint32_t gpio_thread_missing_bits(const struct gpio_thread *reader);

/* Requests the missing lines. Returns the result of gpio_lines_ops.open. */
int gpio_thread_request_lines(struct gpio_thread *reader);

/* Marks the lines of removed chips as missing. Counts one fault if at least one line is newly
 * missing. */
void gpio_thread_lose_lines(struct gpio_thread *reader);

#endif
