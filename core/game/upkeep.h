/* upkeep.h -- what the machine says of itself: that it began, what that ended, and how it fares.
 *
 * The first entry of each start is LEDGER_BOOT. A round that was open then was cut off by a crash
 * or the plug: its credit comes back. Every two minutes, and whenever the operator opens the menu,
 * a LEDGER_HEALTH tells how long the machine has been up and what went wrong meanwhile. */
#ifndef KINGYO_CORE_GAME_UPKEEP_H
#define KINGYO_CORE_GAME_UPKEEP_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"

#define UPKEEP_TICKS (120u * CORE_TICK_HZ) /* What a pulled plug takes from the books at most. */

struct upkeep {
    uint8_t is_told;       /* This start's LEDGER_BOOT is written. */
    uint32_t told_tick;    /* When a LEDGER_HEALTH was written last, ... */
    uint32_t dropped_ticks, device_faults; /* ... and what it found in the input. */
    uint32_t told_shakes;
    uint32_t away_ticks[POI_MAX]; /* How long a seat that plays has been without its controller. */
    uint32_t loss_tick[POI_MAX];  /* When a seat last lost its controller in a round; 0: never. */
};

/* A controller that is away so long in a round was lost; a shorter gap is a glitch. */
#define UPKEEP_LOSS_TICKS CORE_TICK_HZ
/* A loss within this time of the same seat's last one is a repeated loss: LEDGER_LOSS. */
#define UPKEEP_LOSS_AGAIN_TICKS (600u * CORE_TICK_HZ)

struct core;

/* Counts repeated losses of each seat's controller. Once a tick of the round, after
 * pause_tick(). */
void upkeep_note_losses(struct core *core, struct output *output);

/* Once a tick, before anything else is written in it. */
void upkeep_tick(struct core *core, const struct input *input, struct output *output);

/* Tells now. */
void upkeep_tell(struct core *core, const struct input *input, struct output *output);

/* What would be told now, as the entry that comes next, for an orderly end after the last tick: the
 * core is left as a recording of it knows it. 0: there is no store to keep it. */
int upkeep_last_word(const struct core *core, const struct input *input, struct ledger_entry *out);

uint64_t upkeep_hash(uint64_t hash, const struct upkeep *upkeep);

#endif
