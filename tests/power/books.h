/* books.h -- computes the state that a store must load after a power cut.
 *
 * The inputs are the entries that were passed to the store and the entries that the store reported
 * as committed. The store may have written any number of entries between the newest committed one
 * and the newest one that was passed. Whatever that number is, every other value must be exactly
 * the sum of those entries. */
#ifndef KINGYO_TESTS_POWER_BOOKS_H
#define KINGYO_TESTS_POWER_BOOKS_H

#include <stdint.h>

#include "core/persistent_state.h"

#define BOOKS_WHY_SIZE 200u

/* All sums of the entries 1 to n. The sums for n + 1 begin as a copy of the sums for n, to which
 * entry n + 1 is added. */
struct books {
    /* Totals of which the store has no counter. */
    uint32_t coins, services, rounds, caught, refunds;
    struct balance balance;
    struct ledger_stand stand; /* State of the open round. */
    struct settings settings;
    struct audits audits;
    struct ranking ranking;
};

/* Initializes the sums for a store without entries. */
void books_open(struct books *books);
/* Adds one ledger entry to the sums. */
void books_add(struct books *books, const struct ledger_entry *entry);

/* Values that books_read() reads directly from the database, for comparison with the result of
 * remember(). */
struct books_file {
    int64_t rounds, caught, doubled; /* Number of rows of rounds, total of their fish, and number of
                                        ids that occur twice. */
    int64_t replays, bad_replays;    /* Number of replay rows, and of those whose bytes do not
                                        belong to their round. */
    int has_replay;                  /* 1 if the requested round has a replay. */
    char integrity[64];
};

/* Reads the database at `path`. Returns 0, or an error code of SQLite. */
int books_read(const char *path, uint32_t replay_id, struct books_file *out);

/* Compares the sums with the loaded state and with the file. Returns 0 if all values agree.
 * Otherwise `why` names the first difference. */
int books_agree(const struct books *books, const struct persistent_state *memory,
                const struct books_file *file, char why[BOOKS_WHY_SIZE]);

#endif
