/* lives.h -- simulates lives of a kiosk whose file calls fail as planned (fault.h). A life consists
 * of several parts. A part is one run of the kiosk that ends with SIGKILL or with a close of the
 * store. The next part continues with the files as the page cache has them. After each part, the
 * test simulates several power cuts and compares the remaining files with the committed data. */
#ifndef KINGYO_TESTS_POWER_LIVES_H
#define KINGYO_TESTS_POWER_LIVES_H

#include "tests/power/cutter.h"
#include "tests/power/fault.h"

struct lives_tally {
    struct tally cuts;
    uint64_t lives, kills, refused_starts;
    uint64_t failed[FAULT_CALL_COUNT]; /* Number of calls of each kind that failed as planned. */
};

struct lives {
    const char *folder; /* Folder in which the simulated kiosks write their files. */
    uint32_t count, seed, jobs;
};

/* Plays all lives and adds the results to `sum`. Returns 0, or -1 if a worker died. */
int lives_run(const struct lives *lives, struct lives_tally *sum);

#endif
