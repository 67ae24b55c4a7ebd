/* hints.h -- what the stall calls to a player: one thing at a time, the next one to learn.
 *
 * With several at the tank it looks at the first who has a poi in hand: one keeper, one voice. That
 * a hand is waited for it says of any.
 * A rule looks at what the player does and says what would help; a hint is shown until it is done,
 * and no hint gives way within HINT_TICKS_MIN unless it was followed or something urgent is to be
 * said. */
#ifndef KINGYO_CORE_GAME_HINTS_H
#define KINGYO_CORE_GAME_HINTS_H

#include <stdint.h>

#define HINT_TICKS_MIN 180u /* 1.5 s: the time that a short line takes to read. */

struct hints {
    uint8_t pupil;        /* Whom it looks at, < POI_MAX. */
    uint8_t shown;        /* enum scene_hint */
    uint32_t shown_tick;  /* Since when. */
    uint32_t learned;     /* Bit (1 << enum scene_hint): done by this player. */
    uint32_t haste_tick;  /* When haste last tore the paper; 0 never. */
    uint32_t haste_cells; /* Torn in haste since the last look. */
    uint32_t paper_cells; /* Of the pupil's poi in the last tick. */
    uint32_t dips_before; /* Of that poi, when it last caught something or was new. */
    uint32_t caught;      /* Of the pupil at the last look. */
    float moved_m;        /* Way of the poi in this round, up to what counts as moved. */
};

struct core;

/* A new player: nothing learned yet. */
void hints_init(struct hints *hints);

/* One look at the state, each tick; writes only `hints`. */
void hints_tick(struct hints *hints, const struct core *core);

uint64_t hints_hash(uint64_t hash, const struct hints *hints);

#endif
