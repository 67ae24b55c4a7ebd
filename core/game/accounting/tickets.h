/* tickets.h -- output of owed tickets to the dispenser, one at a time, each logged on disk first.
 *
 * A ticket has a value, so its debt and its payment must survive a power cut. The tickets of a
 * round are in the balance of its LEDGER_ROUND. The first ticket starts when that entry is on disk.
 * Each ticket has a LEDGER_TICKET that removes it from the balance, and its pulse starts when that
 * entry is on disk. The entry of the next ticket waits until the pulse has ended. After a power cut
 * the balance therefore contains every ticket whose LEDGER_TICKET is not on disk. An interrupted
 * ticket counts as dispensed, because the dispenser has no sensor: at most one ticket is lost, and
 * none is dispensed twice.
 *
 * Other outputs with the same risk:
 * - The credit of a round has a value too. A credit can be played only when it is on disk
 *   (ledger_committed_credits()), and is refunded at most once (round_standing.h).
 * - The coin meter has no value for a player. Each coin is counted once and never again after a
 *   restart; a power cut may lose its unfinished pulses.
 * - The coin slot opens only while an entry will soon be on disk (ledger_is_safe()).
 * - The START lamp, sounds and the forces in the poi have no value. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_TICKETS_H
#define KINGYO_CORE_GAME_ACCOUNTING_TICKETS_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"

struct accounts;
struct core_config;

/* Adds `count` tickets to the balance, up to BALANCE_TICKETS_MAX. The caller writes the entry that
 * contains the balance. In a recording of format 7 all pulses are requested at once. */
void tickets_owe(struct accounts *accounts, const struct core_config *config, uint32_t count);

/* Starts the next ticket, or its pulse, if the previous step is complete. Call once per tick in
 * every phase. */
void tickets_tick(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output);

#endif
