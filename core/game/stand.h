/* stand.h -- how an open round stands once its credit can no longer come back.
 *
 * After two thirds of a round, and in each round that is played on a credit which came back before,
 * no credit is refunded: the round counts. A power cut must then take neither its score nor its
 * tickets, so each change of them is written to the ledger while the round runs (LEDGER_STAND), and
 * the next start writes the LEDGER_ROUND that the power cut prevented. Changes within the time that
 * the store needs for an entry may be missing from that round. */
#ifndef KINGYO_CORE_GAME_STAND_H
#define KINGYO_CORE_GAME_STAND_H

#include "core/ledger.h"
#include "core/output.h"

struct core;

/* Share of the round after which no credit comes back. */
#define STAND_SHARE_NUMERATOR 2u
#define STAND_SHARE_DENOMINATOR 3u

/* Returns whether the credit of what runs now cannot come back. Recordings of format 7 refund every
 * credit. */
int stand_is_spent(const struct core *core);

/* Writes how the round stands if that changed, the entry before is on disk, and the ledger has
 * room. Once a tick of the round. */
void stand_tick(struct core *core, struct output *output);

/* At a start whose purse has an open round that counts: writes its LEDGER_ROUND from
 * core->config.memory.ledger.stand and closes the purse. Returns 0, and writes nothing, if nobody
 * had played in that round. */
int stand_finish(struct core *core, struct output *output);

/* Returns the stand after `entry`: its own for LEDGER_STAND; `before` for another entry of the same
 * open round; else zero. */
struct ledger_stand stand_after(struct ledger_stand before, const struct ledger_entry *entry);

/* Returns 1 if every packed field is in its range, else 0. */
int stand_is_good(const struct ledger_stand *stand);

/* Zero leaves `hash` as it was. */
uint64_t stand_hash(uint64_t hash, const struct ledger_stand *stand);

#endif
