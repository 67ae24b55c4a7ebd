/* ledger_range.h -- validates stored records: each field must be in the range that this core
 * writes.
 *
 * A checksum proves only that a record is unchanged, not that Kingyo wrote the record. Out-of-range
 * values would index beyond tables or wrap counters. Each reader (database, tail, backup, replay)
 * and core_init() therefore reject out-of-range values. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_LEDGER_RANGE_H
#define KINGYO_CORE_GAME_ACCOUNTING_LEDGER_RANGE_H

#include "core/game/session.h"
#include "core/persistent_state.h"
#include "core/ledger.h"

/* Returns 1 if every field of `entry` is in its range, otherwise 0. */
int ledger_entry_is_valid(const struct ledger_entry *entry);

/* Returns 1 if the ledger start, the balance and the leaderboards in `memory` are in their ranges,
 * otherwise 0. Settings are not checked, because settings_sanitize() corrects invalid settings. Any
 * value of an audit counter is allowed. */
int ledger_state_is_valid(const struct persistent_state *memory);

/* Returns 1 if every field of the state carried over from the previous session is in its range,
 * otherwise 0. */
int ledger_session_is_valid(const struct game_session *session);

#endif
