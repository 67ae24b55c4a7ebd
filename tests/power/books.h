/* books.h -- what must be found after a power cut, from what was handed over and what was promised.
 *
 * A store may have written any number of entries between the newest that it promised and the newest
 * that it was given. Whatever that number is, all else must be exactly the sum of those entries. */
#ifndef KINGYO_TESTS_POWER_BOOKS_H
#define KINGYO_TESTS_POWER_BOOKS_H

#include <stdint.h>

#include "core/memory.h"

#define BOOKS_WHY_SIZE 200u

/* All sums of entries 1 .. n, made one by one; each is copied from the one before. */
struct books {
    uint32_t coins, units_taken, services, rounds, caught, refunds; /* Counted here alone. */
    struct purse purse;
    struct ledger_stand stand; /* Of the open round. */
    struct settings settings;
    struct audits audits;
    struct ranking ranking;
};

void books_open(struct books *books);
void books_add(struct books *books, const struct ledger_entry *entry);

/* What the database itself says (books_read()), beside what remember() said. */
struct books_file {
    int64_t rounds, caught, doubled; /* Rows of rounds, their fish, ids that are there twice. */
    int64_t replays, bad_replays;    /* Rows, and those whose bytes are not their round's. */
    int has_replay;                  /* Of the round that was asked for. */
    char integrity[64];
};

/* 0, or a code of SQLite's. */
int books_read(const char *path, uint32_t replay_id, struct books_file *out);

/* 0 when all agree; else `why` says what does not. */
int books_agree(const struct books *books, const struct memory *memory,
                const struct books_file *file, char why[BOOKS_WHY_SIZE]);

#endif
