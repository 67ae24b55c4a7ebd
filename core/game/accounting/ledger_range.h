/* ledger_range.h -- validation of stored records: every field must be in the range that this core
 * writes.
 *
 * A checksum proves only that a record is unchanged, not that Kingyo wrote it. Out-of-range values
 * would index beyond tables or wrap counters, so each reader (database, tail, backup, replay) and
 * core_init() reject them. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_LEDGER_RANGE_H
#define KINGYO_CORE_GAME_ACCOUNTING_LEDGER_RANGE_H

#include "core/game/session.h"
#include "core/persistent_state.h"
#include "core/ledger.h"

/* Returns 1 if every field of the entry is in its range, else 0. */
int ledger_entry_is_valid(const struct ledger_entry *entry);

/* Returns 1 if the ledger start, the balance and the leaderboard are in their ranges, else 0.
 * Settings are corrected by settings_sanitize(), and any audit count is allowed. */
int ledger_state_is_valid(const struct persistent_state *memory);

/* Returns 1 if the state carried over from the previous session is in its ranges, else 0. */
int ledger_session_is_valid(const struct game_session *session);

#endif
