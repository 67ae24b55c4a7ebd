/* gpio_dev.h -- what both libgpiod backends do alike: chips in /dev, waiting on lines, and the
 * words for what cannot be had. */
#ifndef KINGYO_DRIVERS_GPIO_DEV_H
#define KINGYO_DRIVERS_GPIO_DEV_H

#include <dirent.h>

#include "drivers/gpio_lines.h"

/* A walk over the chips' device files, in the folder's order, each once: symbolic links (Raspberry
 * Pi OS has some for chips' former numbers) are left out. The first call with a walk that is zero
 * but for `root` opens it; the one that answers false has closed it, and so does gpio_dev_end(). */
struct gpio_dev_walk {
    const char *root; /* Of the machine that is looked at; null: this one. */
    DIR *folder;
    char path[sizeof "/dev/" + 256]; /* Without the root. */
    uint32_t count;   /* Chips so far. */
};
bool gpio_dev_next(struct gpio_dev_walk *walk);
void gpio_dev_end(struct gpio_dev_walk *walk);

/* What a library calls something; null becomes "". */
void gpio_dev_text(char out[GPIO_TEXT_SIZE], const char *text);

/* Waits at most `timeout_ms` for the descriptors of input lines; -1 is none. Sets a bit for each
 * that has something to read, and one for each whose chip went away. */
struct gpio_dev_ready {
    uint32_t readable, gone;
};
struct gpio_dev_ready gpio_dev_wait(const int fds[GPIO_INPUT_COUNT], uint32_t timeout_ms);

/* Lines of chips that give no interrupts (port expanders whose INT is not wired): their levels are
 * looked at this often, which a coin's pulse of 20 ms outlasts five times over. */
#define GPIO_LOOK_MS 4u
struct gpio_dev_looks {
    uint32_t roles;  /* That are looked at, a bit each ... */
    uint32_t active; /* ... and where they were. */
};

/* Whether asking for edges failed since the line gives none. */
bool gpio_dev_lacks_edges(int error);
void gpio_dev_look_from_now(struct gpio_dev_looks *looks, enum gpio_role role, int level);
/* How long may be waited when there are such lines. */
uint32_t gpio_dev_look_ms(const struct gpio_dev_looks *looks, uint32_t timeout_ms);
/* True: `level` is another than before, and `out` is the edge of it, dated now. */
bool gpio_dev_look(struct gpio_dev_looks *looks, enum gpio_role role, int level,
                   struct gpio_edge *out);

/* The line is known, but `error` (an errno) came of asking for it; `consumer` holds it, if any. */
void gpio_dev_why_refused(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, int error,
                          const char *consumer);

/* No chip has the line; `denied`: the path of one that may not be opened, or "". */
void gpio_dev_why_missing(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire,
                          const char *denied, uint32_t chip_count);

#endif
