/* ui_screens.h -- what stands where in each phase of the game. Knows no OpenGL. */
#ifndef KINGYO_PLATFORM_RENDER_UI_SCREENS_H
#define KINGYO_PLATFORM_RENDER_UI_SCREENS_H

#include <stdint.h>

#include "core/scene.h"
#include "platform/render/ui_batch.h"
#include "platform/render/ui_bench.h"
#include "platform/species/shelf.h"

/* What was shown last, so that a change can be eased in. Zero is a valid start. */
struct ui_memory {
    uint32_t hint_tick;          /* When the hint last changed ... */
    uint32_t caught_tick[POI_MAX]; /* ... and each player's catch. */
    uint32_t caught[POI_MAX];
    uint32_t pointed_tick;       /* When another mode was last pointed at ... */
    uint8_t pointed, pointed_before; /* ... and which two those were. */
    uint8_t hint;
    const struct shelf *shelf; /* Makers' species, behind the built-in ones; null: none. */
    struct ui_bench bench;     /* The growth lab's. */
};

/* Notes what `scene` shows without drawing it, so that the next picture is eased in from there. */
void ui_screens_notice(struct ui_memory *memory, const struct scene *scene);

/* Fills `batch` (cleared first) with the whole screen of `scene`. Both sizes > 0. */
void ui_screens(struct ui_batch *batch, struct ui_memory *memory, const struct scene *scene,
                float width_px, float height_px);

#endif
