/* round_pool.h -- plays the rounds of many simulated players (round.h) on all processor cores, and
 * prints the progress. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_ROUND_POOL_H
#define KINGYO_TESTS_BENCH_PLAYERS_ROUND_POOL_H

#include "tests/bench/players/round.h"
#include "tests/bench/progress.h"

/* One round that the pool plays. The caller owns `habits` and `result`, and both must stay valid
 * while the pool plays. */
struct pool_round {
    const struct habits *habits;
    uint32_t seed;
    struct player_round *result;
};

/* Converts the name of a level to its number (enum level). Returns false if no level has this
 * name. */
bool round_pool_level(const char *name, uint8_t *level);

/* Plays the `count` rounds of `rounds` at the level `level` (enum level), in the order of the
 * array. `prefix` is the program's name in the output. Writes the duration in seconds to `took_s`.
 * Returns false, after an error message, if a round did not end. */
bool round_pool_play(const char *prefix, const struct pool_round *rounds, uint32_t count,
                     uint8_t level, double *took_s);

#endif
