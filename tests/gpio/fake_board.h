/* fake_board.h -- simulated GPIO chips below libgpiod.
 *
 * fake_gpiod1.c and fake_gpiod2.c implement the functions of both libraries on these chips.
 * test_gpio_backend.c tests the real backends with them. */
#ifndef KINGYO_TESTS_GPIO_FAKE_BOARD_H
#define KINGYO_TESTS_GPIO_FAKE_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#include "drivers/gpio/gpio_lines.h"

#define FAKE_LINES 6u
#define FAKE_CHIPS 3u

struct fake_line {
    const char *name;     /* Name of the line. Null means that the board gives no name. */
    const char *consumer; /* Name of another program that holds the line. Null means that the line
                             is free. */
    int refuses;          /* errno with which a request fails. 0 means that requests succeed. */
    bool has_no_edges;    /* True if the line gives no interrupts. */
    bool is_looked_at;    /* True if the line was requested without edges. */
    bool requested;
    int pipe[2];    /* Pipe with the queued edges. The pipe is open while the line is requested
                       as an input. */
    uint8_t value;  /* Logical level after active_low. */
    uint32_t edges; /* Number of edges after the request. */
    /* Parameters of the current request. */
    bool is_output, active_low;
    uint8_t bias;                     /* Bias of the line, an enum gpio_bias. */
    uint32_t debounce_us, queue_size; /* Debounce period and queue size, which only libgpiod 2.x
                                         sets. */
};

struct fake_chip {
    const char *device, *label;
    bool gone;       /* True after the chip was pulled out. */
    bool denied;     /* True if the chip may not be opened. */
    uint32_t opened; /* Number of open handles. */
    struct fake_line lines[FAKE_LINES];
};

struct fake_edge {
    uint64_t time_ns;
    uint32_t number;
    uint8_t active;
};

extern struct fake_chip fake_chips[FAKE_CHIPS];

/* Resets all chips: no line is held and no fault is set. */
void fake_board_reset(void);

/* Opens the chip at a path in /dev. Returns null and sets errno if the chip may not be opened or
 * does not exist. */
struct fake_chip *fake_chip_open(const char *path);
/* Closes a handle that fake_chip_open() returned. */
void fake_chip_close(struct fake_chip *chip);

/* Requests the line. Returns 0, or -1 and sets errno. */
int fake_line_request(struct fake_chip *chip, struct fake_line *line);
/* Releases a requested line. */
void fake_line_release(struct fake_line *line);

/* Changes the level of the line and queues an edge. The kernel drops `lost` further edges before
 * this edge. */
void fake_line_edge(struct fake_line *line, uint64_t time_ns, bool active, uint32_t lost);
/* Reads the queued edges, at most `max`. Returns their number, or -1 and sets errno if the chip was
 * pulled out. */
int fake_line_read(struct fake_line *line, struct fake_edge *out, uint32_t max);

/* Pulls the chip out. Threads that wait for its lines get a hang-up. */
void fake_chip_pull(struct fake_chip *chip);

#endif
