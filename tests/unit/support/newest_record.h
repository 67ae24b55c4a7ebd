/* newest_record.h -- finds the record of the newest scored round in the output of the core. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_NEWEST_RECORD_H
#define KINGYO_TESTS_UNIT_SUPPORT_NEWEST_RECORD_H

#include "core/output.h"

/* Returns the record of the newest scored round among the last LEDGER_RING entries, or a record of
 * zeros if there is no such round. */
static inline const struct round_record *newest_record(const struct output *out)
{
    static const struct round_record none;
    for (uint32_t i = 0; i < LEDGER_RING && i < out->entry_id; i++) {
        const struct ledger_entry *entry = &out->entries[(out->entry_id - i) % LEDGER_RING];
        if (entry->kind == LEDGER_ROUND && !entry->round.unscored) {
            return &entry->round;
        }
    }
    return &none;
}

#endif
