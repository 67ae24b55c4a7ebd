/* lab_state.h -- the state of the growth lab, and of the album that is shown after a round. */
#pragma once

#include <stdint.h>

#include "core/game/lab/lab_edit.h"
#include "core/game/lab/lab_layout.h"
#include "core/input.h"
#include "core/scene.h"

/* Duration of the display of one fish's life in the album. */
#define ALBUM_LIFE_TICKS (7u * CORE_TICK_HZ)
/* Delay between the starts of the displayed lives of two successive fish. */
#define ALBUM_STAGGER_TICKS (CORE_TICK_HZ * 4u / 5u)
/* Time for which the grown fish remain on the album's page after the last fish has grown. */
#define ALBUM_REST_TICKS (4u * CORE_TICK_HZ)

struct album {
    /* Number of fish caught in this round by all players, including fish that did not fit on the
     * page. */
    uint32_t caught;
    uint32_t fish_count;
    struct album_fish {
        uint32_t fish; /* Index of the fish in the tank. */
        uint32_t look;
        uint32_t owner; /* Index of the player who caught the fish. */
        float age_days, length_m;
    } fish[ALBUM_FISH_MAX];
};

/* Time without pointer motion after which the kiosk leaves the growth lab for attract mode. */
#define LAB_IDLE_TICKS (60u * CORE_TICK_HZ)
/* Time without a press after which the kiosk leaves the growth lab even if a poi moves. A poi that
 * swings on its cord moves but never presses. */
#define LAB_SWING_TICKS (180u * CORE_TICK_HZ)
/* Duration of the playback of a fish's growth in the growth lab. */
#define LAB_LIFE_TICKS (14u * CORE_TICK_HZ)
/* Pause after the playback of a fish's growth, before the playback starts again. */
#define LAB_REST_TICKS (5u * CORE_TICK_HZ / 2u)
/* Time for which START must be held to leave the growth lab. */
#define LAB_END_TICKS (3u * CORE_TICK_HZ / 2u)
/* Largest distance on the canvas between a press and a knot (control point) of the graph at which
 * the press grabs the knot. */
#define LAB_GRAB 24.0f

/* Element that the pointer drags, from the press to the release. */
enum lab_hold {
    HOLD_NOTHING = 0,
    HOLD_AGE,   /* The pointer drags the displayed age along the age axis. */
    HOLD_CHART, /* The pointer drags along the growth curve, which selects the displayed age. */
    /* The pointer drags along the graph, which selects the displayed progress of the growth. */
    HOLD_PLOT,
    /* The pointer drags a knot (control point) of the weight curve of the key shape that `layer`
     * selects. */
    HOLD_WEIGHT,
    /* The pointer drags a knot of the scale curve, which gives the length of the fish over its
     * life. */
    HOLD_SIZE,
    HOLD_BUTTON,
    HOLD_LEAVE, /* The pointer presses the leave button, which acts when it is released. */
};

/* Value of the field `layer` of struct lab that selects the scale curve. A smaller value is the
 * index of a key shape and selects the weight curve of this key shape. */
#define LAB_LAYER_SIZE MORPH_KEY_MAX

struct lab {
    uint8_t species; /* Index of the displayed species in the lab book. */
    /* Curve that the player edits: the weight curve of the key with this index, or the scale curve
     * if the value is LAB_LAYER_SIZE. */
    uint8_t layer;
    uint8_t playing, compare, path;
    uint8_t has_pointer, presses;
    uint8_t pointer_player; /* Player whose pose moves the pointer, or moved it last. */
    uint8_t points;         /* Part of the page under the pointer (enum lab_part). */
    uint8_t holds;          /* Element that is dragged (enum lab_hold). */
    uint8_t held_knot;
    /* 1 if the last input reported a portrait screen, otherwise 0. */
    uint8_t upright;
    /* 1 if the last input reported that the store saves no edits, otherwise 0. */
    uint8_t edit_refused;
    /* 1 for each species of which the kiosk has a saved edit, otherwise 0. */
    uint8_t has_edit[SPECIES_MAX];
    /* `stir_tick` is the tick of the last pointer motion. `act_tick` is the tick of the last
     * press. */
    uint32_t stir_tick, act_tick;
    uint32_t rest_ticks;  /* Ticks since the playback of the growth ended. */
    uint32_t start_ticks; /* Ticks for which START has been held. */
    /* `save_id` is the id of the newest edit sent to the store. `saved_id` is the id of the newest
     * edit confirmed on disk. */
    uint32_t save_id, saved_id;
    /* Id of the save request for the current edit; 0 means that saving was not requested. */
    uint32_t requested_id;
    float x, y;           /* Pointer position on the canvas. */
    float stir_x, stir_y; /* Position of the pointer when it last moved. */
    float progress;
    /* Edit that is displayed and changed. The edit is saved only on request. */
    struct lab_edit edit;
    struct lab_edit edits[SPECIES_MAX];
};
