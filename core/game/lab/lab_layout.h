/* lab_layout.h -- the positions of all parts of the growth lab on its canvas (pointer_mapping.h).
 * The pointer code and the renderer share the positions. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/pointer_mapping.h"
#include "core/morph/species.h"

/* Parts of the lab page: first the parts that can be pressed, then the fields for dragging, then
 * the parts without a function. */
enum lab_part {
    LAB_NOTHING = 0,
    LAB_BACK, /* Button that shows the previous species. */
    LAB_NEXT, /* Button that shows the next species. */
    LAB_LEAVE,
    LAB_PLAY,
    LAB_COMPARE,
    LAB_PATH,
    /* First template button. The template buttons have the order of enum graph_template. */
    LAB_OWN,
    LAB_ORDINARY,
    LAB_PAIRWISE,
    LAB_SIMULTANEOUS,
    LAB_SMOOTH,
    LAB_ADD,
    LAB_REMOVE,
    /* Button that selects the scale curve (the length of the fish over its life) for editing. */
    LAB_SIZE,
    LAB_SAVE,
    LAB_RESET,
    LAB_KEY, /* Picture of the first key shape; the pictures of the other key shapes follow. */
    LAB_KEY_LAST = LAB_KEY + (int)MORPH_KEY_MAX - 1,
    LAB_AGE,   /* Age axis of the page, below the pictures of the key shapes. */
    LAB_PLOT,  /* Field in which the graph is drawn. */
    LAB_CHART, /* Field in which the growth curve is drawn. */
    LAB_PRESSED_COUNT,

    LAB_STAGE = LAB_PRESSED_COUNT, /* Area in which the displayed fish swims. */
    LAB_NAME,
    /* Background drawn behind the graph. LAB_CHART_CARD is the background drawn behind the growth
     * curve. */
    LAB_CARD,
    LAB_CHART_CARD,
    LAB_PART_COUNT,
};

/* Returns the box of `part` for a species with `key_count` keys. The box is empty if `part` is the
 * picture of a key that the species does not have. */
struct layout_box lab_box(bool upright, uint32_t key_count, enum lab_part part);

/* Returns the part that a press at `at` selects, or LAB_NOTHING. */
enum lab_part lab_part_at(bool upright, uint32_t key_count, struct layout_point at);

/* lab_age_x() returns the x coordinate of `progress` on the age axis, and lab_age_progress()
 * returns the progress at `x`, clamped to [0, 1]. The axis runs from below the first key's picture
 * to below the last key's picture. */
float lab_age_x(bool upright, uint32_t key_count, float progress);
float lab_age_progress(bool upright, uint32_t key_count, float x);
