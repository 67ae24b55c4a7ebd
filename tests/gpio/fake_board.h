/* fake_board.h -- GPIO chips made of memory, below libgpiod: fake_gpiod1.c and fake_gpiod2.c are
 * the functions of both libraries over it, test_gpio_backend.c holds the true backends to it. */
#ifndef KINGYO_TESTS_GPIO_FAKE_BOARD_H
#define KINGYO_TESTS_GPIO_FAKE_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#include "drivers/gpio_lines.h"

#define FAKE_LINES 6u
#define FAKE_CHIPS 3u

struct fake_line {
    const char *name;     /* Null: the board gives none. */
    const char *consumer; /* Not null: another program holds it. */
    int refuses;          /* An errno that a request is answered with; 0: none. */
    bool has_no_edges;    /* It gives no interrupts ... */
    bool is_looked_at;    /* ... and so was asked for without. */
    bool requested;
    int pipe[2];          /* Edges on their way; while it is requested as an input. */
    uint8_t value;        /* After active_low. */
    uint32_t edges;       /* Since it was requested. */
    /* As it was asked for: */
    bool is_output, active_low;
    uint8_t bias;         /* enum gpio_bias */
    uint32_t debounce_us, queue_size; /* libgpiod 2.x. */
};

struct fake_chip {
    const char *device, *label;
    bool gone;       /* Pulled out. */
    bool denied;     /* May not be opened. */
    uint32_t opened; /* Handles that are open now. */
    struct fake_line lines[FAKE_LINES];
};

struct fake_edge {
    uint64_t time_ns;
    uint32_t number;
    uint8_t active;
};

extern struct fake_chip fake_chips[FAKE_CHIPS];

/* Nothing is held and nothing wrong. */
void fake_board_reset(void);

/* The chip behind a path of /dev with an errno where it may not be opened; null: with errno. */
struct fake_chip *fake_chip_open(const char *path);
void fake_chip_close(struct fake_chip *chip);

/* -1 and errno, or 0. */
int fake_line_request(struct fake_chip *chip, struct fake_line *line);
void fake_line_release(struct fake_line *line);

/* The wire moves, and the kernel says so; `lost` more edges come before this one that it drops. */
void fake_line_edge(struct fake_line *line, uint64_t time_ns, bool active, uint32_t lost);
/* As many as there are, at most `max`; -1 and errno where the chip is gone. */
int fake_line_read(struct fake_line *line, struct fake_edge *out, uint32_t max);

/* Pulls the chip out: whoever waits for its lines is told. */
void fake_chip_pull(struct fake_chip *chip);

#endif
