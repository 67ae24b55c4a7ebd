/* purse.h -- what a stall on a stand owes and has given back, as its tests ask for it. */
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

#endif
