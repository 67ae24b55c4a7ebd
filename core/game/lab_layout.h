/* lab_layout.h -- where everything of the growth lab is on its canvas (overlay.h), for the hand
 * that presses it and the picture that shows it alike. */
#ifndef KINGYO_CORE_GAME_LAB_LAYOUT_H
#define KINGYO_CORE_GAME_LAB_LAYOUT_H

#include <stdint.h>

#include "core/game/overlay.h"
#include "core/morph/species.h"

/* What can be pressed, then what can be dragged, then what only shows. */
enum lab_part {
    LAB_NOTHING = 0,
    LAB_BACK,       /* The species before ... */
    LAB_NEXT,       /* ... and after. */
    LAB_LEAVE,
    LAB_PLAY,
    LAB_COMPARE,
    LAB_PATH,
    LAB_OWN,        /* A template each, in the order of enum graph_template. */
    LAB_ORDINARY,
    LAB_PAIRWISE,
    LAB_SIMULTANEOUS,
    LAB_SMOOTH,
    LAB_ADD,
    LAB_REMOVE,
    LAB_SIZE,       /* The scale curve is worked on. */
    LAB_SAVE,
    LAB_RESET,
    LAB_KEY,        /* The first key's picture; the others' follow. */
    LAB_KEY_LAST = LAB_KEY + (int)MORPH_KEY_MAX - 1,
    LAB_AGE,        /* The line of life under the keys. */
    LAB_PLOT,       /* The graph's field. */
    LAB_CHART,      /* The growth curve's field. */
    LAB_PRESSED_COUNT,

    LAB_STAGE = LAB_PRESSED_COUNT, /* Where the fish swims. */
    LAB_NAME,
    LAB_CARD,       /* The paper under the graph, and under the growth curve. */
    LAB_CHART_CARD,
    LAB_PART_COUNT,
};

/* Where a part is for a species of so many keys; empty where there is no such key. */
struct overlay_box lab_box(int upright, uint32_t key_count, enum lab_part part);

/* The part that a press there means; LAB_NOTHING elsewhere. */
enum lab_part lab_part_at(int upright, uint32_t key_count, struct overlay_point at);

/* The line of life runs from under the first key's picture to under the last's. */
float lab_age_x(int upright, uint32_t key_count, float progress);
float lab_age_progress(int upright, uint32_t key_count, float x); /* Clamped to [0, 1]. */

#endif
