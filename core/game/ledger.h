/* ledger.h -- the core's end of the ledger: writes entries, and knows how far they are on disk. */
#ifndef KINGYO_CORE_GAME_LEDGER_H
#define KINGYO_CORE_GAME_LEDGER_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"

struct ledger {
    uint32_t last_id;  /* The newest entry's, ... */
    uint32_t saved_id; /* ... and the newest that is on disk. */
    uint32_t boot;
    uint32_t unkept;   /* Entries that found no room: none of them was money. */
    uint16_t day, minute;
    uint8_t is_well;   /* As the last input said. */
    struct purse purse;
};

struct core;
struct core_config;

void ledger_init(struct ledger *ledger, const struct core_config *config);

/* What the store says, before anything of the tick is written. */
void ledger_tick(struct core *core, const struct input *input);

/* Whether there is room for an entry more. */
int ledger_has_room(const struct ledger *ledger);

/* Writes an entry: id, boot, tick, day, minute and purse are filled in, the rest is the caller's.
 * Audits and ranking note it at once. Returns its id, or 0 when there was no room, which is
 * counted. */
uint32_t ledger_write(struct core *core, const struct ledger_entry *what, struct output *output);

/* Whether the entry is on disk. */
int ledger_is_saved(const struct ledger *ledger, uint32_t id);

uint64_t purse_hash(uint64_t hash, const struct purse *purse);
uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger);

#endif
