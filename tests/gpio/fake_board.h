/* fake_board.h -- simulated GPIO chips below libgpiod.
 *
 * fake_gpiod1.c and fake_gpiod2.c replace libgpiod 1.6 and 2.x by functions that use these chips,
 * so that test_gpio_backend.c can test the real backends. */
#ifndef KINGYO_TESTS_GPIO_FAKE_BOARD_H
#define KINGYO_TESTS_GPIO_FAKE_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#include "drivers/gpio/gpio_lines.h"

#define FAKE_LINES 6u
#define FAKE_CHIPS 3u

struct fake_line {
    const char *name; /* Name of the line; null means that the line has no name. */
    /* Name of another program that holds the line; null means that the line is free. */
    const char *consumer;
    int refuses; /* errno with which a request of the line fails; 0 means that requests succeed. */
    bool has_no_edges; /* True if the line gives no interrupts. */
    bool is_looked_at; /* True if the line was requested as an input without edge detection. */
    bool requested;
    /* Pipe with the queued edges, open while the line is requested as an input. */
    int pipe[2];
    uint8_t value; /* Logical level of the line. If active_low is set, the electrical level is
                       already inverted. */
    /* Number of edges on the line since it was requested. */
    uint32_t edges;
    /* Parameters of the current request. */
    bool is_output, active_low;
    uint8_t bias; /* Bias of the line, an enum gpio_bias. */
    /* Debounce period and queue size of the request. Only libgpiod 2.x sets them. */
    uint32_t debounce_us, queue_size;
};

struct fake_chip {
    const char *device, *label;
    bool gone;       /* True after the chip was disconnected. */
    bool denied;     /* True if an attempt to open the chip fails with EACCES. */
    uint32_t opened; /* Number of open handles. */
    struct fake_line lines[FAKE_LINES];
};

struct fake_edge {
    uint64_t time_ns;
    uint32_t number;
    uint8_t active;
};

extern struct fake_chip fake_chips[FAKE_CHIPS];

/* Resets all chips, so that no line is held and no fault is set. */
void fake_board_reset(void);

/* Opens the chip at a path in /dev. Returns null and sets errno if the chip does not exist or
 * access to it is denied. */
struct fake_chip *fake_chip_open(const char *path);
/* Closes a handle to a chip that fake_chip_open() returned. */
void fake_chip_close(struct fake_chip *chip);

/* Requests a line of the chip. Returns 0, or -1 and sets errno. */
int fake_line_request(struct fake_chip *chip, struct fake_line *line);
/* Releases a requested line. */
void fake_line_release(struct fake_line *line);

/* Changes the level of the line and queues an edge. Counts `lost` edges before this edge as dropped
 * by the kernel. */
void fake_line_edge(struct fake_line *line, uint64_t time_ns, bool active, uint32_t lost);
/* Reads at most `max` queued edges of the line. Returns the number of edges, or -1 and sets errno
 * if the chip was disconnected. */
int fake_line_read(struct fake_line *line, struct fake_edge *out, uint32_t max);

/* Disconnects the chip. Threads that wait for its lines receive a hang-up. */
void fake_chip_pull(struct fake_chip *chip);

#endif
