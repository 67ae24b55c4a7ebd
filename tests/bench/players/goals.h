/* goals.h -- the targets of the simulated players: for each level, what each player must catch. */
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

/* Computes the summary of `count` rounds. `caught` is kept, `sorted` is work area. */
struct score goals_score(const char *player, const uint32_t *caught, uint32_t *sorted,
                         uint32_t count);

/* Compares the scores of all players of one level, with `count` rounds each, with the targets.
 * Prints one line for each missed target. Returns the number of missed targets. A target of a
 * player who is not among the scores is skipped. */
uint32_t goals_check(const struct score *scores, uint32_t score_count, uint32_t count,
                     uint8_t level);

#endif
