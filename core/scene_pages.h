/* scene_pages.h -- the pages that are shown over the tank between two rounds: the growth lab, the
 * album, somebody's name and the ranking. */
#ifndef KINGYO_CORE_SCENE_PAGES_H
#define KINGYO_CORE_SCENE_PAGES_H

#include <stdint.h>

#include "core/ledger.h"
#include "core/morph/species.h"

enum scene_keeping { LAB_NOT_SAVED = 0, LAB_SAVING, LAB_SAVED, LAB_UNSAVED /* It could not. */ };

/* The growth lab, while the phase is PHASE_LAB. Places are of core/game/lab_layout.h's canvas. */
struct scene_lab {
    uint8_t species, species_count; /* The built-in ones, then the makers'. */
    uint8_t refused;         /* Makers' files that could not be used. */
    uint8_t template;        /* enum graph_template that the graph began as. */
    uint8_t layer;           /* Which key's curve is in hand; from MORPH_KEY_MAX on, the scale. */
    uint8_t playing, compare, path;
    uint8_t points;          /* enum lab_part under the hand. */
    uint8_t presses, has_hand, upright;
    uint8_t holds;           /* enum lab_hold */
    uint8_t held_knot;       /* Of the graph or the scale, or 255. */
    uint8_t keeping;         /* enum scene_keeping of the last time SAVE was pressed. */
    uint8_t is_own, is_kept; /* What is shown is the species' own; is what the stall keeps. */
    uint8_t scale_knot_count;
    float x, y;              /* The hand. */
    float progress, age_days, length_m;
    float weight[MORPH_KEY_MAX]; /* As the graph has them at `progress`; >= 0, sum 1. */
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    struct species_card card; /* With its curves and scale as edited. */
};

#define ALBUM_FISH_MAX 6u /* As many pictures as a page has room for. */

/* The catch of the round, each fish from hatching to old age, while it is PHASE_ALBUM. */
struct scene_album {
    uint32_t fish_count;     /* <= ALBUM_FISH_MAX; the first caught come first. */
    uint32_t caught;         /* How many there were in all. */
    struct scene_grown {
        uint8_t owner;       /* Player index. */
        uint8_t is_caught;   /* It is older by now than when it was caught. */
        uint32_t look;
        float caught_age_days, caught_length_m;
        float age_days, length_m, progress;
        float maturity;      /* As struct scene_fish has it. */
    } fish[ALBUM_FISH_MAX];
};

#define SCENE_NAME_LETTERS 8u /* As NAME_LETTERS_MAX. */

/* Somebody writes a name (core/game/name.h), while it is PHASE_NAME; `waits` always. */
struct scene_name {
    uint8_t waits;           /* Who is to be asked for one, a bit a seat. */
    uint8_t seat;
    uint8_t alphabet;        /* enum name_alphabet */
    uint8_t key;             /* That is pointed at: a cell, or enum name_key. */
    uint8_t upright, has_hand, presses;
    uint8_t was_refused;     /* Another name is asked for. */
    uint8_t letter_count;
    uint16_t letter[SCENE_NAME_LETTERS];
    float x, y;              /* The hand, on the canvas (core/game/overlay.h). */
};

#define SCENE_BOARD_ROWS 10u /* As RANK_ROWS. */

/* The ranking, in PHASE_BOARD, by turns in attract, and on its pages of the operator's menu. */
struct scene_board {
    uint8_t shown;
    uint8_t mode;            /* enum game_mode */
    uint8_t period;          /* enum rank_period */
    float shown_s, left_s;   /* Since it came, and until it goes. */
    struct scene_row {
        uint32_t caught;     /* 0: nobody yet. */
        uint8_t seat;
        uint8_t is_new;      /* Of the round that was just played. */
        uint8_t is_sealed;   /* Its replay is kept: the shell's word. */
        uint32_t round_id;
        char name[LEDGER_NAME_SIZE]; /* UTF-8; "": none was given. */
    } row[SCENE_BOARD_ROWS];
};

#endif
