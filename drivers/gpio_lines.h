/* gpio_lines.h -- buttons, coins and lamps on GPIO lines: what is wired where, and the one small
 * table of functions that each libgpiod has a file for.
 *
 * gpio_lines1.c is for libgpiod 1.6 (Debian 12), gpio_lines2.c for 2.x (Debian 13), gpio_lines0.c
 * for a machine without; pkg-config says which is compiled. gpio_lines_sim.h is their twin. A line
 * is found by its name, else by its chip's label and offset, never by a chip's number, which
 * changes between boots. All calls are one thread's: the reader's (gpio_reader.h). */
#ifndef KINGYO_DRIVERS_GPIO_LINES_H
#define KINGYO_DRIVERS_GPIO_LINES_H

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
    GPIO_COIN, /* COIN_LINE_COUNT of them. */
    GPIO_COIN2,
    GPIO_COIN3,
    GPIO_DOOR,
    GPIO_INPUT_COUNT,
    GPIO_START_LAMP = GPIO_INPUT_COUNT, /* From here on outputs, in enum hal_switch's order. */
    GPIO_COIN_LOCKOUT,
    GPIO_TICKET,
    GPIO_COIN_COUNTER,
    GPIO_ROLE_COUNT,
};

static inline bool gpio_role_is_input(enum gpio_role role)
{
    return role < GPIO_INPUT_COUNT;
}

static inline bool gpio_role_is_coin(enum gpio_role role)
{
    return role >= GPIO_COIN && role <= GPIO_COIN3;
}

_Static_assert(GPIO_COIN3 - GPIO_COIN + 1u == COIN_LINE_COUNT, "a role each coin line");

/* Coins are locked out while nobody lets them in: before the first word, and after the last. All
 * other outputs begin inactive. */
static inline bool gpio_role_begins_active(enum gpio_role role)
{
    return role == GPIO_COIN_LOCKOUT;
}

#define GPIO_TEXT_SIZE 32u /* As the kernel's GPIO_MAX_NAME_SIZE. */

enum gpio_bias {
    GPIO_BIAS_AS_IS = 0,
    GPIO_BIAS_UP,
    GPIO_BIAS_DOWN,
    GPIO_BIAS_OFF,
};

/* How one role is wired. Zero: it is not. A time of 0 is the role's own (gpio_wires.h). */
struct gpio_wire {
    uint8_t wired;
    char name[GPIO_TEXT_SIZE]; /* Of the line; "": by chip and offset. */
    char chip[GPIO_TEXT_SIZE]; /* The chip's label; "" beside a name: any chip. */
    uint32_t offset;
    uint8_t active_low;
    uint8_t bias;              /* enum gpio_bias */
    uint32_t debounce_us;      /* Inputs. */
    uint32_t pulse_min_us;     /* Coins: how long a pulse lasts. */
    uint32_t pulse_max_us;
    uint32_t pulse_on_us;      /* Outputs: a pulse, and the rest behind it. */
    uint32_t pulse_off_us;
};

/* One edge, as the kernel saw it. */
struct gpio_edge {
    uint64_t time_ns;     /* CLOCK_MONOTONIC, when the kernel took it. */
    uint8_t role;         /* enum gpio_role */
    uint8_t active;       /* After active_low: the level that the edge went to, as far as the kernel
                             knows: it reads the level a little after the edge. */
    uint32_t lost_before; /* Edges of this line that the kernel's queue dropped before it. */
    uint64_t taken_ns;    /* When the reader took it, which sets it; 0: nobody says. */
};

#define GPIO_EDGES_MAX 64u /* Taken at once: four full queues of one line (16 on 6.1). */

/* One line of a chip, as `kingyoctl lines list` and `doctor` show it. */
struct gpio_line_info {
    char device[GPIO_TEXT_SIZE];   /* "gpiochip0" */
    char chip[GPIO_TEXT_SIZE];     /* Its label. */
    uint32_t offset;
    char name[GPIO_TEXT_SIZE];     /* "" where the board gives none. */
    char consumer[GPIO_TEXT_SIZE]; /* Who holds it; "" where nobody does, or nobody says. */
    uint8_t used, is_output, active_low;
};

struct gpio_lines_ops {
    /* Asks for every wired line that is not held yet; outputs are driven at once, as
     * gpio_role_begins_active() says. What cannot be had is told in `why[role]`, one line each with
     * what to do ("BTN_START is held by 'gpio-keys': remove its overlay"), "" where all is well.
     * Returns what is held now, a bit each role; HAL_ERR_NONE where no GPIO chip is there. */
    int (*open)(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE]);
    /* Waits for edges at most `timeout_ms`, also where no line is held. Returns how many came, each
     * line's oldest first; as many as `max` where there may be more. HAL_ERR_GONE when a chip went
     * away: its lines are closed, open() finds the others still held. */
    int (*wait)(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms);
    /* The line's level now, after active_low: 0 or 1; HAL_ERR_GONE where it is not held. */
    int (*level)(void *self, enum gpio_role role);
    int (*set)(void *self, enum gpio_role role, int active); /* Outputs. */
    /* Whether the kernel debounces this line itself. */
    int (*debounces)(void *self, enum gpio_role role);
    /* Tells every line of every chip that may be opened; returns how many there are, or
     * HAL_ERR_NONE without a chip. */
    int (*list)(void *self, void (*tell)(void *context, const struct gpio_line_info *line),
                void *context);
    void (*close)(void *self);
    const char *(*describe)(void *self); /* "libgpiod 1.6.3" */
};

struct gpio_lines { const struct gpio_lines_ops *ops; void *self; };

/* The library's own backend; one static state: a kiosk has one cabinet. */
struct gpio_lines gpio_lines_device(void);

#endif
