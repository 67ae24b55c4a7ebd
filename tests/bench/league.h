/* league.h -- plays many rounds for a benchmark on all processor cores, and reports the progress. A
 * league has several arms (ways to play), each of which plays the same seeds. */
#ifndef KINGYO_TESTS_BENCH_LEAGUE_H
#define KINGYO_TESTS_BENCH_LEAGUE_H

#include <stdint.h>
#include <stdio.h>

#include "platform/ctl/play/rounds.h"

#define LEAGUE_SEEDS_MAX 2000u
#define LEAGUE_ARMS_MAX 16u

/* One way to play. The league owns `results`, which has one result for each seed. */
struct arm {
    const char *name;
    struct round_plan plan; /* Plan of the rounds. The league sets the seed of each round. */
    const struct round_result *results;
};

struct league {
    const char *prefix;
    uint32_t seeds; /* Number of seeds, 1 .. LEAGUE_SEEDS_MAX. */
    uint32_t first; /* First seed. The other seeds are the next numbers. */
    uint32_t arm_count;
    struct arm arms[LEAGUE_ARMS_MAX];
    double took_s;
};

/* Adds an arm (a way to play) with the plan `plan`. If an arm with the same plan exists, no arm is
 * added. Returns the index of the arm with this plan. */
uint32_t league_arm(struct league *league, const char *name, const struct round_plan *plan);

/* Plays all rounds of all arms. Returns EXIT_OK, or the code of an error whose message was printed.
 * The results stay valid until league_end(). */
enum exit_code league_play(struct league *league);
/* Frees the results of all arms and removes the arms. */
void league_end(struct league *league);

/* Copies the number of fish that arm `index` caught with each seed into `caught`, which has room
 * for `seeds` elements. */
void league_caught(const struct league *league, uint32_t index, uint32_t *caught);

/* Writes one row for each round of each arm into the file `name` in `folder`, for use with other
 * statistics. The columns are separated by tabs. The rows are ordered by arm and then by seed.
 * Returns EXIT_OK, or EXIT_IO after an error message. */
enum exit_code league_write_rounds(const struct league *league, const char *folder,
                                   const char *name);

/* Opens the file `name` in `folder` for writing, so that a benchmark can write its own figures.
 * Returns the open file, or null after an error message. */
FILE *league_file(const struct league *league, const char *folder, const char *name);

/* Closes `file`. Returns EXIT_OK, or EXIT_IO after an error message. */
enum exit_code league_close(const struct league *league, FILE *file, const char *name);

#endif
