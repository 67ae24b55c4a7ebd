/* gpio_backend.h -- the part of the GPIO driver that both releases of libgpiod share.
 *
 * This module finds lines, requests them, waits for edges, detects loss and releases lines.
 * gpio_lines1.c and gpio_lines2.c implement the operations that differ. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_BACKEND_H
#define KINGYO_DRIVERS_GPIO_GPIO_BACKEND_H

#include "drivers/gpio/gpio_dev.h"

/* Operations of one libgpiod release. Each call handles one role, and the calls come in this
 * order. A failed call sets errno. */
struct gpio_backend_ops {
    bool (*open_chip)(enum gpio_role role, const char *path);
    /* Returns whether the chip has the line of `wire`. */
    bool (*find_line)(enum gpio_role role, const struct gpio_wire *wire);
    /* Requests the line, an input with or without edge detection. Returns 0 or -1. */
    int (*request)(enum gpio_role role, const struct gpio_wire *wire, bool has_edges);
    /* Copies the consumer of a refused line to `out`, or "" if it is unknown. */
    void (*consumer)(enum gpio_role role, char out[GPIO_TEXT_SIZE]);
    int (*edges_fd)(enum gpio_role role);
    /* Reads at most `max` edges. Returns their number, or -1 on an error. */
    int (*read_edges)(enum gpio_role role, struct gpio_edge *out, uint32_t max);
    int (*get)(enum gpio_role role);             /* Returns the level 0 or 1, or -1 on an error. */
    int (*set)(enum gpio_role role, int active); /* Sets an output. Returns 0 or -1. */
    int (*debounces)(enum gpio_role role);
    /* Releases the line, if it was requested, and closes the chip. */
    void (*release)(enum gpio_role role);
    /* Lists the lines of a chip, like gpio_chips_list(). */
    uint32_t (*tell_chip)(const char *path,
                          void (*tell)(void *context, const struct gpio_line_info *line),
                          void *context);
    const char *(*version)(void);
};

struct gpio_backend {
    const struct gpio_backend_ops *ops;
    uint32_t held;             /* Requested lines, one bit for each role. */
    int fds[GPIO_INPUT_COUNT]; /* Edge event descriptors, or -1 for a line without edges. */
    struct gpio_dev_poll_state looks;
    uint8_t went; /* 1 after a chip was removed, until wait() reports it. */
    char text[HAL_TEXT_SIZE];
};

/* Returns the device of a libgpiod release and initializes `backend`. The caller owns `backend`. */
struct gpio_lines gpio_backend_device(struct gpio_backend *backend,
                                      const struct gpio_backend_ops *ops);

#endif
