/* lives.h -- short lives of a stall whose file calls fail by plan (fault.h): it plays, is killed or
 * closed, goes on from what the page cache says, and after each part the power is cut at several
 * places. What is left is held against what was reported as safe. */
#ifndef KINGYO_TESTS_POWER_LIVES_H
#define KINGYO_TESTS_POWER_LIVES_H

#include "tests/power/cutter.h"
#include "tests/power/fault.h"

struct lives_tally {
    struct tally cuts;
    uint64_t lives, kills, refused_starts;
    uint64_t failed[FAULT_CALL_COUNT]; /* Calls that the plans made fail. */
};

struct lives {
    const char *folder; /* To work in. */
    uint32_t count, seed, jobs;
};

/* 0, or -1 when a worker died. Adds to `sum`. */
int lives_run(const struct lives *lives, struct lives_tally *sum);

#endif
