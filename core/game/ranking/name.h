/* name.h -- name entry: each ranked player enters a name, one after the other, the best first.
 *
 * The player's own poi points at a key, and a dip presses it. LEFT and RIGHT move from key to key,
 * and repeat while held; OK and START press the key. After a timeout the letters entered so far are
 * the name. The name is written to the ledger. An offensive name (name_filter.h) is rejected once
 * and must be entered again; a second rejection leaves the score without a name.
 *
 * Names are requested only if the operator enabled them (SET_NAMES) and a store exists. */
#ifndef KINGYO_CORE_GAME_RANKING_NAME_H
#define KINGYO_CORE_GAME_RANKING_NAME_H

#include <stdint.h>

#include "core/game/ranking/name_keyboard.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define NAME_IDLE_TICKS (20u * CORE_TICK_HZ) /* Timeout without pointing or pressing. */
/* Longest time for one player, including help from friends. */
#define NAME_TICKS_MAX (60u * CORE_TICK_HZ)
/* Delay before a press counts, because an earlier press was meant for the result. */
#define NAME_SEEN_TICKS (CORE_TICK_HZ / 2u)
#define NAME_RUN_TICKS (CORE_TICK_HZ / 2u)   /* Time after which a held button repeats. */
#define NAME_STEP_TICKS (CORE_TICK_HZ / 10u) /* Ticks per key while a button repeats. */
#define NAME_REFUSALS_MAX 1u                 /* Number of rejections that permit another try. */

struct name {
    uint32_t round_id; /* Round of the last ranked player; 0: none since. */
    uint8_t ranked;    /* Bit mask of the ranked slots. */
    uint8_t waits;     /* Bit mask of the ranked slots that still need a name. */
    uint8_t seat;      /* Slot of the current player. */
    uint8_t alphabet;  /* enum name_alphabet */
    uint8_t key;       /* Highlighted key: a cell, or enum name_key. */
    uint8_t points;    /* Key under the pointer, from 1; 0: none. */
    uint8_t upright, has_hand, presses;
    uint8_t refusals; /* Rejected names of this player. */
    uint8_t letter_count;
    uint16_t letter[NAME_LETTERS_MAX];
    uint32_t seat_tick;   /* Tick at which this player's entry began. */
    uint32_t act_tick;    /* Tick of this player's last activity. */
    uint32_t held_ticks;  /* Ticks for which LEFT or RIGHT has been held. */
    float x, y;           /* Pointer position on the canvas. */
    float rest_x, rest_y; /* Pointer position at the last motion. */
};

struct accounts;
struct world;
struct settings;
struct game;

/* Determines the ranked players of a finished round. `round_id` is its ledger id, or 0 without an
 * entry. */
void name_note_round(struct game *game, const struct settings *settings, uint32_t round_id);

/* Starts the name entry of the next ranked player. Returns 1, or 0 if no player is left. */
int name_begin(struct game *game, struct output *output);
void name_tick(struct game *game, const struct world *world, const struct input *input,
               struct output *output);

/* Ends the name entry early and logs the letters entered so far. */
void name_keep(struct accounts *accounts, const struct name *name, uint32_t tick,
               struct output *output);

/* Returns the seconds until the current entry times out. */
float name_seconds_left(const struct name *name, uint32_t tick);

/* Fills `out` with the visible state of the name entry. */
void name_show(const struct game *game, struct scene_name *out);

uint64_t name_hash(uint64_t hash, const struct name *name);

#endif
