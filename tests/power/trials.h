/* trials.h -- simulates the trials of kiosks whose file calls fail as planned (fault.h).
 *
 * A trial consists of several parts. A part is one run of the kiosk, which ends with SIGKILL or
 * with a close of the store. The next part continues with the files as they are in the page cache.
 * After each part, the test simulates several power cuts, and compares the remaining files with the
 * data that were committed. */
#ifndef KINGYO_TESTS_POWER_TRIALS_H
#define KINGYO_TESTS_POWER_TRIALS_H

#include "tests/power/cutter.h"
#include "tests/power/fault.h"

struct trials_tally {
    struct tally cuts;
    uint64_t trials, kills, refused_starts;
    uint64_t failed[FAULT_CALL_COUNT]; /* Number of calls of each kind that failed according to the
                                          plans. */
};

struct trials {
    const char *folder; /* Folder in which the simulated kiosks write their files. */
    uint32_t count, seed, jobs;
};

/* Simulates the trials of all kiosks and adds the results to `sum`. Returns 0, or -1 if a worker
 * process died. */
int trials_run(const struct trials *trials, struct trials_tally *sum);

#endif
