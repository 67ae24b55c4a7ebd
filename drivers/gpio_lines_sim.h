/* gpio_lines_sim.h -- lines made of memory: what wires, contacts and the kernel do, on a clock of
 * their own.
 *
 * A script moves the wires. Between them and wait() stands the kernel as it is: its thread reads a
 * level late, edges that come meanwhile are one edge at its end, and a queue of a fixed size drops
 * what does not fit, with numbers (libgpiod 2.x) or without a word (1.6). Chips go and come back,
 * lines are held by others. Time passes in wait() alone, and by gpio_lines_sim_pass(). The caller
 * owns the state; all of it is one thread's. */
#ifndef KINGYO_DRIVERS_GPIO_LINES_SIM_H
#define KINGYO_DRIVERS_GPIO_LINES_SIM_H

#include "drivers/gpio_lines.h"

#define GPIO_SIM_QUEUE_MAX 64u

enum gpio_sim_what {
    GPIO_SIM_LEVEL = 0, /* The wire of `role` is at `active` (after active_low) from now on. */
    GPIO_SIM_SPARK,     /* It comes and goes as one edge: of chips with one event bit a line. */
    GPIO_SIM_GONE,      /* The chip of every line is pulled out ... */
    GPIO_SIM_BACK,      /* ... and plugged in again. Wires move meanwhile, unseen. */
};

struct gpio_sim_event {
    uint64_t time_ns;
    uint8_t what; /* enum gpio_sim_what */
    uint8_t role; /* An input. */
    uint8_t active;
};

/* Gives events in the order of their times; false: that was the last. */
struct gpio_sim_script {
    bool (*next)(void *self, struct gpio_sim_event *out);
    void *self;
};

/* What was done to an output. */
#define GPIO_SIM_SETS_MAX 64u
struct gpio_sim_set {
    uint64_t time_ns;
    uint8_t role, active;
};

struct gpio_lines_sim {
    /* As the caller likes it, after gpio_lines_sim_init(). */
    uint32_t queue_size;              /* 16: as libgpiod 1.6; at most GPIO_SIM_QUEUE_MAX. */
    uint8_t is_numbered;              /* 2.x: drops the oldest, and it shows; else the newest. */
    uint8_t kernel_debounces;         /* Claimed, not done: the script has no bounce then. */
    uint64_t late_min_ns, late_max_ns; /* How long after an edge the kernel reads the level. */
    uint32_t held_by_others;          /* A bit each role that cannot be had. */

    uint64_t now_ns;
    struct gpio_sim_script script;
    struct gpio_sim_event next_event;
    bool has_next;
    uint32_t seed;
    uint32_t held;                    /* Roles that are asked for and had, a bit each. */
    uint32_t open_count;
    bool chip_is_away, went;
    struct gpio_sim_line {
        uint8_t level;                /* Of the wire. */
        uint8_t pending;              /* An edge came while the kernel was at the one before. */
        uint64_t busy_until_ns;       /* When the kernel reads the level; 0: it is at none. */
        uint64_t stamp_ns;            /* Of the edge that it is at. */
        uint32_t number;              /* Edges so far. */
        uint32_t seen;                /* Number of the last that was taken. */
        uint8_t was_full, last;       /* As libgpiod 1.6's reader infers a loss. */
        uint32_t first, count;        /* Of the queue, a ring. */
        struct { uint64_t time_ns; uint32_t number; uint8_t active; } queue[GPIO_SIM_QUEUE_MAX];
    } lines[GPIO_INPUT_COUNT];
    uint32_t dropped;                 /* Edges that found no place, of all lines. */
    uint8_t outputs[GPIO_ROLE_COUNT]; /* Levels, after active_low. */
    uint8_t rests[GPIO_ROLE_COUNT];   /* Of what nobody drives: their bias, or low. */
    struct gpio_sim_set sets[GPIO_SIM_SETS_MAX]; /* The newest, a ring ... */
    uint32_t set_count;               /* ... of all that were. */
};

/* Lines at rest, a chip that is there, a kernel that is prompt, queues as of libgpiod 2.x. */
void gpio_lines_sim_init(struct gpio_lines_sim *sim, struct gpio_sim_script script, uint32_t seed);

/* Plays `count` events of memory, which must outlive the script; `events->next` is 0 at first. */
struct gpio_sim_events {
    const struct gpio_sim_event *events;
    uint32_t count, next;
};
struct gpio_sim_script gpio_sim_events_script(struct gpio_sim_events *events);

/* Lets time pass while nobody waits: a thread that was not run. */
void gpio_lines_sim_pass(struct gpio_lines_sim *sim, uint64_t ns);

struct gpio_lines gpio_lines_sim_device(struct gpio_lines_sim *sim);

/* The clock of its time. */
struct hal_clock gpio_lines_sim_clock(struct gpio_lines_sim *sim);

#endif
