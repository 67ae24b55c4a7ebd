/* cutter.h -- the power goes after each file operation of a tape, in several ways; the store is
 * opened on what is left, and what it remembers is held against the books. */
#ifndef KINGYO_TESTS_POWER_CUTTER_H
#define KINGYO_TESTS_POWER_CUTTER_H

#include <stdint.h>

#include "tests/power/books.h"
#include "tests/power/disk.h"

/* What became of so many cuts. Workers write their own; shared memory. */
struct tally {
    uint64_t cuts, second_cuts;
    uint64_t by_luck[DISK_LUCK_COUNT];
    uint64_t unopenable, lost, ghosts, differing, replays_lost;
    uint64_t mornings; /* In which it was played on (go_on.h). */
    uint64_t ahead; /* More was on disk than had been promised. */
    uint64_t done;  /* Of the tape. */
    char first[BOOKS_WHY_SIZE + 100];
};

struct cutter {
    const struct tape *tape;
    const struct books *books; /* [id], up to the newest entry that was handed over. */
    const char *folder;        /* To work in. */
    uint32_t ways;             /* For each operation. */
    uint32_t seed, jobs;
};

/* Whether the power may go after this: marks are no operations. */
int cutter_is_point(const struct tape_op *op);

/* Adds to `sum`. In so many processes; tells its progress on a terminal. 0, or -1 when one died. */
int cutter_run(const struct cutter *cutter, struct tally *sum);

#endif
