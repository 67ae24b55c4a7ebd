/* name.h -- whoever is ranked writes a name, one player after the other, the best first.
 *
 * A player's own hand points where it is and takes by a dip. LEFT and RIGHT go from key to key, and
 * run while held; OK and START take. A player who does nothing for a while, or takes too long,
 * keeps what stands there; what stands there is written to the ledger. A name that does not belong
 * on the wall (name_filter.h) is asked for once more, then there is none.
 *
 * It is asked for only where the operator wants it (SET_NAMES) and there is a store to keep it. */
#ifndef KINGYO_CORE_GAME_NAME_H
#define KINGYO_CORE_GAME_NAME_H

#include <stdint.h>

#include "core/game/name_board.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define NAME_IDLE_TICKS (20u * CORE_TICK_HZ) /* Nobody points or takes any more. */
#define NAME_TICKS_MAX (60u * CORE_TICK_HZ)  /* A player's, with friends who help. */
#define NAME_SEEN_TICKS (CORE_TICK_HZ / 2u)  /* A press before that was meant for the result. */
#define NAME_RUN_TICKS (CORE_TICK_HZ / 2u)   /* A button held so long runs on, ... */
#define NAME_STEP_TICKS (CORE_TICK_HZ / 10u) /* ... a key each so many ticks. */
#define NAME_REFUSALS_MAX 1u                 /* Then there is no name. */

struct name {
    uint32_t round_id;  /* Of the last round that somebody was ranked with; 0: none since. */
    uint8_t ranked;     /* Who was, a bit a seat, ... */
    uint8_t waits;      /* ... and of those, who has not been asked. */
    uint8_t seat;       /* Who writes. */
    uint8_t alphabet;   /* enum name_alphabet */
    uint8_t key;        /* That is pointed at: a cell, or enum name_key. */
    uint8_t points;     /* The one under the hand, from 1; 0: none. */
    uint8_t upright, has_hand, presses;
    uint8_t refusals;   /* Of this player's names. */
    uint8_t letter_count;
    uint16_t letter[NAME_LETTERS_MAX];
    uint32_t seat_tick; /* When this player was asked, ... */
    uint32_t act_tick;  /* ... and did something last. */
    uint32_t held_ticks; /* How long LEFT or RIGHT is held. */
    float x, y;         /* The hand, on the canvas, ... */
    float rest_x, rest_y; /* ... and where it last moved on from. */
};

struct core;
struct game;

/* A round is over and its entry is `round_id`, or 0 where it has none: who is ranked? */
void name_note_round(struct core *core, uint32_t round_id);

/* Asks whoever is ranked and was not asked yet; returns whether there is anybody. */
int name_begin(struct core *core, struct output *output);
void name_tick(struct core *core, const struct input *input, struct output *output);

/* It is cut short: what stands there is kept. */
void name_keep(struct core *core, struct output *output);

/* Until the one who writes is asked no longer. */
float name_seconds_left(const struct name *name, uint32_t tick);

/* What there is to see of it. */
void name_show(const struct core *core, struct scene_name *out);

uint64_t name_hash(uint64_t hash, const struct name *name);

#endif
