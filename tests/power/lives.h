/* lives.h -- plays short lives of a stall whose file calls fail as planned (fault.h). A life
 * consists of several parts. A part ends with SIGKILL or with a close, and the next part continues
 * with the files that the system's page cache holds. After each part, the test simulates power cuts
 * at several places, and compares the remaining files with the data that was reported as
 * committed. */
#ifndef KINGYO_TESTS_POWER_LIVES_H
#define KINGYO_TESTS_POWER_LIVES_H

#include "tests/power/cutter.h"
#include "tests/power/fault.h"

struct lives_tally {
    struct tally cuts;
    uint64_t lives, kills, refused_starts;
    uint64_t failed[FAULT_CALL_COUNT]; /* Calls that failed as planned. */
};

struct lives {
    const char *folder; /* Working folder. */
    uint32_t count, seed, jobs;
};

/* Plays all lives and adds the results to `sum`. Returns 0, or -1 if a worker died. */
int lives_run(const struct lives *lives, struct lives_tally *sum);

#endif
