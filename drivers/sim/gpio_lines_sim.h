/* gpio_lines_sim.h -- simulated GPIO lines: wires, contacts and the kernel, on a simulated clock.
 *
 * A script of events changes the levels of the wires. A model of the kernel connects the wires with
 * wait(). The kernel reads a level late, and edges that arrive meanwhile become one edge. The queue
 * of a line has a fixed size and drops edges when it is full. Edges are numbered as with libgpiod
 * 2.x, or not numbered as with libgpiod 1.6.
 *
 * Chips can be removed and return, and lines can be held by other programs. Time advances only in
 * wait() and gpio_lines_sim_pass(). The caller owns the state. All calls come from one thread. */
#pragma once

#include "drivers/gpio/gpio_lines.h"

#define GPIO_SIM_QUEUE_MAX 64u

enum gpio_sim_what {
    /* Sets the wire of `role` to the level `active`: 1 means active, as defined by `active_low` of
     * struct gpio_wire. */
    GPIO_SIM_LEVEL = 0,
    /* A glitch that the kernel reports as one edge, as on chips with one event bit for each
     * line. */
    GPIO_SIM_SPARK,
    GPIO_SIM_GONE, /* Removes the chip, which has all lines. */
    /* Plugs the removed chip in again. The levels of the wires can change while the chip is
     * removed. */
    GPIO_SIM_BACK,
};

struct gpio_sim_event {
    uint64_t time_ns;
    uint8_t what; /* Kind of the event (enum gpio_sim_what). */
    uint8_t role; /* Role of an input line (enum gpio_role). */
    uint8_t active;
};

/* Source of events in order of time. next() returns true and fills `out`, or returns false if there
 * are no more events. */
struct gpio_sim_script {
    bool (*next)(void *self, struct gpio_sim_event *out);
    void *self;
};

/* Capacity of the record of output changes (struct gpio_sim_set). */
#define GPIO_SIM_SETS_MAX 64u
struct gpio_sim_set {
    uint64_t time_ns;
    uint8_t role, active;
};

struct gpio_lines_sim {
    /* The caller may change the members from `queue_size` to `failing_outputs` after
     * gpio_lines_sim_init(). */
    /* Capacity of each queue, at most GPIO_SIM_QUEUE_MAX. 16 simulates libgpiod 1.6. */
    uint32_t queue_size;
    /* True if edges are numbered and a full queue drops its oldest edge, as with libgpiod 2.x.
     * False if edges are not numbered and a full queue drops the newest edge. */
    bool is_numbered;
    /* Result of the backend's function debounces(). If the result is true, the script must contain
     * no bounces, because the simulated kernel does not debounce. */
    bool kernel_debounces;
    /* Shortest and longest delay after which the kernel reads the level of a line. */
    uint64_t late_min_ns, late_max_ns;
    uint32_t held_by_others; /* Lines that other programs hold, one bit for each role. */
    /* Outputs that set() does not switch, one bit for each role. set() returns HAL_ERR_IO for these
     * outputs. */
    uint32_t failing_outputs;

    uint64_t now_ns;
    struct gpio_sim_script script;
    struct gpio_sim_event next_event;
    bool has_next;
    uint32_t seed;
    uint32_t held; /* Lines that are held by the tested driver, one bit for each role. */
    uint32_t open_count;
    bool chip_is_away, went;
    struct gpio_sim_line {
        uint8_t level; /* Level of the wire. 1 means active. */
        /* True if another edge arrived while the simulated kernel processed an edge. */
        bool pending;
        /* Time at which the kernel reads the level. 0 means that the kernel is idle. */
        uint64_t busy_until_ns;
        uint64_t stamp_ns; /* Time stamp of the edge that the simulated kernel processes. */
        uint32_t number;   /* Number of edges since the initialization, including dropped edges. */
        uint32_t seen;     /* Number of the last edge that was read. */
        bool was_full;     /* True if the last read found a full queue. */
        /* Level after the last edge that was read. At least one edge was lost if edges are not
         * numbered, `was_full` is true, and the next edge has this same level. */
        uint8_t last;
        /* Position of the oldest edge in `queue`, and number of edges in `queue`. */
        uint32_t first, count;
        struct {
            uint64_t time_ns;
            uint32_t number;
            uint8_t active;
        } queue[GPIO_SIM_QUEUE_MAX];
    } lines[GPIO_INPUT_COUNT];
    uint32_t dropped;                 /* Number of dropped edges of all lines. */
    uint8_t outputs[GPIO_ROLE_COUNT]; /* Level of each output. 1 means active. */
    /* Level of each output while no driver drives it. The bias sets this level. Without a bias the
     * level is low. */
    uint8_t rests[GPIO_ROLE_COUNT];
    struct gpio_sim_set sets[GPIO_SIM_SETS_MAX]; /* Ring buffer of the newest output changes. */
    /* Number of output changes since the initialization. */
    uint32_t set_count;
};

/* Initializes the simulation: the lines are released, the chip is present, the kernel has no delay,
 * and the queues work as with libgpiod 2.x. */
void gpio_lines_sim_init(struct gpio_lines_sim *sim, struct gpio_sim_script script, uint32_t seed);

/* A script of `count` events in memory. The array `events` must stay valid. The caller initializes
 * `next` with 0. */
struct gpio_sim_events {
    const struct gpio_sim_event *events;
    uint32_t count, next;
};
/* Returns a script that plays `events`. */
struct gpio_sim_script gpio_lines_sim_events_script(struct gpio_sim_events *events);

/* Advances the time by `ns` without reading edges, as if the GPIO thread did not run. */
void gpio_lines_sim_pass(struct gpio_lines_sim *sim, uint64_t ns);

/* Returns the simulated GPIO backend. */
struct gpio_lines gpio_lines_sim_device(struct gpio_lines_sim *sim);

/* Returns the simulated clock. */
struct hal_clock gpio_lines_sim_clock(struct gpio_lines_sim *sim);
