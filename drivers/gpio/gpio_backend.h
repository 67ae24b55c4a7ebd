/* gpio_backend.h -- the part of the GPIO driver that is the same for libgpiod 1.6 and libgpiod 2.x.
 *
 * gpio_backend.c requests lines, waits for edges, detects removed chips and releases lines.
 * gpio_dev.c finds chips in /dev, calls poll() and writes error messages. gpio_lines1.c and
 * gpio_lines2.c implement the operations that differ. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_BACKEND_H
#define KINGYO_DRIVERS_GPIO_GPIO_BACKEND_H

#include <dirent.h>

#include "drivers/gpio/gpio_lines.h"

/* ---- Devices in /dev, waiting and messages (gpio_dev.c) -------------------------------------- */

/* Iteration over the device files of all chips, in directory order. Symbolic links are skipped,
 * because Raspberry Pi OS has links that name chips by their former numbers.
 *
 * Before the first call of gpio_dev_next() all fields except `root` must be 0. The iteration ends
 * when gpio_dev_next() returns false, or when the caller calls gpio_dev_end(). */
struct gpio_dev_walk {
    const char *root; /* Root folder of the file system to search; null means "/". */
    DIR *folder;
    char path[sizeof "/dev/" + 256]; /* Path of the current chip, without `root`. */
    uint32_t count;                  /* Number of chips found so far. */
};

/* Finds the next chip. Returns true if there is a next chip, otherwise ends the iteration and
 * returns false. */
bool gpio_dev_next(struct gpio_dev_walk *walk);

/* Ends an iteration early. */
void gpio_dev_end(struct gpio_dev_walk *walk);

/* Copies a text of libgpiod, truncated to GPIO_TEXT_SIZE. A null text becomes "". */
void gpio_dev_text(char out[GPIO_TEXT_SIZE], const char *text);

/* Result of gpio_dev_wait(). `readable` has one bit for each role with pending events. `gone` has
 * one bit for each role whose chip was removed. */
struct gpio_dev_ready {
    uint32_t readable, gone;
};
/* Waits at most `timeout_ms` for events on the file descriptors `fds` of the input lines. A
 * descriptor of -1 is ignored. */
struct gpio_dev_ready gpio_dev_wait(const int fds[GPIO_INPUT_COUNT], uint32_t timeout_ms);

/* Polling interval of lines without interrupts, such as lines of a port expander whose INT pin is
 * not connected. The shortest coin pulse of 20 ms is five times as long. */
#define GPIO_POLL_MS 4u
struct gpio_dev_poll_state {
    uint32_t roles;  /* Lines that are polled, one bit for each role. */
    uint32_t active; /* Last level of each polled line, one bit for each role. */
};

/* Returns true if the errno value `error` of a request with edge detection means that the line has
 * no interrupt. */
bool gpio_dev_lacks_edges(int error);

/* Starts polling the line of `role`, whose current level is `level`. */
void gpio_dev_poll_begin(struct gpio_dev_poll_state *looks, enum gpio_role role, int level);
/* Returns the longest wait in ms: `timeout_ms`, but at most GPIO_POLL_MS if a line is polled. */
uint32_t gpio_dev_poll_ms(const struct gpio_dev_poll_state *looks, uint32_t timeout_ms);
/* Returns true if `level` differs from the last level of `role`, and fills `out` with an edge at
 * the current time. Otherwise, or if `level` is negative, returns false. */
bool gpio_dev_poll_level(struct gpio_dev_poll_state *looks, enum gpio_role role, int level,
                         struct gpio_edge *out);

/* Writes to `why` the reason for which the kernel refused an existing line. `error` is the errno
 * value. `consumer` is the program that uses the line, or "" if unknown. */
void gpio_dev_why_refused(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, int error,
                          const char *consumer);

/* Writes to `why` the reason for which no chip has the line. `denied` is the path of a chip that
 * could not be opened, or "" if all `chip_count` chips were opened. */
void gpio_dev_why_missing(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, const char *denied,
                          uint32_t chip_count);

/* ---- The backend (gpio_backend.c) ------------------------------------------------------------ */

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
    /* Calls `tell` for each line of the chip at `path`. Returns the number of lines, or 0 if the
     * chip cannot be opened. */
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
