/* balance.h -- functions that read credits, audit counters and ledger entries of a core under test.
 * The ledger is the list of all money events, to which entries are only appended. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_BALANCE_H
#define KINGYO_TESTS_UNIT_SUPPORT_BALANCE_H

#include "core/core.h"
#include "tests/unit/support/newest_record.h"

/* Returns the sum of paid credits and service credits. */
static inline uint32_t balance_credits(const struct core *core)
{
    return core->game.accounts.ledger.balance.paid + core->game.accounts.ledger.balance.service;
}

/* Returns the value of the audit counter `id`. */
static inline uint32_t balance_audit(const struct core *core, enum audit_id id)
{
    return core->game.accounts.audits.count[id];
}

/* Returns the ledger entry with the id `id`. The id must be one of the newest LEDGER_RING ids. */
static inline const struct ledger_entry *balance_entry(const struct output *out, uint32_t id)
{
    return &out->entries[id % LEDGER_RING];
}

/* Returns the number of entries of the kind `kind` among the newest LEDGER_RING ledger entries. */
static inline uint32_t balance_count(const struct output *out, enum ledger_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        count += out->entries[i].id != 0 && out->entries[i].kind == kind;
    }
    return count;
}

/* Returns 1 if the newest round record and its ledger entry have the same id, otherwise 0. */
static inline int entries_keep_record(const struct output *out)
{
    const struct round_record *record = newest_record(out);
    const struct ledger_entry *entry = balance_entry(out, record->id);
    return record->id != 0 && entry->id == record->id && &entry->round == record;
}

#endif
