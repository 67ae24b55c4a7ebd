/* coin_rain.h -- simulates the input line of a coin slot over a long day. The simulated pulses have
 * every width that coin acceptors give, and contact bounce at both edges. Between them are knocks
 * (too short), jams (too long) and pairs of sparks, which can be as far apart as the edges of a
 * coin pulse. The kernel, the GPIO thread and the frame loop can be late. Equal seeds give equal
 * runs. */
#ifndef KINGYO_TESTS_GPIO_COIN_RAIN_H
#define KINGYO_TESTS_GPIO_COIN_RAIN_H

#include "drivers/gpio/gpio_thread.h"
#include "drivers/sim/gpio_lines_sim.h"

/* Largest number of edges of one pulse. Its two contacts have one edge each, plus two edges for
 * each of up to three bounces. */
#define RAIN_EDGES_MAX 14u

struct coin_rain {
    uint32_t left; /* Number of coins that are not inserted yet. */
    /* Number of coins, knocks, jams and pairs of sparks so far. */
    uint32_t coins, knocks, jams, sparks;
    uint64_t edges;
    uint64_t time_ns; /* Time at which the last pulse ended. */
    uint64_t seed;
    struct gpio_sim_event pulse[RAIN_EDGES_MAX];
    uint32_t edge_count, edge_next;
    /* 1 if the current pulse comes from a coin, otherwise 0. */
    uint8_t falls;
};

/* Result of a simulation of the coin slot. */
struct rain_result {
    uint32_t coins, knocks, jams; /* Number of coins, knocks and jams that were simulated. */
    uint32_t sparks;              /* Number of pairs of sparks that were simulated. */
    /* Number of pairs of sparks that looked like a coin, and that must therefore be reported as
     * faults. */
    uint32_t doubtful;
    uint32_t counted, faults; /* Number of coins and faults that the frame loop counted. */
    /* Number of polls at which the frame loop had counted more coins than were inserted. */
    uint32_t early;
    /* Number of polls at which a coin was still not counted 200 ms after its insertion. */
    uint32_t late;
    uint32_t dropped; /* Number of edges that were dropped because the kernel's queue was full. */
    /* Number of edges at which the kernel read the level too late, so that it read the same level
     * as before. */
    uint32_t blinks;
    uint32_t looks;
    uint64_t edges, longest_frame_ns, longest_stall_ns, time_ns;
};

struct rain_config {
    uint32_t coins;
    uint64_t seed;
    /* Kernel interface: 1 simulates libgpiod 2.x with a queue of 64 numbered edges. 0 simulates
     * libgpiod 1.6 with a queue of 16 edges without numbers. */
    uint8_t is_second;
};

/* Runs the simulation of `config`. Returns its result. */
struct rain_result coin_rain(const struct rain_config *config);

#endif
