/* scene_pages.h -- the pages shown over the tank between two rounds: growth lab, album, name entry
 * and leaderboard. */
#ifndef KINGYO_CORE_SCENE_PAGES_H
#define KINGYO_CORE_SCENE_PAGES_H

#include <stdint.h>

#include "core/ledger.h"
#include "core/morph/species.h"

enum scene_keeping { LAB_NOT_SAVED = 0, LAB_SAVING, LAB_SAVED, LAB_UNSAVED /* Saving failed. */ };

/* State of the growth lab while the phase is PHASE_LAB. Positions are on the canvas of
 * core/game/lab/lab_layout.h. */
struct scene_lab {
    uint8_t species, species_count; /* The built-in species, followed by the custom species. */
    uint8_t refused;                /* Number of species files that were rejected. */
    uint8_t template_id;            /* enum graph_template that the graph started from. */
    uint8_t layer;                  /* Key shape whose curve is edited; from MORPH_KEY_MAX on,
                                       the scale. */
    uint8_t playing, compare, path;
    uint8_t points; /* enum lab_part under the pointer. */
    uint8_t presses, has_hand, upright;
    uint8_t holds;           /* enum lab_hold */
    uint8_t held_knot;       /* Knot of the graph or the scale that is dragged; 255: none. */
    uint8_t keeping;         /* enum scene_keeping of the last press of SAVE. */
    uint8_t is_own, is_kept; /* is_own: the graph is the species' original. is_kept: the graph
                                equals the saved one. */
    uint8_t scale_knot_count;
    float x, y; /* Pointer position. */
    float progress, age_days, length_m;
    float weight[MORPH_KEY_MAX]; /* Weights of the key shapes at `progress`; >= 0, sum 1. */
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    struct species_card card; /* Species with the edited curves and scale. */
};

#define ALBUM_FISH_MAX 6u /* Capacity of one page in pictures. */

/* The catch of the round while the phase is PHASE_ALBUM; each fish is shown from hatching to old
 * age. */
struct scene_album {
    uint32_t fish_count; /* <= ALBUM_FISH_MAX; in the order of the catch. */
    uint32_t caught;     /* Total number of caught fish. */
    struct scene_grown {
        uint8_t owner;     /* Player index. */
        uint8_t is_caught; /* 1: the age shown is past the age at which the fish was caught. */
        uint32_t look;
        float caught_age_days, caught_length_m;
        float age_days, length_m, progress;
        float maturity; /* Position along the colour keys, as in struct scene_fish. */
    } fish[ALBUM_FISH_MAX];
};

#define SCENE_NAME_LETTERS 8u /* Equal to NAME_LETTERS_MAX. */

/* State of the name entry (core/game/ranking/name.h) while the phase is PHASE_NAME; `waits` is
 * valid in every phase. */
struct scene_name {
    uint8_t waits; /* Bit mask of the slots that still need a name. */
    uint8_t seat;
    uint8_t alphabet; /* enum name_alphabet */
    uint8_t key;      /* Highlighted key: a cell, or enum name_key. */
    uint8_t upright, has_hand, presses;
    uint8_t was_refused; /* 1: the name was rejected, and another name is required. */
    uint8_t letter_count;
    uint16_t letter[SCENE_NAME_LETTERS];
    float x, y; /* Pointer position on the canvas (core/game/pointer_mapping.h). */
};

#define SCENE_LEADERBOARD_ROWS 10u /* Equal to RANK_ROWS. */

/* The leaderboard in PHASE_LEADERBOARD, in attract mode at intervals, and on its pages of the
 * operator's menu. */
struct scene_leaderboard {
    uint8_t shown;
    uint8_t mode;          /* enum game_mode */
    uint8_t period;        /* enum rank_period */
    float shown_s, left_s; /* Seconds since the leaderboard appeared, and until it disappears. */
    struct scene_row {
        uint32_t caught; /* 0: the row is empty. */
        uint8_t seat;
        uint8_t is_new;    /* 1: the row comes from the round that was just played. */
        uint8_t is_sealed; /* 1: a replay of the row is stored; the shell fills in this field. */
        uint32_t round_id;
        char name[LEDGER_NAME_SIZE]; /* UTF-8; "": no name was entered. */
    } row[SCENE_LEADERBOARD_ROWS];
};

#endif
