/* ui_screens.h -- fills the batch of quads with the screen of each phase of the game. Uses no
 * OpenGL. */
#pragma once

#include <stdint.h>

#include "core/scene.h"
#include "platform/render/ui/lab/ui_lab_preview.h"
#include "platform/render/ui/ui_batch.h"
#include "platform/species/library.h"

/* Maximum number of paper tags of one player that fly to the counter (the displayed number of
 * caught fish) at the same time. Each fish has one tag. If more fish are caught meanwhile, the
 * oldest flights end early and their fish are counted at once. */
#define UI_FLIGHT_MAX 8u

/* Values that the screens showed last, so that a changed value can be animated. A zeroed struct is
 * a valid initial state. */
struct ui_memory {
    uint32_t hint_tick; /* Tick of the last change of the hint. */
    uint32_t caught[POI_MAX];
    /* Tick at which the tag of fish number n of each player began to fly from the bowl to the
     * counter. The index is n % UI_FLIGHT_MAX. */
    uint32_t flight_tick[POI_MAX][UI_FLIGHT_MAX];
    uint32_t tick;         /* Tick of the scene that was shown last. */
    uint32_t pointed_tick; /* Tick of the last change of the selected tags. */
    /* Bit mask of the selected tags (`pointed`), and of the tags that were selected before the last
     * change (`pointed_before`). */
    uint8_t pointed, pointed_before;
    uint8_t hint, phase;
    /* Library of the species that users have drawn. Null means that there is no library. */
    const struct library *library;
    struct ui_lab_preview bench; /* State of the growth lab between frames. */
};

/* Records the values of `scene` in `memory` without drawing. If a later scene has other values, its
 * screen animates the change from the recorded values. */
void ui_screens_notice(struct ui_memory *memory, const struct scene *scene);

/* Clears `batch` and fills it with the whole screen of `scene`. `width_px` and `height_px` are the
 * screen size, > 0. */
void ui_screens(struct ui_batch *batch, struct ui_memory *memory, const struct scene *scene,
                float width_px, float height_px);
