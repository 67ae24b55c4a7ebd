/* gpio_lines.h -- GPIO lines for buttons, coins and lamps: wiring, and the interface of a
 * backend.
 *
 * gpio_lines1.c implements the interface for libgpiod 1.6 (Debian 12), gpio_lines2.c for 2.x
 * (Debian 13), and gpio_lines0.c for a build without libgpiod; pkg-config selects one.
 * gpio_lines_sim.h is the simulated twin. A line is found by its name, or by the chip's label
 * and an offset. Chip numbers are not used, because they change between boots. All calls come
 * from one thread, the reader (gpio_thread.h). */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_LINES_H
#define KINGYO_DRIVERS_GPIO_GPIO_LINES_H

#include <stdbool.h>
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
    GPIO_COIN, /* First of COIN_LINE_COUNT coin lines. */
    GPIO_COIN2,
    GPIO_COIN3,
    GPIO_DOOR,
    GPIO_INPUT_COUNT,
    GPIO_START_LAMP = GPIO_INPUT_COUNT, /* Outputs from here on, in the order of enum hal_switch. */
    GPIO_COIN_LOCKOUT,
    GPIO_TICKET,
    GPIO_COIN_COUNTER,
    GPIO_ROLE_COUNT,
};

static inline bool gpio_role_is_input(enum gpio_role role)
{
    return role < GPIO_INPUT_COUNT;
}

/* Returns true for the coin lines. */
static inline bool gpio_role_is_coin(enum gpio_role role)
{
    return role >= GPIO_COIN && role <= GPIO_COIN3;
}

_Static_assert(GPIO_COIN3 - GPIO_COIN + 1u == COIN_LINE_COUNT, "a role each coin line");

/* Returns true for outputs that start active. Coins are locked out before the first command and
 * after the last. All other outputs start inactive. */
static inline bool gpio_role_begins_active(enum gpio_role role)
{
    return role == GPIO_COIN_LOCKOUT;
}

#define GPIO_TEXT_SIZE 32u /* Equals GPIO_MAX_NAME_SIZE of the kernel. */

enum gpio_bias {
    GPIO_BIAS_AS_IS = 0,
    GPIO_BIAS_UP,
    GPIO_BIAS_DOWN,
    GPIO_BIAS_OFF,
};

/* Wiring of one role. The zero value means not wired. A time of 0 selects the role's default
 * (gpio_config.h). */
struct gpio_wire {
    uint8_t wired;
    char name[GPIO_TEXT_SIZE]; /* Line name; "": the line is given by chip and offset. */
    char chip[GPIO_TEXT_SIZE]; /* Chip label; "" with a line name: any chip. */
    uint32_t offset;
    uint8_t active_low;
    uint8_t bias;          /* enum gpio_bias */
    uint32_t debounce_us;  /* Debounce time of an input; ignored for outputs. */
    uint32_t pulse_min_us; /* For coins: shortest and longest pulse. */
    uint32_t pulse_max_us;
    uint32_t pulse_on_us; /* For outputs: pulse length, and the pause after it. */
    uint32_t pulse_off_us;
};

/* An edge event of the kernel. */
struct gpio_edge {
    uint64_t time_ns; /* CLOCK_MONOTONIC time of the interrupt. */
    uint8_t role;     /* enum gpio_role */
    /* Level after the edge, after active_low. The kernel reads the level shortly after the
     * interrupt, so it can be wrong. */
    uint8_t active;
    uint32_t lost_before; /* Edges of this line that the kernel's queue dropped before this edge. */
    /* Time at which the reader received the edge, set by the reader; 0: not set. */
    uint64_t taken_ns;
};

/* Capacity of one read: four full queues of a line (16 edges on kernel 6.1). */
#define GPIO_EDGES_MAX 64u

/* A line of a chip, as shown by `kingyoctl lines list` and `doctor`. */
struct gpio_line_info {
    char device[GPIO_TEXT_SIZE]; /* Device name, such as "gpiochip0". */
    char chip[GPIO_TEXT_SIZE];   /* Label of the chip. */
    uint32_t offset;
    char name[GPIO_TEXT_SIZE];     /* "" if the board gives no name. */
    char consumer[GPIO_TEXT_SIZE]; /* Current user of the line; "" if unused or unknown. */
    uint8_t used, is_output, active_low;
};

struct gpio_lines_ops {
    /* Requests every wired line that is not held yet. Outputs are driven at once, as
     * gpio_role_begins_active() defines. `why[role]` gets one line with the fault and its remedy
     * ("BTN_START is held by 'gpio-keys': remove its overlay"), or "". Returns the held lines,
     * one bit for each role, or HAL_ERR_ABSENT if there is no GPIO chip. */
    int (*open)(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE]);
    /* Waits for edges at most `timeout_ms`, even if no line is held. Returns the number of
     * edges, the oldest of each line first; `max` means that there may be more. Returns
     * HAL_ERR_GONE after a chip was removed. The lines of that chip are then closed and the
     * others remain held. */
    int (*wait)(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms);
    /* Returns the level, after active_low: 0 or 1. Returns HAL_ERR_GONE if the line is not held. */
    int (*level)(void *self, enum gpio_role role);
    /* Sets the level of an output. Returns HAL_OK, or HAL_ERR_GONE if the line is not held, or
     * HAL_ERR_IO. */
    int (*set)(void *self, enum gpio_role role, int active);
    /* Returns 1 if the kernel debounces this line. */
    int (*debounces)(void *self, enum gpio_role role);
    /* Calls `tell` for every line of every accessible chip. Returns the number of lines, or
     * HAL_ERR_ABSENT if there is no chip. */
    int (*list)(void *self, void (*tell)(void *context, const struct gpio_line_info *line),
                void *context);
    void (*close)(void *self);
    const char *(*describe)(void *self); /* Returns a name such as "libgpiod 1.6.3". */
};

struct gpio_lines {
    const struct gpio_lines_ops *ops;
    void *self;
};

/* Returns the backend of this build. The state of the backend is static, because a kiosk has one
 * cabinet. */
struct gpio_lines gpio_lines_device(void);

#endif
