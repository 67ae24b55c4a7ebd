/* tickets.h -- outputs owed tickets to the dispenser, one at a time. Each ticket is logged on disk
 * first.
 *
 * A ticket has a value, so owed and dispensed tickets must survive a power cut. The balance in a
 * round's LEDGER_ROUND contains the round's tickets. The first ticket starts when that entry is on
 * disk. Each ticket has a LEDGER_TICKET that removes the ticket from the balance. The dispenser's
 * pulse starts when the LEDGER_TICKET is on disk. The entry of the next ticket waits until the
 * pulse has ended. After a power cut the balance therefore contains every ticket whose
 * LEDGER_TICKET is not on disk. An interrupted ticket counts as dispensed, because the dispenser
 * has no sensor. At most one ticket is lost, and no ticket is dispensed twice.
 *
 * Other outputs and power cuts:
 * - The credit of a round has a value too. A credit can be played only when it is on disk
 * (ledger_committed_credits()), and is refunded at most once (round_standing.h).
 * - The pulses of the coin meter have no value for a player. Each coin is counted once, and never
 * again after a restart. A power cut may lose unfinished pulses of the meter.
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
 * contains the balance. In a recording of format 7 all pulses are requested immediately instead. */
void tickets_owe(struct accounts *accounts, const struct core_config *config, uint32_t count);

/* Logs the next ticket, or starts its pulse, if the previous step is complete. Call once per tick
 * in every phase. */
void tickets_tick(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output);

#endif
