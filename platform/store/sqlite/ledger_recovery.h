/* ledger_recovery.h -- recovers entries that are newer than a backup from a damaged file and the
 * mirror. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_RECOVERY_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_RECOVERY_H

#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/ledger_mirror.h"

/* Result of comparing two ledgers by their newest common entry. */
enum ledger_relation {
    LEDGER_RELATION_UNKNOWN = 0, /* No common entry. */
    LEDGER_RELATION_SAME,
    LEDGER_RELATION_OTHER, /* A foreign ledger, or one that was started again. */
};

/* Compare from entry `last_id` of `file` backwards, over the length of a mirror. */
enum ledger_relation ledger_recovery_relation_of_mirror(struct ledger_file *file, uint32_t last_id,
                                                        const struct ledger_mirror *tail);
enum ledger_relation ledger_recovery_relation_of_file(struct ledger_file *file, uint32_t last_id,
                                                      struct ledger_file *other);

struct ledger_recovered {
    uint32_t entries;     /* Entries recovered. */
    uint32_t lost;        /* Entries lost: ids after the last id of `to` up to the newest known id
                             that were not recovered. */
    bool is_open_ended;   /* 1: the newest id is unknown, so that more entries may be lost. */
    bool has_others_tail; /* 1: the mirror belongs to a foreign ledger and was not used. */
};

/* Copies all valid entries that are newer than those of `to`. An entry comes from the file at
 * `path`, which may be damaged anywhere, or otherwise from `tail`. If `to` is read-only (its
 * `refusal`), only its content is updated. Missing entries are skipped, and the newest valid entry
 * sets the balance. `path` is null if the file is missing or empty, because SQLite would delete the
 * log of an empty file. Returns an SQLite code. An error is an error of writing, and then `to` is
 * incomplete. */
int ledger_recover(const char *path, const struct ledger_mirror *tail, struct ledger_file *to,
                   struct ledger_recovered *out);

#endif
