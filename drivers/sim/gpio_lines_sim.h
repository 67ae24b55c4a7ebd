/* gpio_lines_sim.h -- simulated GPIO lines: wires, contacts and the kernel, on a simulated
 * clock.
 *
 * A script changes the wires. A model of the kernel stands between the wires and wait(). The
 * kernel reads a level late, and edges that arrive meanwhile become one edge. The queue of a
 * line has a fixed size and drops edges, with numbers (libgpiod 2.x) or without (1.6). Chips can
 * be removed and return, and lines can be held by other programs. Time advances only in wait()
 * and gpio_lines_sim_pass(). The caller owns the state. All calls come from one thread. */
#ifndef KINGYO_DRIVERS_SIM_GPIO_LINES_SIM_H
#define KINGYO_DRIVERS_SIM_GPIO_LINES_SIM_H

#include "drivers/gpio/gpio_lines.h"

#define GPIO_SIM_QUEUE_MAX 64u

enum gpio_sim_what {
    GPIO_SIM_LEVEL = 0, /* Sets the wire of `role` to level `active` (after active_low). */
    /* A glitch that the kernel sees as one edge, on chips with one event bit for each line. */
    GPIO_SIM_SPARK,
    GPIO_SIM_GONE, /* Removes the chip of all lines. */
    GPIO_SIM_BACK, /* Returns the chip. Wires can change unseen meanwhile. */
};

struct gpio_sim_event {
    uint64_t time_ns;
    uint8_t what; /* enum gpio_sim_what */
    uint8_t role; /* Role of an input line. */
    uint8_t active;
};

/* A source of events in order of time. next() returns false if there are no more events. */
struct gpio_sim_script {
    bool (*next)(void *self, struct gpio_sim_event *out);
    void *self;
};

/* A recorded change of an output. */
#define GPIO_SIM_SETS_MAX 64u
struct gpio_sim_set {
    uint64_t time_ns;
    uint8_t role, active;
};

struct gpio_lines_sim {
    /* Settings that the caller may change after gpio_lines_sim_init(). */
    /* Capacity of each queue. 16 simulates libgpiod 1.6; the limit is GPIO_SIM_QUEUE_MAX. */
    uint32_t queue_size;
    /* 1 simulates 2.x, which drops the oldest edge and shows it; 0 drops the newest. */
    uint8_t is_numbered;
    uint8_t kernel_debounces;          /* Reported only; the script must then contain no bounce. */
    uint64_t late_min_ns, late_max_ns; /* Delay after which the kernel reads the level. */
    uint32_t held_by_others;           /* Lines that cannot be requested, one bit for each role. */

    uint64_t now_ns;
    struct gpio_sim_script script;
    struct gpio_sim_event next_event;
    bool has_next;
    uint32_t seed;
    uint32_t held; /* Lines that are held, one bit for each role. */
    uint32_t open_count;
    bool chip_is_away, went;
    struct gpio_sim_line {
        uint8_t level;          /* Level of the wire. */
        uint8_t pending;        /* 1 if an edge arrived while the kernel served the previous one. */
        uint64_t busy_until_ns; /* Time at which the kernel reads the level; 0: idle. */
        uint64_t stamp_ns;      /* Time stamp of the edge that the kernel serves. */
        uint32_t number;        /* Number of edges so far. */
        uint32_t seen;          /* Number of the last edge that was read. */
        uint8_t was_full, last; /* State that infers losses as in gpio_lines1.c. */
        uint32_t first, count;  /* Positions in the ring buffer `queue`. */
        struct {
            uint64_t time_ns;
            uint32_t number;
            uint8_t active;
        } queue[GPIO_SIM_QUEUE_MAX];
    } lines[GPIO_INPUT_COUNT];
    uint32_t dropped;                 /* Number of edges dropped, of all lines. */
    uint8_t outputs[GPIO_ROLE_COUNT]; /* Output levels, after active_low. */
    uint8_t rests[GPIO_ROLE_COUNT];   /* Levels of undriven outputs: their bias, or low. */
    struct gpio_sim_set sets[GPIO_SIM_SETS_MAX]; /* Ring buffer of the newest output changes. */
    uint32_t set_count;                          /* Number of output changes so far. */
};

/* Initializes lines at rest, a chip, a kernel without delay, and queues of libgpiod 2.x. */
void gpio_lines_sim_init(struct gpio_lines_sim *sim, struct gpio_sim_script script, uint32_t seed);

/* A script of `count` events in memory, which must stay valid. `events->next` must be 0 at
 * first. */
struct gpio_sim_events {
    const struct gpio_sim_event *events;
    uint32_t count, next;
};
struct gpio_sim_script gpio_lines_sim_events_script(struct gpio_sim_events *events);

/* Advances time without reading edges, as if the reader thread did not run. */
void gpio_lines_sim_pass(struct gpio_lines_sim *sim, uint64_t ns);

struct gpio_lines gpio_lines_sim_device(struct gpio_lines_sim *sim);

/* Returns the simulated clock. */
struct hal_clock gpio_lines_sim_clock(struct gpio_lines_sim *sim);

#endif
