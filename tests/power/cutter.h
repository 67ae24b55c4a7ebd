/* cutter.h -- simulates power cuts after each file operation of a tape. A tape is the recorded list
 * of the file operations of a run (tape.h). After each cut the store opens the remaining files. The
 * test compares the loaded state with sums that it computed without the store (books.h). */
#ifndef KINGYO_TESTS_POWER_CUTTER_H
#define KINGYO_TESTS_POWER_CUTTER_H

#include <stdint.h>

#include "tests/power/books.h"
#include "tests/power/disk.h"

/* Counts of cuts and of violated promises. Each worker process writes its own tally in shared
 * memory. */
struct tally {
    uint64_t cuts, second_cuts;
    uint64_t by_luck[DISK_LUCK_COUNT];
    uint64_t unopenable, lost, ghosts, differing, replays_lost, edits_lost;
    uint64_t mornings; /* Number of cuts after which the test continued to play (go_on.h). */
    /* Number of tickets that were removed from the ledger although their dispenser pulse had not
     * begun. */
    uint64_t tickets_missing;
    /* Number of cuts after which the disk had more entries than the store had reported as
     * committed. */
    uint64_t ahead;
    uint64_t done; /* Progress: number of operations of the tape whose cuts are all done. */
    char first[BOOKS_WHY_SIZE + 100];
};

struct cutter {
    const struct tape *tape;
    /* books[n] has the totals (coins, rounds, balance) after the ledger entries 1 to n. */
    const struct books *books;
    const char *folder; /* Folder in which the test writes the files after a cut. */
    uint32_t ways;      /* Number of different power cuts to simulate after each operation. */
    uint32_t seed, jobs;
};

/* Data that the store must not lose in a power cut: the newest ledger entry, replay and morph graph
 * that were reported as committed (`acked`). Newer data up to `kept` was passed to the store and
 * may be lost. */
struct promise {
    uint32_t acked, kept, replay, edit_acked, edit_kept;
    uint32_t tickets; /* Number of tickets whose pulse had begun. */
};

/* Updates the promise if `op` is a mark. A mark is a note that the test records between two file
 * operations. */
void cutter_update_promise(struct promise *promise, const struct tape_op *op);

/* Opens the files that a cut left in `folder`, as the kiosk does at its next start, and counts each
 * violated promise. `where` describes the cut in error messages. */
void cutter_check(const struct cutter *cutter, struct tally *tally, const char *folder,
                  const struct promise *promise, const char *where);

/* Increments `count`, which is a counter of `tally`. Stores the message of the first fault. */
void tally_complain(struct tally *tally, uint64_t *count, const char *where, const char *why);
/* Adds the counts of `part` to `sum`. */
void tally_add(struct tally *sum, const struct tally *part);

/* Returns 1 if power cuts are simulated after this operation. No cut is simulated after a mark,
 * because a mark changes no file. */
int cutter_is_point(const struct tape_op *op);

/* Runs all cuts in several processes, adds the results to `sum`, and prints the progress on a
 * terminal. Returns 0, or -1 if a process died. */
int cutter_run(const struct cutter *cutter, struct tally *sum);

#endif
