/* league.h -- many rounds for a bench: played on every core, with a word of how far they are. */
#ifndef KINGYO_TESTS_BENCH_LEAGUE_H
#define KINGYO_TESTS_BENCH_LEAGUE_H

#include <stdint.h>
#include <stdio.h>

#include "platform/ctl/rounds.h"

#define LEAGUE_SEEDS_MAX 2000u
#define LEAGUE_ARMS_MAX 16u

/* One way to play, with each of the league's seeds. `results` are the league's. */
struct arm {
    const char *name;
    struct round_plan plan; /* Its seed is set by the league. */
    const struct round_result *results;
};

struct league {
    const char *speaker;
    uint32_t seeds; /* 1 .. LEAGUE_SEEDS_MAX of them, ... */
    uint32_t first; /* ... from this one on. */
    uint32_t arm_count;
    struct arm arms[LEAGUE_ARMS_MAX];
    double took_s;
};

/* Adds an arm, or finds one that plays just so; its index. */
uint32_t league_arm(struct league *league, const char *name, const struct round_plan *plan);

/* Plays all arms. EXIT_OK, or told. Results live until league_end(). */
enum exit_code league_play(struct league *league);
void league_end(struct league *league);

/* What arm `index` caught with each seed, into `caught[seeds]`. */
void league_caught(const struct league *league, uint32_t index, uint32_t *caught);

/* Writes each round of each arm into `name`, for whoever wants to count otherwise: tab-separated,
 * arm after arm, seed after seed. EXIT_OK, or EXIT_IO, told. */
enum exit_code league_write_rounds(const struct league *league, const char *folder,
                                   const char *name);

/* Where other figures go: opened for writing, or null, told. */
FILE *league_file(const struct league *league, const char *folder, const char *name);

/* Closes it. EXIT_OK, or EXIT_IO, told. */
enum exit_code league_close(const struct league *league, FILE *file, const char *name);

#endif
