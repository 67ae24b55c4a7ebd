/* gpio_backend.h -- the part of the GPIO driver that is the same for libgpiod 1.6 and libgpiod 2.x.
 *
 * This module finds lines, requests them, waits for edges, detects removed chips and releases
 * lines. gpio_lines1.c and gpio_lines2.c implement the operations that differ. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_BACKEND_H
#define KINGYO_DRIVERS_GPIO_GPIO_BACKEND_H

#include "drivers/gpio/gpio_dev.h"

/* Operations of one libgpiod release. Each call handles the line of one role. The members are
 * listed in the order of the calls. A failed call sets errno. */
struct gpio_backend_ops {
    bool (*open_chip)(enum gpio_role role, const char *path);
    /* Returns true if the open chip has the line that `wire` names. */
    bool (*find_line)(enum gpio_role role, const struct gpio_wire *wire);
    /* Requests the line. If `has_edges` is true the line is an input with edge detection. Returns
     * 0, or -1 on an error. */
    int (*request)(enum gpio_role role, const struct gpio_wire *wire, bool has_edges);
    /* Copies the name of the program that uses a refused line to `out`, or "" if the name is
     * unknown. */
    void (*consumer)(enum gpio_role role, char out[GPIO_TEXT_SIZE]);
    int (*edges_fd)(enum gpio_role role);
    /* Reads at most `max` edges. Returns the number of edges, or -1 on an error. */
    int (*read_edges)(enum gpio_role role, struct gpio_edge *out, uint32_t max);
    int (*get)(enum gpio_role role);             /* Returns the level, 0 or 1, or -1 on an error. */
    int (*set)(enum gpio_role role, int active); /* Sets an output. Returns 0, or -1 on an error. */
    int (*debounces)(enum gpio_role role);
    /* Releases the line if it was requested, and closes its chip. */
    void (*release)(enum gpio_role role);
    /* Calls `tell` for each line of the chip at `path`, as gpio_chips_list() does. */
    uint32_t (*tell_chip)(const char *path,
                          void (*tell)(void *context, const struct gpio_line_info *line),
                          void *context);
    const char *(*version)(void);
};

struct gpio_backend {
    const struct gpio_backend_ops *ops;
    uint32_t held;             /* Requested lines, one bit for each role. */
    int fds[GPIO_INPUT_COUNT]; /* File descriptors of the edge events; -1 means that the line has no
                                  edge detection. */
    struct gpio_dev_poll_state looks;
    uint8_t went; /* 1 if a chip was removed and wait() has not reported the removal yet, otherwise
                     0. */
    char text[HAL_TEXT_SIZE];
};

/* Returns the device for the libgpiod release of `ops`, and initializes `backend`. The caller owns
 * `backend`. */
struct gpio_lines gpio_backend_device(struct gpio_backend *backend,
                                      const struct gpio_backend_ops *ops);

#endif
