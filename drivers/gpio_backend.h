/* gpio_backend.h -- lines through libgpiod, as far as its two releases are alike: how lines are
 * found, asked for, waited on, lost and let go. gpio_lines1.c and gpio_lines2.c have the rest. */
#ifndef KINGYO_DRIVERS_GPIO_BACKEND_H
#define KINGYO_DRIVERS_GPIO_BACKEND_H

#include "drivers/gpio_dev.h"

/* What each release does its own way, for one role at a time, in this order. Where something can go
 * wrong, errno says why. */
struct gpio_backend_ops {
    bool (*open_chip)(enum gpio_role role, const char *path);
    /* Whether that chip has the wire's line. */
    bool (*find_line)(enum gpio_role role, const struct gpio_wire *wire);
    /* Of an input, with its edges or without; 0, or -1. */
    int (*request)(enum gpio_role role, const struct gpio_wire *wire, bool has_edges);
    /* Who holds the line that was refused; "" where nobody says. */
    void (*consumer)(enum gpio_role role, char out[GPIO_TEXT_SIZE]);
    int (*edges_fd)(enum gpio_role role);
    int (*read_edges)(enum gpio_role role, struct gpio_edge *out, uint32_t max); /* Or -1. */
    int (*get)(enum gpio_role role);             /* 0, 1, or -1. */
    int (*set)(enum gpio_role role, int active); /* 0, or -1. */
    int (*debounces)(enum gpio_role role);
    /* The line and its chip, as far as they were had. */
    void (*release)(enum gpio_role role);
    /* As gpio_chips_tell(). */
    uint32_t (*tell_chip)(const char *path,
                          void (*tell)(void *context, const struct gpio_line_info *line),
                          void *context);
    const char *(*version)(void);
};

struct gpio_backend {
    const struct gpio_backend_ops *ops;
    uint32_t held;             /* A bit each role. */
    int fds[GPIO_INPUT_COUNT]; /* -1: no edges come from there. */
    struct gpio_dev_looks looks;
    uint8_t went;              /* A chip went away, which is still to be told. */
    char text[HAL_TEXT_SIZE];
};

/* The device of a release; what `backend` held it lets go. The caller owns it. */
struct gpio_lines gpio_backend_device(struct gpio_backend *backend,
                                      const struct gpio_backend_ops *ops);

#endif
