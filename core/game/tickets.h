/* tickets.h -- owed tickets, given to the dispenser one at a time and only from the disk.
 *
 * A ticket has a value, so its debt and its payment must both outlive a power cut. The tickets of a
 * round are in the purse of its LEDGER_ROUND. The first is begun once that entry is on disk. Each
 * ticket has a LEDGER_TICKET that takes it from the purse; its pulse starts once that entry is on
 * disk. The entry of the next ticket waits until the pulse has ended. After a power cut the purse
 * therefore has every ticket whose LEDGER_TICKET is not on disk. The one that was cut counts as
 * dispensed, because the dispenser has no sensor: at most one is missing and none comes twice.
 *
 * The other outputs were checked for the same fault:
 * - The credit of a round is as valuable as a ticket. A credit can be played only once it is on
 *   disk (ledger_sure()), and comes back at most once (stand.h).
 * - The coin meter gives nothing away. It counts what fell into the box, each coin once and never
 *   again after a restart; a power cut may lose its pulses that have not ended.
 * - The coin lockout opens only while an entry will soon be on disk (ledger_is_safe()).
 * - The START lamp, sounds and the forces in the poi have no value. */
#ifndef KINGYO_CORE_GAME_TICKETS_H
#define KINGYO_CORE_GAME_TICKETS_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"

struct core;

/* Adds `count` tickets to the purse, up to PURSE_TICKETS_MAX. The caller writes the entry that
 * carries the purse. In a recording of format 7 the dispenser gets all pulses at once. */
void tickets_owe(struct core *core, uint32_t count);

/* Begins the next ticket, or its pulse, if its turn has come. Once a tick, in every phase. */
void tickets_tick(struct core *core, const struct input *input, struct output *output);

#endif
