/* ledger_salvage.h -- what a damaged file and the tail still say beyond a backup. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_SALVAGE_H
#define KINGYO_PLATFORM_STORE_LEDGER_SALVAGE_H

#include "platform/store/ledger_file.h"
#include "platform/store/ledger_tail.h"

/* Whether two lists of entries are one: by the newest that both have. */
enum ledger_kin {
    LEDGER_KIN_UNKNOWN = 0, /* They have none in common. */
    LEDGER_KIN_SAME,
    LEDGER_KIN_OTHER,       /* Of another stall, or one that was begun anew. */
};

/* Both look from the entry `last_id` of `file` backwards, as far as a tail is long. */
enum ledger_kin ledger_kin_of_tail(struct ledger_file *file, uint32_t last_id,
                                   const struct ledger_tail *tail);
enum ledger_kin ledger_kin_of_file(struct ledger_file *file, uint32_t last_id,
                                   struct ledger_file *other);

struct ledger_salvaged {
    uint32_t entries;     /* Found, ... */
    uint32_t lost;        /* ... and not found, of the ids behind those of `to` up to the newest
                             known. */
    bool is_open_ended;   /* Nobody knows what the newest was: there may be more lost than that. */
    bool has_others_tail; /* The tail is of another list: nothing of it was read. */
};

/* Reads from the file at `path`, which may be damaged anywhere, all entries beyond those of `to`
 * that are as they were written, those that are not from `tail`, and writes them to `to`; where
 * that can only be read (its `refusal`), to its content alone. What neither has is passed over: the
 * purse of the newest good one is the purse. `path` is null where there is no file, or one without
 * a byte: SQLite would remove the log of that. SQLite's code: an error is of writing, and `to` then
 * has not all that there is. */
int ledger_salvage(const char *path, const struct ledger_tail *tail, struct ledger_file *to,
                   struct ledger_salvaged *out);

#endif
