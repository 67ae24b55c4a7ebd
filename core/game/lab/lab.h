/* lab.h -- the growth lab: a page to play a species' life and to edit its growth graph.
 *
 * A pose over the water points at the canvas (lab_layout.h) and presses while it is below the press
 * height; a mouse uses its button. LEFT and RIGHT move through the life while held. START plays the
 * life, or leaves the lab when held. OK shows the next species. The lab has no score. */
#ifndef KINGYO_CORE_GAME_LAB_LAB_H
#define KINGYO_CORE_GAME_LAB_LAB_H

#include "core/game/lab/lab_book.h"
#include "core/game/lab/lab_layout.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

/* Time without motion after which the lab returns to attract mode. */
#define LAB_IDLE_TICKS (60u * CORE_TICK_HZ)
/* Time without a press after which the lab also ends, because a poi swinging on its cord moves
 * but never presses. */
#define LAB_SWING_TICKS (180u * CORE_TICK_HZ)
#define LAB_LIFE_TICKS (14u * CORE_TICK_HZ) /* Duration of a played life. */
/* Pause at the end of a played life, before it starts again. */
#define LAB_REST_TICKS (5u * CORE_TICK_HZ / 2u)
#define LAB_END_TICKS (3u * CORE_TICK_HZ / 2u) /* Time for which START must be held to leave. */
#define LAB_GRAB 24.0f /* Distance on the canvas within which a knot is grabbed. */

/* Element that is dragged, from the press to the release. */
enum lab_hold {
    HOLD_NOTHING = 0,
    HOLD_AGE,    /* Position on the age axis. */
    HOLD_CHART,  /* Position on the growth curve. */
    HOLD_PLOT,   /* Position on the graph. */
    HOLD_WEIGHT, /* Knot of the key in `layer`. */
    HOLD_SIZE,   /* Knot of the scale. */
    HOLD_BUTTON,
    HOLD_LEAVE, /* Leave button, which acts on release. */
};

#define LAB_LAYER_SIZE MORPH_KEY_MAX /* Value of `layer` for the scale; smaller values are keys. */

struct lab {
    uint8_t species; /* Index in the order of the lab book. */
    uint8_t layer;   /* Curve that is edited. */
    uint8_t playing, compare, path;
    uint8_t has_hand, presses;
    uint8_t hand;   /* Player whose pose points, or pointed last. */
    uint8_t points; /* enum lab_part under the pointer. */
    uint8_t holds;  /* enum lab_hold */
    uint8_t held_knot;
    uint8_t upright;               /* 1: portrait screen, from the last input. */
    uint8_t edit_refused;          /* 1: the store saves no edits, from the last input. */
    uint8_t has_edit[SPECIES_MAX]; /* 1: the kiosk has a saved edit of that species. */
    uint32_t stir_tick, act_tick;  /* Ticks of the last motion and of the last press. */
    uint32_t rest_ticks;           /* Ticks since the played life reached its end. */
    uint32_t start_ticks;          /* Ticks for which START has been held. */
    uint32_t save_id, saved_id;    /* Ids of the newest edit sent to the store, and of the newest
                                      edit confirmed on disk. */
    uint32_t asked_id;             /* Id of the save request for the current edit; 0: not
                                      requested. */
    float x, y;                    /* Pointer position on the canvas. */
    float stir_x, stir_y;          /* Pointer position at the last motion. */
    float progress;
    struct lab_edit edit; /* Edit that is displayed and changed; saved only on request. */
    struct lab_edit edits[SPECIES_MAX];
};

struct game;
struct world;
struct core_config;

/* Initializes `lab` with the saved edits in `config`. */
void lab_init(struct lab *lab, const struct core_config *config);

/* Opens the lab with the last shown species as a larva, playing. */
void lab_begin(struct game *game, struct world *world, const struct core_config *config,
               struct output *output);
void lab_tick(struct game *game, struct world *world, const struct core_config *config,
              const struct input *input, struct output *output);

/* Fills `out` with the visible state of the lab. */
void lab_show(const struct lab *lab, const struct lab_book *book, struct scene_lab *out);

uint64_t lab_hash_quick(uint64_t hash, const struct lab *lab); /* Hash without the saved edits. */
uint64_t lab_hash(uint64_t hash, const struct lab *lab);       /* Hash of the saved edits. */

#endif
