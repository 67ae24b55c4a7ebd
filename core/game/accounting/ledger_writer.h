/* ledger_writer.h -- the core's part of the ledger: writes entries, and tracks which entries are on
 * disk.
 *
 * The core keeps the balance after each entry until the store reports the entry as saved. The core
 * can therefore compute the balance that would remain after a power cut in this tick: the field
 * `committed`. Credits that were added after `committed` cannot be played yet. Credits that were
 * spent after `committed` cannot be played again. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_LEDGER_WRITER_H
#define KINGYO_CORE_GAME_ACCOUNTING_LEDGER_WRITER_H

#include <stdint.h>

#include "core/game/accounting/accounts.h"
#include "core/output.h"

struct persistent_state;
struct game_session;

/* Initializes `ledger` from the state that the store loaded at startup. */
void ledger_init(struct ledger *ledger, const struct ledger_start *start);

/* Reads from `input` which entries the store has saved. Call before any entry of the tick is
 * written. */
void ledger_tick(struct ledger *ledger, const struct input *input);

/* Returns 1 if the ledger's ring buffer has room for an entry of kind `kind` (enum ledger_kind),
 * otherwise 0. */
int ledger_has_room(const struct ledger *ledger, uint8_t kind);

/* Returns 1 if ledger_write() would write an entry of kind `kind`, otherwise 0. An entry is written
 * if the ledger's ring buffer has room. A kiosk without a store overwrites the oldest entry. */
int ledger_may_write(const struct ledger *ledger, uint8_t kind);

/* Writes an entry. The function sets id, boot, tick, day, minute and balance; the caller supplies
 * the other fields in `what`. Audits and leaderboards are updated immediately. Returns the id of
 * the entry. If the ledger's ring buffer has no room, counts the dropped entry and returns 0. */
uint32_t ledger_write(struct accounts *accounts, uint32_t tick, const struct ledger_entry *what,
                      struct output *output);

/* Returns 1 if the entry `id` is on disk, otherwise 0. */
int ledger_is_saved(const struct ledger *ledger, uint32_t id);

/* Returns 1 if every entry is on disk, or if the kiosk has no store; otherwise 0. */
int ledger_is_flushed(const struct ledger *ledger);

/* Returns 1 if a payment in this tick will soon be on disk, because the store is healthy, responds,
 * and has room; otherwise 0. */
int ledger_is_safe(const struct ledger *ledger);

/* Returns 1 if the current balance differs from the balance on disk and no waiting entry contains
 * it. The difference arises when a store becomes available after the start, or had no room when the
 * balance changed. */
int ledger_needs_sync(const struct ledger *ledger);

/* Numbers of credits that are on disk and not spent. Only these credits can be played. */
struct ledger_credits {
    uint32_t paid, service;
};
struct ledger_credits ledger_committed_credits(const struct ledger *ledger);

uint64_t ledger_balance_hash(uint64_t hash, const struct balance *balance);
uint64_t ledger_start_hash(uint64_t hash, const struct ledger_start *start);
uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger);

/* ---- Open rounds ----------------------------------------------------------------------------- */

/* Returns the state of the open round after `entry`. For a LEDGER_STAND, the result is the content
 * of `entry`. For another entry of the same round, the result is `before`. Otherwise all fields of
 * the result are 0. */
struct ledger_stand round_standing_after(struct ledger_stand before,
                                         const struct ledger_entry *entry);

/* Returns 1 if every packed field of `stand` is in its range, otherwise 0. */
int round_standing_is_good(const struct ledger_stand *stand);

/* Returns `hash` continued over `stand`. If all fields of `stand` are 0, `hash` is returned
 * unchanged. */
uint64_t round_standing_hash(uint64_t hash, const struct ledger_stand *stand);

/* ---- Validation of stored records ------------------------------------------------------------ */

/* Validates stored records: each field must be in the range that this core writes.
 *
 * A checksum proves only that a record is unchanged, not that Kingyo wrote the record. Out-of-
 * range values would index beyond tables or wrap counters. Each reader (database, tail, backup,
 * replay) and core_init() therefore reject out-of-range values. */

/* Returns 1 if every field of `entry` is in its range, otherwise 0. */
int ledger_entry_is_valid(const struct ledger_entry *entry);

/* Returns 1 if the start of the ledger, the balance and the leaderboards in `memory` are in their
 * ranges, otherwise 0. Settings are not checked, because settings_sanitize() corrects invalid
 * settings. Any value of an audit counter is allowed. */
int ledger_state_is_valid(const struct persistent_state *memory);

/* Returns 1 if every field of the state carried over from the previous session is in its range,
 * otherwise 0. */
int ledger_session_is_valid(const struct game_session *session);

#endif
