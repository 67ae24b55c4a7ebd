/* purse.h -- what a stall on a stand owes and has given back, and what it wrote down, as its tests
 * ask for it. */
#ifndef KINGYO_TESTS_PURSE_H
#define KINGYO_TESTS_PURSE_H

#include "core/core.h"

static inline uint32_t purse_credits(const struct core *core)
{
    return core->game.ledger.purse.paid + core->game.ledger.purse.service;
}

static inline uint32_t purse_audit(const struct core *core, enum audit_id id)
{
    return core->game.audits.count[id];
}

/* Of what was written the entry `id`, one of the newest LEDGER_RING. */
static inline const struct ledger_entry *purse_entry(const struct output *out, uint32_t id)
{
    return &out->entries[id % LEDGER_RING];
}

/* How many of the newest LEDGER_RING entries are of this kind. */
static inline uint32_t purse_count(const struct output *out, enum ledger_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        count += out->entries[i].id != 0 && out->entries[i].kind == kind;
    }
    return count;
}

/* Whether the newest record is what the entry with its id, a round's, has on disk. */
static inline int purse_keeps_record(const struct output *out)
{
    const struct round_record *record = &out->record;
    const struct ledger_entry *entry = purse_entry(out, record->id);
    return record->id != 0 && entry->id == record->id && entry->kind == LEDGER_ROUND &&
           entry->round.seed == record->seed && entry->round.end_tick == record->end_tick &&
           entry->round.mode == record->mode && entry->round.caught == record->caught;
}

#endif
