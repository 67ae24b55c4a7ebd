/* ledger_recovery.h -- recovers entries that are newer than a backup, from a damaged database and
 * from the ledger mirror. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_RECOVERY_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_RECOVERY_H

#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/ledger_mirror.h"

/* Relation of two ledgers, determined from their newest common entry. */
enum ledger_relation {
    LEDGER_RELATION_UNKNOWN = 0, /* The ledgers have no common entry. */
    LEDGER_RELATION_SAME,
    LEDGER_RELATION_OTHER, /* The ledgers differ: one is foreign or was started again. */
};

/* Each function compares entry `last_id` of `file` and the entries before it with the mirror `tail`
 * or the file `other`. At most LEDGER_MIRROR_SLOTS entries are compared. The newest common entry
 * determines the result. */
enum ledger_relation ledger_recovery_relation_of_mirror(struct ledger_file *file, uint32_t last_id,
                                                        const struct ledger_mirror *tail);
enum ledger_relation ledger_recovery_relation_of_file(struct ledger_file *file, uint32_t last_id,
                                                      struct ledger_file *other);

struct ledger_recovered {
    uint32_t entries;     /* Number of recovered entries. */
    uint32_t lost;        /* Number of lost entries: ids between the last id of `to` and the newest
                             known id that were not recovered. */
    bool is_open_ended;   /* True if the newest id is unknown. More entries than `lost` may then be
                             lost. */
    bool has_others_tail; /* True if the ledger mirror belongs to a foreign ledger and was not
                             used. */
};

/* Copies all valid entries that are newer than the entries of `to` into `to`. An entry is read from
 * the file `path`, which may be damaged anywhere, or otherwise from the mirror `tail`. `path` is
 * null if the file is missing or empty, because SQLite would delete the log of an empty file.
 * Missing entries are skipped, and the newest valid entry sets the balance. If to->refusal is not
 * 0, only to->content is updated. Returns an SQLite code. An error means that writing failed and
 * `to` is incomplete. */
int ledger_recover(const char *path, const struct ledger_mirror *tail, struct ledger_file *to,
                   struct ledger_recovered *out);

#endif
