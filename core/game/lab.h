/* lab.h -- the growth lab: a life to scrub through, and the graph that shapes it to edit.
 *
 * A hand over the water points at what is on the canvas (lab_layout.h), and presses it while it is
 * down; a mouse does the same with its button. LEFT and RIGHT lead through life while held, START
 * plays it (and ends the lab when held), OK shows the next species. There is no score. */
#ifndef KINGYO_CORE_GAME_LAB_H
#define KINGYO_CORE_GAME_LAB_H

#include "core/game/lab_book.h"
#include "core/game/lab_layout.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define LAB_IDLE_TICKS (60u * CORE_TICK_HZ)  /* Nobody moves any more: back to attract. */
#define LAB_SWING_TICKS (180u * CORE_TICK_HZ) /* Nor is a poi that only swings on its cord
                                                 somebody: it never presses anything. */
#define LAB_LIFE_TICKS (14u * CORE_TICK_HZ)  /* A life takes so long to play, ... */
#define LAB_REST_TICKS (5u * CORE_TICK_HZ / 2u) /* ... and stands still at its end. */
#define LAB_END_TICKS (3u * CORE_TICK_HZ / 2u) /* START held so long leaves. */
#define LAB_GRAB 24.0f         /* A knot is taken within so much of it, on the canvas. */

/* What the hand has hold of, from the press to the release. */
enum lab_hold {
    HOLD_NOTHING = 0,
    HOLD_AGE,    /* On the line of life, */
    HOLD_CHART,  /* along the growth curve, */
    HOLD_PLOT,   /* or across the graph. */
    HOLD_WEIGHT, /* A knot of the key in `layer`. */
    HOLD_SIZE,   /* A knot of the scale. */
    HOLD_BUTTON,
    HOLD_LEAVE,  /* The way out: taken when the hand comes up. */
};

#define LAB_LAYER_SIZE MORPH_KEY_MAX /* Of `layer`: the scale; below it, a key. */

struct lab {
    uint8_t species;   /* In the book's order. */
    uint8_t layer;     /* Which curve the hand is at. */
    uint8_t playing, compare, path;
    uint8_t has_hand, presses;
    uint8_t hand;      /* Which player's it is, or was last. */
    uint8_t points;    /* enum lab_part that is under the hand. */
    uint8_t holds;     /* enum lab_hold */
    uint8_t held_knot;
    uint8_t upright;   /* As the last input said, ... */
    uint8_t edit_refused; /* ... and that the store keeps nothing. */
    uint8_t has_edit[SPECIES_MAX]; /* The stall keeps an edit of that species. */
    uint32_t stir_tick, act_tick;  /* When a hand last moved, and last pressed something. */
    uint32_t rest_ticks;           /* At the end of a life that plays. */
    uint32_t start_ticks;          /* START has been held so long. */
    uint32_t save_id, saved_id;    /* The newest given to the store, and known to be kept; ... */
    uint32_t asked_id;             /* ... that of what is on the table; 0: none was asked for. */
    float x, y;                    /* The hand, on the canvas; ... */
    float stir_x, stir_y;          /* ... and where it last moved on from. */
    float progress;
    struct lab_edit edit;          /* On the table. */
    struct lab_edit edits[SPECIES_MAX];
};

struct core;
struct core_config;

void lab_init(struct lab *lab, const struct core_config *config);

/* Opens the lab: the species that was last looked at, as a larva, playing. */
void lab_begin(struct core *core, struct output *output);
void lab_tick(struct core *core, const struct input *input, struct output *output);

/* What there is to see of it. */
void lab_show(const struct core *core, struct scene_lab *out);

uint64_t lab_hash_quick(uint64_t hash, const struct lab *lab); /* Without what is kept. */
uint64_t lab_hash(uint64_t hash, const struct lab *lab);       /* What is kept. */

#endif
