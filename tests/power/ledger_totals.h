/* ledger_totals.h -- computes the totals that the store must load after a power cut.
 *
 * The test records which ledger entries were passed to the store, and which of them the store
 * reported as committed. After a cut, the last entry of the store may be the newest committed
 * entry, the newest passed entry, or any entry between them. All loaded totals must then be exactly
 * the totals of the entries up to this last entry. */
#ifndef KINGYO_TESTS_POWER_LEDGER_TOTALS_H
#define KINGYO_TESTS_POWER_LEDGER_TOTALS_H

#include <stdint.h>

#include "core/persistent_state.h"

#define LEDGER_TOTALS_WHY_SIZE 200u

/* Totals of the ledger entries 1 to n. The totals of the entries 1 to n + 1 are made from a copy,
 * to which entry n + 1 is added. */
struct ledger_totals {
    /* Totals for which struct persistent_state has no counters. */
    uint32_t coins, services, rounds, caught, refunds;
    struct balance balance;
    struct ledger_stand stand; /* State of the round that has not ended yet. */
    struct settings settings;
    struct audits audits;
    struct ranking ranking;
};

/* Initializes the totals for a store without entries. */
void ledger_totals_open(struct ledger_totals *totals);
/* Adds one ledger entry to the totals. */
void ledger_totals_add(struct ledger_totals *totals, const struct ledger_entry *entry);

/* Values that ledger_totals_read() reads from the database with SQL queries of its own.
 * ledger_totals_agree() compares these values with the totals. */
struct ledger_totals_file {
    /* Number of rounds in the database, total of the fish that were caught in them, and number of
     * round ids that occur twice. */
    int64_t rounds, caught, doubled;
    /* Number of replays in the database, and number of replays with the bytes of another round. */
    int64_t replays, bad_replays;
    int has_replay; /* 1 if the database has the replay of the requested round. */
    char integrity[64];
};

/* Reads the values of `out` from the database at `path`. Returns 0, or an error code of SQLite. */
int ledger_totals_read(const char *path, uint32_t replay_id, struct ledger_totals_file *out);

/* Compares the totals with the state that the store loaded and with the values of the database.
 * Returns 0 if all of them agree. Otherwise writes the first difference to `why`. */
int ledger_totals_agree(const struct ledger_totals *totals, const struct persistent_state *memory,
                        const struct ledger_totals_file *file, char why[LEDGER_TOTALS_WHY_SIZE]);

#endif
