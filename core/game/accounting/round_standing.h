/* round_standing.h -- logs the state of an open round whose credit is not refundable any more.
 *
 * The credit is not refundable after two thirds of a round, or if the round was paid with a
 * refunded credit. The round then counts, and a power cut must not remove its score or its tickets.
 * Each change of the score or the tickets is therefore logged while the round runs (LEDGER_STAND).
 * After a power cut, the next start writes the missing LEDGER_ROUND. Changes are missing from that
 * LEDGER_ROUND if the store was still writing an earlier entry when they occurred. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_ROUND_STANDING_H
#define KINGYO_CORE_GAME_ACCOUNTING_ROUND_STANDING_H

#include "core/ledger.h"
#include "core/output.h"

struct game;
struct accounts;
struct core_config;

/* Fraction of the round after which its credit is not refundable. */
#define STAND_SHARE_NUMERATOR 2u
#define STAND_SHARE_DENOMINATOR 3u

/* Returns 1 if the credit of the running round is not refundable, otherwise 0. In recordings of
 * format 7 every credit is refundable. */
int stand_is_spent(const struct game *game, const struct core_config *config);

/* Logs the state of the round if it changed, the previous entry is on disk, and the ledger has
 * room. Call once per tick of the round. */
void stand_tick(struct game *game, const struct core_config *config, struct output *output);

/* Finishes a round that was open at startup and counts. Writes the round's LEDGER_ROUND from
 * config->persistent.ledger.stand and closes the balance. Returns 1, or 0 without an entry if no
 * player had joined the round. */
int stand_finish(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct output *output);

/* Returns the state of the open round after `entry`. For a LEDGER_STAND, the result is the content
 * of `entry`. For another entry of the same round, the result is `before`. Otherwise all fields of
 * the result are 0. */
struct ledger_stand stand_after(struct ledger_stand before, const struct ledger_entry *entry);

/* Returns 1 if every packed field of `stand` is in its range, otherwise 0. */
int stand_is_good(const struct ledger_stand *stand);

/* Returns `hash` continued over `stand`. If all fields of `stand` are 0, `hash` is returned
 * unchanged. */
uint64_t stand_hash(uint64_t hash, const struct ledger_stand *stand);

#endif
