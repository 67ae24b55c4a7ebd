/* coin_rain.h -- a coin slot's line through a long day: coins of every width that acceptors give,
 * contacts that bounce at both ends, knocks and jams between them, and sparks, two of them as far
 * apart as a coin's edges; over a kernel that is late and a thread and a frame loop that are not
 * run for a while. The same from the same seed. */
#ifndef KINGYO_TESTS_GPIO_COIN_RAIN_H
#define KINGYO_TESTS_GPIO_COIN_RAIN_H

#include "drivers/buttons_gpio.h"
#include "drivers/gpio_lines_sim.h"

#define RAIN_EDGES_MAX 14u /* Of one pulse: two contacts of at most 1 + 2 * 3 edges. */

struct coin_rain {
    uint32_t left;  /* Coins that have not fallen. */
    uint32_t coins, knocks, jams, sparks; /* That have; pairs of sparks. */
    uint64_t edges;
    uint64_t time_ns;             /* Where the last pulse ended. */
    uint64_t seed;
    struct gpio_sim_event pulse[RAIN_EDGES_MAX];
    uint32_t edge_count, edge_next;
    uint8_t falls;                /* The pulse in `pulse` is a coin. */
};

/* What came of a rain. */
struct rain_result {
    uint32_t coins, knocks, jams;   /* That fell. */
    uint32_t sparks;                /* Pairs of them, */
    uint32_t doubtful;              /* and those that might have been coins: faults. */
    uint32_t counted, faults;       /* By the frame loop. */
    uint32_t early;                 /* Looks that had counted more than had fallen. */
    uint32_t late;                  /* Looks that missed a coin of two looks and 200 ms ago. */
    uint32_t dropped;               /* Edges that the kernel's queue had no room for. */
    uint32_t blinks;                /* Edges that changed nothing: read late. */
    uint32_t looks;
    uint64_t edges, longest_frame_ns, longest_stall_ns, time_ns;
};

struct rain_config {
    uint32_t coins;
    uint64_t seed;
    uint8_t is_second;  /* libgpiod 2.x' queue of 64 with numbers; else 1.6's of 16 without. */
};

/* Lets it rain. */
struct rain_result coin_rain(const struct rain_config *config);

#endif
