/* gpio_lines.h -- defines the wiring of the GPIO lines for buttons, coins and lamps, and the
 * interface of the libgpiod drivers (backends).
 *
 * gpio_lines1.c implements the interface for libgpiod 1.6 (Debian 12), gpio_lines2.c for libgpiod
 * 2.x (Debian 13), and gpio_lines0.c for a build without libgpiod. pkg-config selects one of these
 * files. gpio_lines_sim.h is the simulated backend.
 *
 * A line is found by its name, or by the label of its chip and an offset. Chip numbers are not
 * used, because they can change when the machine boots. All calls come from one thread, the GPIO
 * thread (gpio_thread.h). A line is held while the backend has requested it from the kernel. */
#pragma once

#include <stdbool.h>
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
    GPIO_COIN, /* First of the COIN_LINE_COUNT coin lines. */
    GPIO_COIN2,
    GPIO_COIN3,
    GPIO_DOOR,
    GPIO_INPUT_COUNT,
    /* First output. The outputs have the order of enum hal_switch. */
    GPIO_START_LAMP = GPIO_INPUT_COUNT,
    GPIO_COIN_LOCKOUT,
    GPIO_TICKET,
    GPIO_COIN_COUNTER,
    GPIO_ROLE_COUNT,
};

static inline bool gpio_role_is_input(enum gpio_role role)
{
    return role < GPIO_INPUT_COUNT;
}

/* Returns the bit of a role in a bit mask of roles. */
static inline uint32_t gpio_role_bit(enum gpio_role role)
{
    return 1u << role;
}

/* Returns true if `role` is a coin line. */
static inline bool gpio_role_is_coin(enum gpio_role role)
{
    return role >= GPIO_COIN && role <= GPIO_COIN3;
}

_Static_assert(GPIO_COIN3 - GPIO_COIN + 1u == COIN_LINE_COUNT, "a role each coin line");

/* Returns true if the output `role` is active when it is requested and after it is closed,
 * otherwise false. Only the coin lockout is active at these times, so that coins are rejected while
 * the kiosk does not run. All other outputs start inactive. */
static inline bool gpio_role_begins_active(enum gpio_role role)
{
    return role == GPIO_COIN_LOCKOUT;
}

#define GPIO_TEXT_SIZE 32u /* Buffer size of names, equal to GPIO_MAX_NAME_SIZE of the kernel. */

enum gpio_bias {
    GPIO_BIAS_AS_IS = 0,
    GPIO_BIAS_UP,
    GPIO_BIAS_DOWN,
    GPIO_BIAS_OFF,
};

/* Wiring of one role. An all-zero value means that the role is not wired. A time of 0 selects the
 * default of the role (gpio_config.h). */
struct gpio_wire {
    bool wired;
    /* Name of the line. "" means that `chip` and `offset` identify the line. */
    char name[GPIO_TEXT_SIZE];
    char chip[GPIO_TEXT_SIZE]; /* Label of the chip. "" together with a line name means any chip. */
    uint32_t offset;
    bool active_low;
    uint8_t bias;         /* Pull resistor of the line (enum gpio_bias). */
    uint32_t debounce_us; /* Debounce time of an input. Outputs do not use this field. */
    /* Shortest (`pulse_min_us`) and longest (`pulse_max_us`) valid pulse of a coin line. */
    uint32_t pulse_min_us;
    uint32_t pulse_max_us;
    /* Length of an output pulse (`pulse_on_us`), and pause after each pulse (`pulse_off_us`). */
    uint32_t pulse_on_us;
    uint32_t pulse_off_us;
};

/* An edge event of the kernel. */
struct gpio_edge {
    uint64_t time_ns; /* Time of the interrupt on CLOCK_MONOTONIC. */
    uint8_t role;     /* Role of the line (enum gpio_role). */
    /* True if the level after the edge is active (see `active_low` of struct gpio_wire). The kernel
     * reads the level some time after the interrupt, so the level can be wrong. */
    bool active;
    /* Number of edges of the line that the kernel dropped directly before this edge, because its
     * queue was full. */
    uint32_t lost_before;
    /* Time at which the GPIO thread received the edge. The GPIO thread sets this field. The backend
     * leaves this field 0. */
    uint64_t taken_ns;
};

/* Largest number of edges in one read: four times the 16 edges of a line's queue in kernel 6.1. */
#define GPIO_EDGES_MAX 64u

/* A line of a chip, as `kingyoctl lines list` and `kingyoctl doctor` show it. */
struct gpio_line_info {
    char device[GPIO_TEXT_SIZE]; /* Device name of the chip, such as "gpiochip0". */
    char chip[GPIO_TEXT_SIZE];   /* Label of the chip. */
    uint32_t offset;
    char name[GPIO_TEXT_SIZE]; /* Name of the line, or "" if the board gives no name. */
    /* Name of the program that uses the line, or "" if the line is unused or the name is
     * unknown. */
    char consumer[GPIO_TEXT_SIZE];
    bool used, is_output, active_low;
};

struct gpio_lines_ops {
    /* Requests every wired line that is not held yet. Each output is immediately driven to the
     * level that gpio_role_begins_active() returns. `why[role]` receives one line that names the
     * fault and the remedy ("BTN_START is in use by 'gpio-keys': remove its overlay"), or "".
     * Returns the held lines, one bit for each role, or HAL_ERR_ABSENT if there is no GPIO chip. */
    int (*open)(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE]);
    /* Waits at most `timeout_ms` for edges, even if no line is held. Returns the number of edges,
     * ordered by time for each line. A return value of `max` means that more edges may be pending.
     * If the system call that waits for edges fails, returns no edges after `timeout_ms`. The
     * caller can still read the lines with level(). Returns HAL_ERR_GONE after a chip was removed.
     * The lines of the removed chip are then closed, and all other lines remain held. */
    int (*wait)(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms);
    /* Returns the level of the line: 1 means active, 0 means inactive (see active_low). Returns
     * HAL_ERR_GONE if the line is not held. */
    int (*level)(void *self, enum gpio_role role);
    /* Sets the level of an output. Returns HAL_OK, HAL_ERR_GONE if the line is not held, or
     * HAL_ERR_IO on another error. */
    int (*set)(void *self, enum gpio_role role, bool active);
    /* Returns true if the kernel debounces the line. */
    bool (*debounces)(void *self, enum gpio_role role);
    /* Calls `report` for every line of every accessible chip. Returns the number of lines, or
     * HAL_ERR_ABSENT if there is no chip. */
    int (*list)(void *self, void (*report)(void *context, const struct gpio_line_info *line),
                void *context);
    void (*close)(void *self);
    /* Returns the name of the library, such as "libgpiod 1.6.3". */
    const char *(*describe)(void *self);
};

struct gpio_lines {
    const struct gpio_lines_ops *ops;
    void *self;
};

/* Returns the backend of this build. The state of the backend is static, because a kiosk has one
 * cabinet. */
struct gpio_lines gpio_lines_device(void);
