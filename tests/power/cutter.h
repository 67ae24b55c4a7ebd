/* cutter.h -- simulates power cuts after each file operation of a tape, which is the recorded list
 * of the file operations of a run (tape.h).
 *
 * After each cut, the store opens the files that are left. The test compares the loaded state with
 * totals that it computed without the store (ledger_totals.h). */
#ifndef KINGYO_TESTS_POWER_CUTTER_H
#define KINGYO_TESTS_POWER_CUTTER_H

#include <stdbool.h>
#include <stdint.h>

#include "tests/power/ledger_totals.h"
#include "tests/power/disk.h"

/* Counts of simulated cuts, and of the faults that were found after them. Each worker process
 * writes its own counts to shared memory. */
struct tally {
    uint64_t cuts, second_cuts;
    uint64_t by_luck[DISK_LUCK_COUNT];
    uint64_t unopenable, lost, ghosts, differing, replays_lost, edits_lost;
    uint64_t mornings; /* Number of cuts after which the test also continued to play (resume.h). */
    /* Number of tickets that were removed from the ledger although their dispenser pulse had not
     * begun. */
    uint64_t tickets_missing;
    /* Number of cuts after which the disk had more entries than the store had reported as
     * committed. This is allowed. */
    uint64_t ahead;
    uint64_t done; /* Number of operations of the tape for which all cuts are done, to show the
                      progress. */
    char first[LEDGER_TOTALS_WHY_SIZE + 100];
};

struct cutter {
    const struct tape *tape;
    /* Totals of the ledger entries (coins, rounds, balance). totals[n] has the totals of the
     * entries 1 to n. */
    const struct ledger_totals *totals;
    const char *folder; /* Folder for the files that a simulated cut leaves. */
    uint32_t ways;      /* Number of different power cuts after each file operation. */
    uint32_t seed, jobs;
};

/* Data that the store must still have after a power cut: the newest ledger entry, replay and morph
 * graph that the store reported as committed (`acked`). Later entries and graphs, up to `kept`,
 * were passed to the store but may be lost. */
struct promise {
    uint32_t acked, kept, replay, edit_acked, edit_kept;
    uint32_t tickets; /* Number of tickets whose dispenser pulse had begun. */
};

/* Updates `promise` if `op` is a mark instead of a file operation. A mark is a note of the test,
 * for example that an entry was committed. */
void cutter_update_promise(struct promise *promise, const struct tape_op *op);

/* Opens the files that a cut left in `folder`, as the kiosk does at its next start. Counts a fault
 * in `tally` for each part of `promise` that is not kept. `where` describes the cut in error
 * messages. */
void cutter_check(const struct cutter *cutter, struct tally *tally, const char *folder,
                  const struct promise *promise, const char *where);

/* Increments `count`, which must be a counter in `tally`. If this is the first fault, also stores
 * its message. */
void tally_complain(struct tally *tally, uint64_t *count, const char *where, const char *why);
/* Adds the counts of `part` to `sum`. */
void tally_add(struct tally *sum, const struct tally *part);

/* Returns 1 if the power is cut after this operation. A mark changes no file, so the function
 * returns 0 for it. */
bool cutter_is_point(const struct tape_op *op);

/* Simulates all cuts in several processes and adds their counts to `sum`. Prints the progress if
 * the output is a terminal. Returns 0, or -1 if a process died. */
int cutter_run(const struct cutter *cutter, struct tally *sum);

#endif
