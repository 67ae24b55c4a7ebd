/* lab_layout.h -- where everything of the growth lab is, for the hand that presses it and the
 * picture that shows it alike.
 *
 * A canvas of 1280 x 720 lies on wide screens, one of 854 x 1400 on those that stand upright, x to
 * the right, y down, from its top left corner; each is as large as fits, centred. The canvas is
 * measured in the tank's camera: what is under a point of the water's plane is under that point's
 * place on the screen, whatever the screen's size. */
#ifndef KINGYO_CORE_GAME_LAB_LAYOUT_H
#define KINGYO_CORE_GAME_LAB_LAYOUT_H

#include <stdint.h>

#include "core/morph/species.h"
#include "core/view.h"

/* Narrower screens (width over height) take the upright canvas. */
#define LAB_UPRIGHT_ASPECT 0.61f

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

struct lab_box {
    float x, y, width, height;
};

struct lab_point {
    float x, y;
};

struct lab_point lab_canvas(int upright); /* Its width and height. */

/* Where a part is for a species of so many keys; empty where there is no such key. */
struct lab_box lab_box(int upright, uint32_t key_count, enum lab_part part);

/* The part that a press there means; LAB_NOTHING elsewhere. */
enum lab_part lab_part_at(int upright, uint32_t key_count, struct lab_point at);

/* Where a point of the world is on the canvas. */
struct lab_point lab_point_of(const struct view *view, int upright, vec3 point_m);

/* The line of life runs from under the first key's picture to under the last's. */
float lab_age_x(int upright, uint32_t key_count, float progress);
float lab_age_progress(int upright, uint32_t key_count, float x); /* Clamped to [0, 1]. */

#endif
