/* adjust.h -- settings that are turned while the kiosk runs: they count at once, and are told to
 * the ledger as soon as they rest.
 *
 * Whoever turns one (a page of the operator's menu, calibration) calls adjust_set() and is done:
 * what the ledger does not know yet is told by a later tick, so that neither a full ring nor a menu
 * that is closed in haste loses a setting. A knob that is turned through twenty values is one
 * entry. */
#ifndef KINGYO_CORE_GAME_ADJUST_H
#define KINGYO_CORE_GAME_ADJUST_H

#include <stdint.h>

#include "core/output.h"
#include "core/settings.h"

#define ADJUST_REST_TICKS (CORE_TICK_HZ / 2u) /* Nobody turns on after so long. */

struct adjust {
    struct settings told; /* As the ledger knows them. */
    uint32_t turn_tick;   /* When one was turned last. */
    uint32_t entry_id;    /* The newest entry that told of one; 0: none in this run. */
    uint32_t pin_wrong;   /* PINs in a row that were none, .. 255, and ... */
    uint32_t pin_tick;    /* ... when the last was typed, or the kiosk began with some: here, since
                             a closed menu forgets. */
};

struct core;
struct core_config;

/* What `config` remembers, mended, is what the ledger knows. */
void adjust_init(struct adjust *adjust, const struct core_config *config);

/* The highest value that this stall can have: no more fish than there is room for. */
int32_t adjust_max(const struct core *core, uint32_t id);

/* From now on it has this value, which setting_allows() and adjust_max() must. Fish and players are
 * those of the next attract. */
void adjust_set(struct core *core, uint32_t id, int32_t value);

/* So many steps up or down, no further than to the end of its range; from there to the other end.
 * Returns 1 where it came to an end. */
int adjust_turn(struct core *core, uint32_t id, int is_down, uint32_t step_count);

/* All at their standards, and told in one entry with the purse emptied. 0: there is no room in the
 * ledger just now, and nothing was done. */
int adjust_factory(struct core *core, struct output *output);

/* Tells what rests. Once a tick, whatever the phase. */
void adjust_tick(struct core *core, struct output *output);

/* Whether all that was turned is on disk. */
int adjust_is_saved(const struct core *core);

/* `rules_7` as in struct core_config: only then the PIN counts, as in recordings of format 7. */
uint64_t adjust_hash(uint64_t hash, const struct adjust *adjust, int rules_7);

#endif
