/* coin_rain.h -- simulates the line of a coin slot over a long day.
 *
 * The simulation has coins of every width that coin acceptors give, contacts that bounce at both
 * ends, knocks, jams and sparks. Two sparks can be as far apart as the edges of a coin. The kernel
 * can be late, and the thread and the frame loop can be delayed. Equal seeds give equal runs. */
#ifndef KINGYO_TESTS_GPIO_COIN_RAIN_H
#define KINGYO_TESTS_GPIO_COIN_RAIN_H

#include "drivers/gpio/gpio_thread.h"
#include "drivers/sim/gpio_lines_sim.h"

/* Largest number of edges of one pulse: two contacts of at most 1 + 2 * 3 edges. */
#define RAIN_EDGES_MAX 14u

struct coin_rain {
    uint32_t left;                        /* Coins that have not fallen yet. */
    uint32_t coins, knocks, jams, sparks; /* Coins, knocks, jams and pairs of sparks that have
                                             occurred. */
    uint64_t edges;
    uint64_t time_ns; /* Time at which the last pulse ended. */
    uint64_t seed;
    struct gpio_sim_event pulse[RAIN_EDGES_MAX];
    uint32_t edge_count, edge_next;
    uint8_t falls; /* 1 if the present pulse comes from a coin. */
};

/* Result of a simulation. */
struct rain_result {
    uint32_t coins, knocks, jams; /* Coins, knocks and jams that occurred. */
    uint32_t sparks;              /* Pairs of sparks that occurred. */
    uint32_t doubtful;            /* Pairs of sparks that could have been a coin and must be
                                     reported as faults. */
    uint32_t counted, faults;     /* Coins and faults that the frame loop counted. */
    uint32_t early;               /* Polls at which more coins were counted than had fallen. */
    uint32_t late;                /* Polls at which a coin was missing that had fallen at least
                                     200 ms earlier. */
    uint32_t dropped;             /* Edges that were dropped because the kernel's queue was full. */
    uint32_t blinks;              /* Edges that changed nothing because the kernel read the level
                                     late. */
    uint32_t looks;
    uint64_t edges, longest_frame_ns, longest_stall_ns, time_ns;
};

struct rain_config {
    uint32_t coins;
    uint64_t seed;
    uint8_t is_second; /* 1 simulates libgpiod 2.x with a queue of 64 numbered edges. 0 simulates
                          libgpiod 1.6 with a queue of 16 edges without numbers. */
};

/* Runs the simulation of `config`. Returns its result. */
struct rain_result coin_rain(const struct rain_config *config);

#endif
