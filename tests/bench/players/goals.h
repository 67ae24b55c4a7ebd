/* goals.h -- the targets of the simulated players: how many fish each player must catch at each
 * level. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_GOALS_H
#define KINGYO_TESTS_BENCH_PLAYERS_GOALS_H

#include <stdbool.h>
#include <stdint.h>

#include "tests/bench/players/round.h"
#include "tests/bench/statistics.h"

/* Summary of the rounds of one player at one level. */
struct score {
    const char *player;
    /* Number of fish caught in each round, in the order of the seeds. */
    const uint32_t *caught;
    double mean, median, empty_share;
};

/* Computes the summary of `count` rounds. The result keeps the pointer `caught`. The function uses
 * `sorted` as a work area of `count` elements. */
struct score goals_score(const char *player, const uint32_t *caught, uint32_t *sorted,
                         uint32_t count);

/* Compares the scores of the players at one level, each of `count` rounds, with the targets. Prints
 * a line for each missed target and returns their number. Targets of players who are not in
 * `scores` are skipped. */
uint32_t goals_check(const struct score *scores, uint32_t score_count, uint32_t count,
                     uint8_t level);

#endif
