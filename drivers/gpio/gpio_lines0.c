/* gpio_lines0.c -- the backend for a build without libgpiod. The backend reports every line as
 * missing. */
#include <stdio.h>
#include <time.h>

#include "drivers/gpio/gpio_lines.h"

#define NS_PER_MS 1000000

static int none_open(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                     char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    (void)self;
    for (uint32_t i = 0; i < GPIO_ROLE_COUNT; i++) {
        snprintf(why[i], HAL_TEXT_SIZE, "%s",
                 wires[i].wired ? "built without libgpiod: install libgpiod-dev and build again"
                                : "");
    }
    return HAL_ERR_ABSENT;
}

static int none_wait(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms)
{
    const struct timespec time = {
        .tv_sec = timeout_ms / 1000u,
        .tv_nsec = (long)(timeout_ms % 1000u) * NS_PER_MS,
    };
    (void)self;
    (void)out;
    (void)max;
    nanosleep(&time, NULL);
    return 0;
}

static int none_line(void *self, enum gpio_role role)
{
    (void)self;
    (void)role;
    return HAL_ERR_GONE;
}

static int none_set(void *self, enum gpio_role role, int active)
{
    (void)active;
    return none_line(self, role);
}

static int none_list(void *self, void (*tell)(void *context, const struct gpio_line_info *line),
                     void *context)
{
    (void)self;
    (void)tell;
    (void)context;
    return HAL_ERR_ABSENT;
}

static void none_close(void *self)
{
    (void)self;
}

static const char *none_describe(void *self)
{
    (void)self;
    return "built without libgpiod";
}

struct gpio_lines gpio_lines_device(void)
{
    static const struct gpio_lines_ops ops = {
        .open = none_open,
        .wait = none_wait,
        .level = none_line,
        .set = none_set,
        .debounces = none_line,
        .list = none_list,
        .close = none_close,
        .describe = none_describe,
    };
    return (struct gpio_lines){ .ops = &ops, .self = NULL };
}
