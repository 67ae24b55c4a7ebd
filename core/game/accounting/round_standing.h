/* round_standing.h -- the logged state of an open round whose credit is not refundable any more.
 *
 * No credit is refunded after two thirds of a round, or in a round played with a refunded credit:
 * the round counts. A power cut must not remove its score or its tickets. Each change of them is
 * therefore logged while the round runs (LEDGER_STAND), and the next start writes the missing
 * LEDGER_ROUND. Changes within the time that the store needs for an entry may be missing from that
 * round. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_ROUND_STANDING_H
#define KINGYO_CORE_GAME_ACCOUNTING_ROUND_STANDING_H

#include "core/ledger.h"
#include "core/output.h"

struct game;
struct accounts;
struct core_config;

/* Share of the round after which its credit is not refundable. */
#define STAND_SHARE_NUMERATOR 2u
#define STAND_SHARE_DENOMINATOR 3u

/* Returns 1 if the credit of the running round is not refundable. Recordings of format 7 refund
 * every credit. */
int stand_is_spent(const struct game *game, const struct core_config *config);

/* Logs the state of the round if it changed, the previous entry is on disk, and the ledger has
 * room. Call once per tick of the round. */
void stand_tick(struct game *game, const struct core_config *config, struct output *output);

/* Finishes a round that was open at startup and counts: writes its LEDGER_ROUND from
 * config->persistent.ledger.stand and closes the balance. Returns 1, or 0 without an entry if no
 * player had joined that round. */
int stand_finish(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct output *output);

/* Returns the state after `entry`: the content of a LEDGER_STAND; `before` for another entry of the
 * same open round; else all zero. */
struct ledger_stand stand_after(struct ledger_stand before, const struct ledger_entry *entry);

/* Returns 1 if every packed field is in its range, else 0. */
int stand_is_good(const struct ledger_stand *stand);

/* Returns `hash` continued over `stand`; `hash` unchanged if `stand` is all zero. */
uint64_t stand_hash(uint64_t hash, const struct ledger_stand *stand);

#endif
