/* books.h -- computes the state that a store must load after a power cut.
 *
 * The test knows which ledger entries were passed to the store, and which of them the store
 * reported as committed. After a cut the store may load any entry between the newest committed one
 * and the newest passed one as its last entry. All loaded totals must then be exactly the sums of
 * the entries up to that last entry. */
#ifndef KINGYO_TESTS_POWER_BOOKS_H
#define KINGYO_TESTS_POWER_BOOKS_H

#include <stdint.h>

#include "core/persistent_state.h"

#define BOOKS_WHY_SIZE 200u

/* All sums of the entries 1 to n. The sums for n + 1 begin as a copy of the sums for n, to which
 * entry n + 1 is added. */
struct books {
    /* Totals for which struct persistent_state has no counter. */
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

/* Values that books_read() reads from the database by its own SQL queries. books_agree() compares
 * these values with the state that the store loaded. */
struct books_file {
    /* Number of rows in the table of rounds, total of the fish caught in them, and number of round
     * ids that occur twice. */
    int64_t rounds, caught, doubled;
    /* Number of replay rows, and number of replay rows whose bytes belong to another round. */
    int64_t replays, bad_replays;
    int has_replay; /* 1 if the requested round has a replay. */
    char integrity[64];
};

/* Reads the database at `path`. Returns 0, or an error code of SQLite. */
int books_read(const char *path, uint32_t replay_id, struct books_file *out);

/* Compares the sums with the loaded state and with the file. Returns 0 if all values agree.
 * Otherwise `why` names the first difference. */
int books_agree(const struct books *books, const struct persistent_state *memory,
                const struct books_file *file, char why[BOOKS_WHY_SIZE]);

#endif
