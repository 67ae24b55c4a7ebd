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
    uint64_t unopenable, lost, ghosts, differing, replays_lost, edits_lost;
    uint64_t mornings; /* In which it was played on (go_on.h). */
    uint64_t tickets_missing; /* A ticket had left the ledger, and its pulse had not begun. */
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

/* What the frame loop knew when the power went: newest numbers that were handed over and that were
 * reported as safe. */
struct promise {
    uint32_t acked, kept, replay, edit_acked, edit_kept;
    uint32_t tickets; /* Whose pulse had begun. */
};

void cutter_heed(struct promise *promise, const struct tape_op *op);

/* Opens what a cut left in `folder`, as the kiosk does in the morning, and counts what is not as
 * promised; `where` names the cut. */
void cutter_look(const struct cutter *cutter, struct tally *tally, const char *folder,
                 const struct promise *promise, const char *where);

/* Counts a fault in `count`, a field of `tally`; the first is kept in words. */
void tally_complain(struct tally *tally, uint64_t *count, const char *where, const char *why);
void tally_add(struct tally *sum, const struct tally *part);

/* Whether the power may go after this: marks are no operations. */
int cutter_is_point(const struct tape_op *op);

/* Adds to `sum`. In so many processes; tells its progress on a terminal. 0, or -1 when one died. */
int cutter_run(const struct cutter *cutter, struct tally *sum);

#endif
