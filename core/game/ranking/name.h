/* name.h -- name entry: each ranked player enters a name. The players take turns, beginning with
 * the player with the best place.
 *
 * The player's own poi points at a key of the on-screen keyboard, and a dip presses the key. LEFT
 * and RIGHT move from key to key, and repeat while they are held. OK and START press the
 * highlighted key. After a timeout the letters entered so far become the name. The name is written
 * to the ledger. An offensive name (name_filter.h) is rejected once and must be replaced. After a
 * second rejection the score has no name.
 *
 * Names are requested only if the operator enabled them (SET_NAMES) and a store exists. */
#ifndef KINGYO_CORE_GAME_RANKING_NAME_H
#define KINGYO_CORE_GAME_RANKING_NAME_H

#include <stdint.h>

#include "core/game/ranking/name_keyboard.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

/* Time without pointing or pressing after which the name entry ends. */
#define NAME_IDLE_TICKS (20u * CORE_TICK_HZ)
/* Longest time of one player's name entry, including help from friends. */
#define NAME_TICKS_MAX (60u * CORE_TICK_HZ)
/* Delay before a press counts, because an earlier press was meant for the result screen. */
#define NAME_SEEN_TICKS (CORE_TICK_HZ / 2u)
/* Time after which a held LEFT or RIGHT button starts to repeat. */
#define NAME_RUN_TICKS (CORE_TICK_HZ / 2u)
/* Ticks between two steps while LEFT or RIGHT repeats. */
#define NAME_STEP_TICKS (CORE_TICK_HZ / 10u)
/* Number of rejected names after which the player may still try again. */
#define NAME_REFUSALS_MAX 1u

struct name {
    uint32_t round_id; /* Ledger id of the last round with a ranked player; 0 means none. */
    uint8_t ranked;    /* Bit mask of the ranked slots of that round. */
    uint8_t waits;     /* Bit mask of the ranked slots that still need a name. */
    uint8_t seat;      /* Slot of the player who enters a name. */
    uint8_t alphabet;  /* Displayed alphabet (enum name_alphabet). */
    uint8_t key;       /* Highlighted key: the index of a letter's cell, or an enum name_key. */
    uint8_t points;    /* Key under the pointer, from 1; 0 means none. */
    uint8_t upright, has_hand, presses;
    uint8_t refusals; /* Number of names of the current player that were rejected. */
    uint8_t letter_count;
    uint16_t letter[NAME_LETTERS_MAX];
    uint32_t seat_tick;   /* Tick at which the current player's name entry began. */
    uint32_t act_tick;    /* Tick of the current player's last activity. */
    uint32_t held_ticks;  /* Ticks for which LEFT or RIGHT has been held. */
    float x, y;           /* Pointer position on the canvas. */
    float rest_x, rest_y; /* Pointer position at its last motion. */
};

struct accounts;
struct world;
struct settings;
struct game;

/* Determines the ranked players of a finished round. `round_id` is the ledger id of the round, or 0
 * if the round has no ledger entry. */
void name_note_round(struct game *game, const struct settings *settings, uint32_t round_id);

/* Starts the name entry of the next ranked player. Returns 1, or 0 if no player still needs a
 * name. */
int name_begin(struct game *game, struct output *output);
void name_tick(struct game *game, const struct world *world, const struct input *input,
               struct output *output);

/* Ends the name entry early and logs the letters entered so far as the name. */
void name_keep(struct accounts *accounts, const struct name *name, uint32_t tick,
               struct output *output);

/* Returns the seconds until the current player's name entry times out. */
float name_seconds_left(const struct name *name, uint32_t tick);

/* Fills `out` with the visible state of the name entry. */
void name_show(const struct game *game, struct scene_name *out);

uint64_t name_hash(uint64_t hash, const struct name *name);

#endif
