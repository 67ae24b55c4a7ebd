/* goals.h -- the targets of the simulated players: what each player must catch at each level. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_GOALS_H
#define KINGYO_TESTS_BENCH_PLAYERS_GOALS_H

#include <stdbool.h>
#include <stdint.h>

#include "tests/bench/players/round.h"
#include "tests/bench/statistics.h"

/* Summary of the rounds of one player at one level. */
struct score {
    const char *player;
    const uint32_t *caught; /* Catch with each seed, in the order of the seeds. */
    double mean, median, empty_share;
};

/* Computes the summary of `count` rounds. The result refers to `caught`. `sorted` is a work area of
 * `count` elements. */
struct score goals_score(const char *player, const uint32_t *caught, uint32_t *sorted,
                         uint32_t count);

/* Compares the scores of the players at one level, each of `count` rounds, with the targets. Prints
 * a line for each missed target and returns their number. Targets of players who are not in
 * `scores` are skipped. */
uint32_t goals_check(const struct score *scores, uint32_t score_count, uint32_t count,
                     uint8_t level);

#endif
