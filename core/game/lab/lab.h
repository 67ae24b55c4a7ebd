/* lab.h -- the growth lab: a page that plays a species' life and edits its growth graph.
 *
 * A pose over the water points at the canvas (lab_layout.h) and presses while it is below the press
 * height. A mouse presses with its button. LEFT and RIGHT move through the life while they are
 * held. A short press of START plays the life; holding START leaves the lab. OK shows the next
 * species. The lab has no score. In the lab, a key is a modelled growth stage of the species (key
 * shape). */
#ifndef KINGYO_CORE_GAME_LAB_LAB_H
#define KINGYO_CORE_GAME_LAB_LAB_H

#include "core/game/lab/lab_book.h"
#include "core/game/lab/lab_layout.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

/* Time without motion after which the kiosk leaves the lab for attract mode. */
#define LAB_IDLE_TICKS (60u * CORE_TICK_HZ)
/* Time without a press after which the kiosk also leaves the lab. A poi that swings on its cord
 * moves but never presses. */
#define LAB_SWING_TICKS (180u * CORE_TICK_HZ)
#define LAB_LIFE_TICKS (14u * CORE_TICK_HZ) /* Duration of the playback of a life. */
/* Pause after the playback of a life, before the playback starts again. */
#define LAB_REST_TICKS (5u * CORE_TICK_HZ / 2u)
#define LAB_END_TICKS (3u * CORE_TICK_HZ / 2u) /* Time for which START must be held to leave. */
#define LAB_GRAB 24.0f /* Distance on the canvas within which a press grabs a knot of the graph. */

/* Element that the pointer drags, from the press to the release. */
enum lab_hold {
    HOLD_NOTHING = 0,
    HOLD_AGE,    /* Position on the age axis. */
    HOLD_CHART,  /* Position on the growth curve. */
    HOLD_PLOT,   /* Position on the graph. */
    HOLD_WEIGHT, /* Knot of the weight curve of the key in `layer`. */
    HOLD_SIZE,   /* Knot of the scale curve. */
    HOLD_BUTTON,
    HOLD_LEAVE, /* Leave button, which acts when it is released. */
};

/* Value of `layer` for the scale curve. A smaller value is the index of a key. */
#define LAB_LAYER_SIZE MORPH_KEY_MAX

struct lab {
    uint8_t species; /* Index of the displayed species in the lab book. */
    uint8_t layer;   /* Curve that is edited: the index of a key, or LAB_LAYER_SIZE. */
    uint8_t playing, compare, path;
    uint8_t has_hand, presses;
    uint8_t hand;   /* Player whose pose points, or pointed last. */
    uint8_t points; /* Part of the page under the pointer (enum lab_part). */
    uint8_t holds;  /* Element that is dragged (enum lab_hold). */
    uint8_t held_knot;
    uint8_t upright;               /* 1 if the last input reported a portrait screen, otherwise
                                      0. */
    uint8_t edit_refused;          /* 1 if the last input reported that the store saves no edits,
                                      otherwise 0. */
    uint8_t has_edit[SPECIES_MAX]; /* 1 for each species of which the kiosk has a saved edit,
                                      otherwise 0. */
    uint32_t stir_tick, act_tick;  /* Tick of the last motion, and tick of the last press. */
    uint32_t rest_ticks;           /* Ticks since the playback of the life ended. */
    uint32_t start_ticks;          /* Ticks for which START has been held. */
    uint32_t save_id, saved_id;    /* Id of the newest edit sent to the store, and id of the newest
                                      edit confirmed on disk. */
    uint32_t asked_id;             /* Id of the save request for the current edit; 0 means that
                                      saving was not requested. */
    float x, y;                    /* Pointer position on the canvas. */
    float stir_x, stir_y;          /* Pointer position at the last motion. */
    float progress;
    struct lab_edit edit; /* Edit that is displayed and changed. The edit is saved only on
                             request. */
    struct lab_edit edits[SPECIES_MAX];
};

struct game;
struct world;
struct core_config;

/* Initializes `lab` with the saved edits in `config`. */
void lab_init(struct lab *lab, const struct core_config *config);

/* Opens the lab with the last shown species as a larva, and starts the playback. */
void lab_begin(struct game *game, struct world *world, const struct core_config *config,
               struct output *output);
void lab_tick(struct game *game, struct world *world, const struct core_config *config,
              const struct input *input, struct output *output);

/* Fills `out` with the visible state of the lab. */
void lab_show(const struct lab *lab, const struct lab_book *book, struct scene_lab *out);

uint64_t lab_hash_quick(uint64_t hash, const struct lab *lab); /* Returns `hash` continued over the
                                                                  lab without the saved edits. */
uint64_t lab_hash(uint64_t hash, const struct lab *lab);       /* Returns `hash` continued over the
                                                                  saved edits. */

#endif
