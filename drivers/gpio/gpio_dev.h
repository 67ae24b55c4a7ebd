/* gpio_dev.h -- helpers of both libgpiod backends: chips in /dev, waiting, polling, error
 * messages. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_DEV_H
#define KINGYO_DRIVERS_GPIO_GPIO_DEV_H

#include <dirent.h>

#include "drivers/gpio/gpio_lines.h"

/* An iteration over the device files of all chips, in directory order. Symbolic links are
 * skipped, because Raspberry Pi OS has links for former chip numbers. The first call of
 * gpio_dev_next() needs a zero-initialized walk; only `root` may be set. The walk is closed when
 * gpio_dev_next() returns false, or by gpio_dev_end(). */
struct gpio_dev_walk {
    const char *root; /* Root folder of the machine to examine; null: this one. */
    DIR *folder;
    char path[sizeof "/dev/" + 256]; /* Path of the current chip, without the root. */
    uint32_t count;                  /* Chips found so far. */
};

/* Finds the next chip. Returns false, and closes the walk, if there is none. */
bool gpio_dev_next(struct gpio_dev_walk *walk);

/* Closes a walk before its end. */
void gpio_dev_end(struct gpio_dev_walk *walk);

/* Copies a text of libgpiod; null becomes "". */
void gpio_dev_text(char out[GPIO_TEXT_SIZE], const char *text);

/* Waits at most `timeout_ms` for events on the descriptors of input lines (-1: no descriptor).
 * Sets one bit for each role that is readable, and one for each role whose chip was removed. */
struct gpio_dev_ready {
    uint32_t readable, gone;
};
struct gpio_dev_ready gpio_dev_wait(const int fds[GPIO_INPUT_COUNT], uint32_t timeout_ms);

/* Polling interval of lines without interrupts, such as port expanders whose INT pin is not
 * connected. A coin pulse of 20 ms is five times as long. */
#define GPIO_POLL_MS 4u
struct gpio_dev_poll_state {
    uint32_t roles;  /* Lines that are polled, one bit for each role. */
    uint32_t active; /* Last level of each polled line. */
};

/* Returns true if a request with edge detection failed because the line has no interrupt. */
bool gpio_dev_lacks_edges(int error);

/* Starts polling the line of `role`, whose current level is `level`. */
void gpio_dev_poll_begin(struct gpio_dev_poll_state *looks, enum gpio_role role, int level);
/* Returns the longest wait in ms, which is limited to GPIO_POLL_MS if lines are polled. */
uint32_t gpio_dev_poll_ms(const struct gpio_dev_poll_state *looks, uint32_t timeout_ms);
/* Returns true if `level` differs from the last one, and fills `out` with an edge stamped with
 * the current time. */
bool gpio_dev_poll_level(struct gpio_dev_poll_state *looks, enum gpio_role role, int level,
                         struct gpio_edge *out);

/* Writes why an existing line was refused. `error` is the errno value; `consumer` is the current
 * user of the line or "". */
void gpio_dev_why_refused(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, int error,
                          const char *consumer);

/* Writes why no chip has the line. `denied` is the path of a chip that could not be opened, or
 * "". */
void gpio_dev_why_missing(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, const char *denied,
                          uint32_t chip_count);

#endif
