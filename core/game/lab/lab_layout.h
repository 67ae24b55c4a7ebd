/* lab_layout.h -- positions of all parts of the growth lab on its canvas (pointer_mapping.h),
 * shared by the pointer code and the renderer. */
#ifndef KINGYO_CORE_GAME_LAB_LAB_LAYOUT_H
#define KINGYO_CORE_GAME_LAB_LAB_LAYOUT_H

#include <stdint.h>

#include "core/game/pointer_mapping.h"
#include "core/morph/species.h"

/* Parts that can be pressed, then fields for dragging, then parts without a function. */
enum lab_part {
    LAB_NOTHING = 0,
    LAB_BACK, /* Previous species. */
    LAB_NEXT, /* Next species. */
    LAB_LEAVE,
    LAB_PLAY,
    LAB_COMPARE,
    LAB_PATH,
    LAB_OWN, /* First of the template buttons, in the order of enum graph_template. */
    LAB_ORDINARY,
    LAB_PAIRWISE,
    LAB_SIMULTANEOUS,
    LAB_SMOOTH,
    LAB_ADD,
    LAB_REMOVE,
    LAB_SIZE, /* Selects the scale curve for editing. */
    LAB_SAVE,
    LAB_RESET,
    LAB_KEY, /* Picture of the first key; the other keys follow. */
    LAB_KEY_LAST = LAB_KEY + (int)MORPH_KEY_MAX - 1,
    LAB_AGE,   /* Age axis below the keys. */
    LAB_PLOT,  /* Field of the graph. */
    LAB_CHART, /* Field of the growth curve. */
    LAB_PRESSED_COUNT,

    LAB_STAGE = LAB_PRESSED_COUNT, /* Area in which the fish swims. */
    LAB_NAME,
    LAB_CARD, /* Backgrounds below the graph and below the growth curve. */
    LAB_CHART_CARD,
    LAB_PART_COUNT,
};

/* Returns the box of `part` for a species with `key_count` keys; an empty box for a missing key. */
struct layout_box lab_box(int upright, uint32_t key_count, enum lab_part part);

/* Returns the part that a press at `at` selects, or LAB_NOTHING. */
enum lab_part lab_part_at(int upright, uint32_t key_count, struct layout_point at);

/* Convert between progress and x on the age axis, which runs from below the first key's picture to
 * below the last one's. */
float lab_age_x(int upright, uint32_t key_count, float progress);
float lab_age_progress(int upright, uint32_t key_count, float x); /* Result clamped to [0, 1]. */

#endif
