/* gpio_lines.h -- buttons, coins and lamps on GPIO lines: what is wired where, and the one small
 * table of functions that each libgpiod has a file for.
 *
 * gpio_lines1.c is for libgpiod 1.6 (Debian 12), gpio_lines2.c for 2.x (Debian 13); pkg-config says
 * which is compiled. gpio_lines_sim.h is their twin. A line is found by its name, else by its
 * chip's label and offset, never by a chip's number, which changes between boots. */
#ifndef KINGYO_DRIVERS_GPIO_LINES_H
#define KINGYO_DRIVERS_GPIO_LINES_H

#include <stddef.h>
#include <stdint.h>

#include "platform/hal.h"

enum gpio_role {
    GPIO_START = 0,
    GPIO_LEFT,
    GPIO_RIGHT,
    GPIO_OK,
    GPIO_TEST,
    GPIO_SERVICE,
    GPIO_TILT,
    GPIO_COIN,
    GPIO_DOOR,
    GPIO_INPUT_COUNT,
    GPIO_START_LAMP = GPIO_INPUT_COUNT, /* From here on outputs, in enum hal_switch's order. */
    GPIO_COIN_LOCKOUT,
    GPIO_TICKET,
    GPIO_COIN_COUNTER,
    GPIO_ROLE_COUNT,
};

#define GPIO_TEXT_SIZE 32u /* As the kernel's GPIO_MAX_NAME_SIZE. */

enum gpio_bias {
    GPIO_BIAS_AS_IS = 0,
    GPIO_BIAS_UP,
    GPIO_BIAS_DOWN,
    GPIO_BIAS_OFF,
};

/* How one role is wired. Zero: it is not. */
struct gpio_wire {
    uint8_t wired;
    char name[GPIO_TEXT_SIZE]; /* Of the line; "": by chip and offset. */
    char chip[GPIO_TEXT_SIZE]; /* The chip's label. */
    uint32_t offset;
    uint8_t active_low;
    uint8_t bias;              /* enum gpio_bias */
    uint32_t debounce_us;      /* 0: the role's own (gpio_wires.h). */
};

/* One edge, as the kernel saw it. */
struct gpio_edge {
    uint64_t time_ns;     /* CLOCK_MONOTONIC, when the kernel took it. */
    uint8_t role;         /* enum gpio_role */
    uint8_t active;       /* After active_low: the level that the edge went to. */
    uint32_t lost_before; /* Edges of this line that the kernel's queue dropped before it. */
};

#define GPIO_EDGES_MAX 64u /* Taken from the kernel at once: what it keeps of a line on 6.1. */

struct gpio_lines_ops {
    /* Asks for every wired line. What cannot be had is left out and told in `why[role]`, one line
     * each with what to do ("BTN_START is held by 'gpio-keys': remove its overlay"). Returns how
     * many lines were had; HAL_ERR_NONE where there is no GPIO at all. */
    int (*open)(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE]);
    /* Waits for edges at most `timeout_ms`; called by the reader thread alone. Returns how many
     * came, oldest first; HAL_ERR_GONE when a chip went away: all its lines are closed. */
    int (*wait)(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms);
    /* The line's level now, after active_low: 0 or 1, or a negative hal_error. Any thread. */
    int (*level)(void *self, enum gpio_role role);
    int (*set)(void *self, enum gpio_role role, int active); /* Outputs. Any thread. */
    /* Whether the kernel debounces this line itself. */
    int (*debounces)(void *self, enum gpio_role role);
    void (*close)(void *self);
    const char *(*describe)(void *self); /* "libgpiod 1.6.3, 5 lines" */
};

struct gpio_lines { const struct gpio_lines_ops *ops; void *self; };

/* The library's own backend; one static state: a kiosk has one cabinet. */
struct gpio_lines gpio_lines_device(void);

#endif
