/* gpio_backend.h -- the part of the GPIO driver that is the same for libgpiod 1.6 and libgpiod 2.x.
 *
 * gpio_backend.c requests lines, waits for edges, detects removed chips and releases lines.
 * gpio_dev.c finds chips in /dev and writes error messages. gpio_lines1.c and gpio_lines2.c
 * implement the operations that differ. */
#pragma once

#include <dirent.h>

#include "drivers/gpio/gpio_lines.h"

/* ---- Devices in /dev and messages (gpio_dev.c) ----------------------------------------------- */

/* Iteration over the device files of all chips, in directory order. Symbolic links are skipped,
 * because Raspberry Pi OS has links that name chips by their former numbers.
 *
 * Before the first call of gpio_dev_next() all fields except `root` must be 0. The iteration ends
 * when gpio_dev_next() returns false, or when the caller calls gpio_dev_end(). */
struct gpio_dev_walk {
    const char *root; /* Root folder of the file system to search. Null means "/". */
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

/* Writes to `why` the reason for which the kernel refused an existing line. `error` is the errno
 * value. `consumer` is the program that uses the line, or "" if unknown. */
void gpio_dev_why_refused(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, int error,
                          const char *consumer);

/* Writes to `why` the reason for which no chip has the line. `denied` is the path of a chip that
 * could not be opened, or "" if all `chip_count` chips were opened. */
void gpio_dev_why_missing(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, const char *denied,
                          uint32_t chip_count);

/* ---- The backend (gpio_backend.c) ------------------------------------------------------------ */

/* Returns true if the kernel may debounce the line of `role`. Coin and tilt lines are excluded,
 * because the times of their transitions matter.
 *
 * The kernel stamps a debounced edge when its work queue runs, in steps of 4 ms and late on a busy
 * machine. In a virtual machine, coin pulses of 40 ms were measured as 15 to 75 ms. Edges without
 * kernel debouncing have exact time stamps. */
static inline bool gpio_backend_may_debounce(enum gpio_role role)
{
    return !gpio_role_is_coin(role) && role != GPIO_TILT;
}

/* Operations of one libgpiod release. Each call handles the line of one role. The members are
 * listed in the order of the calls. All members are null in a build without libgpiod. */
struct gpio_backend_ops {
    /* Opens the chip at `path` and searches for the line that `wire` names. Returns 1 if the chip
     * has the line. Otherwise closes the chip and returns 0. Returns -1 and sets errno if the chip
     * cannot be opened. */
    int (*find)(enum gpio_role role, const char *path, const struct gpio_wire *wire);
    /* Requests the line. If `has_edges` is true the line is an input with edge detection. Returns
     * the file descriptor of the edge events, or 0 without edge detection. On an error, sets errno,
     * copies the name of the program that uses the line to `consumer` ("" if the name is unknown),
     * and returns -1. */
    int (*request)(enum gpio_role role, const struct gpio_wire *wire, bool has_edges,
                   char consumer[GPIO_TEXT_SIZE]);
    /* Reads at most `max` edges. Returns the number of edges, or -1 on an error. */
    int (*read_edges)(enum gpio_role role, struct gpio_edge *out, uint32_t max);
    int (*get)(enum gpio_role role); /* Returns the level, 0 or 1, or -1 with errno on an error. */
    /* Sets an output. Returns 0, or -1 with errno on an error. */
    int (*set)(enum gpio_role role, bool active);
    /* Releases the line if it was requested, and closes its chip. */
    void (*release)(enum gpio_role role);
    /* Calls `report` for each line of the chip at `path`. Returns the number of lines, or 0 if the
     * chip cannot be opened. */
    uint32_t (*list_chip_lines)(const char *path,
                                void (*report)(void *context, const struct gpio_line_info *line),
                                void *context);
    const char *(*version)(void);
    bool debounces; /* True if the release can request lines that the kernel debounces. */
};

struct gpio_backend {
    const struct gpio_backend_ops *ops;
    uint32_t held;      /* Requested lines, one bit for each role. */
    uint32_t debounced; /* Requested lines that the kernel debounces, one bit for each role. */
    uint32_t polled;    /* Requested inputs without edge detection, one bit for each role. */
    /* Newest level of each polled line, one bit for each role. 1 means active. */
    uint32_t active;
    /* File descriptors of the edge events. -1 means that the line has no edge detection. */
    int fds[GPIO_INPUT_COUNT];
    /* True if a chip was removed and gpio_lines_ops.wait() has not reported the removal yet. */
    bool went;
    char text[HAL_TEXT_SIZE];
};

/* Returns the device for the libgpiod release of `ops`, and initializes `backend`. The caller owns
 * `backend`. */
struct gpio_lines gpio_backend_device(struct gpio_backend *backend,
                                      const struct gpio_backend_ops *ops);
