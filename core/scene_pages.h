/* scene_pages.h -- the pages shown over the tank between two rounds: growth lab, album, name entry
 * and leaderboard. */
#pragma once

#include <stdint.h>

#include "core/ledger.h"
#include "core/morph/species.h"

/* Progress of saving after the last press of SAVE. LAB_UNSAVED means that the save failed. */
enum scene_keeping { LAB_NOT_SAVED = 0, LAB_SAVING, LAB_SAVED, LAB_UNSAVED };

/* State of the growth lab while the phase is PHASE_LAB. Positions are on the canvas of
 * core/game/lab/lab_layout.h. */
struct scene_lab {
    /* Index of the species, and number of species: the built-in species followed by the custom
     * species. */
    uint8_t species, species_count;
    uint8_t refused; /* Number of species files that were rejected. */
    /* Template from which the graph was started (enum graph_template). */
    uint8_t template_id;
    /* Key shape whose curve is edited; MORPH_KEY_MAX or more means the scale curve. */
    uint8_t layer;
    uint8_t playing, compare, path;
    uint8_t points; /* Part of the lab page under the pointer (enum lab_part). */
    uint8_t presses, has_pointer, upright;
    uint8_t holds; /* Element that is dragged (enum lab_hold). */
    /* Index of the knot (control point) of the graph or of the scale curve that is dragged; 255
     * means none. */
    uint8_t held_knot;
    /* Progress of saving after the last press of SAVE (enum scene_keeping). */
    uint8_t keeping;
    /* `is_own` is 1 if the graph is the species' original graph. `is_kept` is 1 if the graph equals
     * the saved graph. */
    uint8_t is_own, is_kept;
    uint8_t scale_knot_count;
    float x, y; /* Pointer position on the canvas. */
    float progress, age_days, length_m;
    /* Weights of the key shapes at `progress`. Each weight is >= 0, and the sum is 1. */
    float weight[MORPH_KEY_MAX];
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    struct species_card card; /* Data of the species with the edited curves and the edited scale. */
};

#define ALBUM_FISH_MAX 6u /* Number of fish pictures on one page of the album. */

/* The catch of the round while the phase is PHASE_ALBUM; each fish is shown from hatching to old
 * age. */
struct scene_album {
    /* Number of fish on the page, <= ALBUM_FISH_MAX, in the order of the catch. */
    uint32_t fish_count;
    uint32_t caught; /* Number of fish caught in the round by all players, without presents. */
    struct scene_grown {
        uint8_t owner; /* Player index. */
        /* 1 if the shown age is past the age at which the fish was caught, otherwise 0. */
        uint8_t is_caught;
        /* 1 if the fish is a present to a player who caught none, otherwise 0. */
        uint8_t is_present;
        uint32_t look;
        float caught_age_days, caught_length_m;
        float age_days, length_m, progress;
        float maturity; /* Colour maturity, as in struct scene_fish. */
    } fish[ALBUM_FISH_MAX];
};

#define SCENE_NAME_LETTERS 8u /* Largest number of letters of a name, equal to NAME_LETTERS_MAX. */

/* State of the name entry (core/game/ranking/name.h) while the phase is PHASE_NAME; `waits` is
 * valid in every phase. */
struct scene_name {
    uint8_t waits; /* Bit mask of the slots that still need a name. */
    uint8_t slot;
    uint8_t alphabet; /* enum name_alphabet */
    uint8_t key;      /* Highlighted key: the index of a letter's cell, or an enum name_key. */
    uint8_t upright, has_pointer, presses;
    /* 1 if the last name was rejected and a different name is required, otherwise 0. */
    uint8_t was_refused;
    uint8_t letter_count;
    uint16_t letter[SCENE_NAME_LETTERS];
    float x, y; /* Pointer position on the canvas (core/game/pointer_mapping.h). */
};

#define SCENE_LEADERBOARD_ROWS 10u /* Number of rows of a leaderboard, equal to RANK_ROWS. */

/* The leaderboard in PHASE_LEADERBOARD, in attract mode at intervals, and on its pages of the
 * operator's menu. */
struct scene_leaderboard {
    uint8_t shown;
    uint8_t mode;   /* enum game_mode */
    uint8_t level;  /* enum level */
    uint8_t period; /* enum rank_period */
    /* `shown_s` is the time since the leaderboard appeared, and `left_s` the time until it
     * disappears, in seconds. */
    float shown_s, left_s;
    struct scene_row {
        uint32_t caught; /* Number of fish caught; 0 means that the row is empty. */
        uint8_t slot;
        /* 1 if the row comes from the round that was just played, otherwise 0. */
        uint8_t is_new;
        /* 1 if a replay of the row's round is stored, otherwise 0. The shell fills in this
         * field. */
        uint8_t is_sealed;
        uint32_t round_id;
        char name[LEDGER_NAME_SIZE]; /* Name in UTF-8; "" means that no name was entered. */
    } row[SCENE_LEADERBOARD_ROWS];
};
