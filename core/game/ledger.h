/* ledger.h -- the core's end of the ledger: writes entries, and knows how far they are on disk.
 *
 * Until the store says that an entry is on disk the core keeps the purse that it carries, so that
 * it can say what a power cut in this very tick would leave: the purse that is kept. What came
 * since is on its way; what was spent since is spent. */
#ifndef KINGYO_CORE_GAME_LEDGER_H
#define KINGYO_CORE_GAME_LEDGER_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"

#define LEDGER_WAIT_TICKS_MAX (2u * CORE_TICK_HZ) /* A card that syncs takes a tenth of that; one
                                                     that hangs says nothing at all. */

struct ledger {
    uint32_t last_id;  /* The newest entry's, ... */
    uint32_t saved_id; /* ... and the newest that is on disk. */
    uint32_t boot;
    uint32_t unkept;   /* Entries that found no room: none of them was money. */
    uint32_t wait_ticks; /* How long some have waited without one of them being saved. */
    uint16_t day, minute;
    uint8_t is_well;   /* As the last input said. */
    struct purse purse; /* As it is, ... */
    struct purse kept;  /* ... as it is on disk, ... */
    struct purse after[LEDGER_RING]; /* ... and after each entry that is not; n's at n %
                                        LEDGER_RING. */
};

struct core;
struct core_config;

void ledger_init(struct ledger *ledger, const struct core_config *config);

/* What the store says, before anything of the tick is written. */
void ledger_tick(struct core *core, const struct input *input);

/* Whether there is room for an entry of this kind (enum ledger_kind). */
int ledger_has_room(const struct ledger *ledger, uint8_t kind);

/* Whether it would be written: there is room, or a stall that keeps nothing makes some. */
int ledger_may_write(const struct ledger *ledger, uint8_t kind);

/* Writes an entry: id, boot, tick, day, minute and purse are filled in, the rest is the caller's.
 * Audits and ranking note it at once. Returns its id, or 0 when there was no room, which is
 * counted. */
uint32_t ledger_write(struct core *core, const struct ledger_entry *what, struct output *output);

/* Whether the entry is on disk. */
int ledger_is_saved(const struct ledger *ledger, uint32_t id);

/* Whether all that was written is on disk, or will never be because there is no store. */
int ledger_is_settled(const struct ledger *ledger);

/* Whether what is paid now will soon be on disk: the store is well, answers, and has room. */
int ledger_is_safe(const struct ledger *ledger);

/* Whether the purse is another than the one on disk and no entry that carries it is on its way: a
 * store was found at last, or had no room when it changed. */
int ledger_owes_purse(const struct ledger *ledger);

/* The credits that are on disk and not spent: these, and no others, may be played. */
struct ledger_credits {
    uint32_t paid, service;
};
struct ledger_credits ledger_sure(const struct ledger *ledger);

uint64_t purse_hash(uint64_t hash, const struct purse *purse);
uint64_t ledger_start_hash(uint64_t hash, const struct ledger_start *start);
uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger);

#endif
