/* cutter.h -- simulates a power cut after each file operation of a tape, in several ways. A tape is
 * the recorded list of the file operations of a run (tape.h). After each cut the store opens the
 * remaining files, and the test compares the loaded state with sums of its own (books.h). */
#ifndef KINGYO_TESTS_POWER_CUTTER_H
#define KINGYO_TESTS_POWER_CUTTER_H

#include <stdint.h>

#include "tests/power/books.h"
#include "tests/power/disk.h"

/* Results of the cuts. Each worker process writes its own tally in shared memory. */
struct tally {
    uint64_t cuts, second_cuts;
    uint64_t by_luck[DISK_LUCK_COUNT];
    uint64_t unopenable, lost, ghosts, differing, replays_lost, edits_lost;
    uint64_t mornings;        /* Number of cuts after which the test continued to play (go_on.h). */
    uint64_t tickets_missing; /* Number of tickets that the ledger had removed and whose pulse had
                                 not begun. */
    uint64_t ahead; /* Number of cuts after which more entries were on the disk than were reported
                       as committed. */
    uint64_t done;  /* Number of tape operations that are done. */
    char first[BOOKS_WHY_SIZE + 100];
};

struct cutter {
    const struct tape *tape;
    const struct books *books; /* Sums indexed by entry id, up to the newest entry that was passed
                                  to the store. */
    const char *folder;        /* Working folder. */
    uint32_t ways;             /* Number of cuts for each operation. */
    uint32_t seed, jobs;
};

/* What the kiosk had promised when the power was cut: the ids of the newest entry, replay and graph
 * that were passed to the store (`kept`), and of the newest that the store had reported as
 * committed (`acked`). */
struct promise {
    uint32_t acked, kept, replay, edit_acked, edit_kept;
    uint32_t tickets; /* Number of tickets whose pulse had begun. */
};

/* Updates the promise if `op` is a mark, a note of the test between two file operations of the
 * tape. */
void cutter_update_promise(struct promise *promise, const struct tape_op *op);

/* Opens the files that a cut left in `folder`, as the kiosk does at its next start, and counts each
 * violated promise. `where` names the cut in messages. */
void cutter_check(const struct cutter *cutter, struct tally *tally, const char *folder,
                  const struct promise *promise, const char *where);

/* Adds one to `count`, which is a field of `tally`. The text of the first fault is stored. */
void tally_complain(struct tally *tally, uint64_t *count, const char *where, const char *why);
/* Adds the counts of `part` to `sum`. */
void tally_add(struct tally *sum, const struct tally *part);

/* Returns 1 if a cut may follow this operation. Marks are not file operations. */
int cutter_is_point(const struct tape_op *op);

/* Runs all cuts in several processes, adds the results to `sum`, and prints the progress on a
 * terminal. Returns 0, or -1 if a process died. */
int cutter_run(const struct cutter *cutter, struct tally *sum);

#endif
