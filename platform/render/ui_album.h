/* ui_album.h -- the caught goldfish, each with the pattern that it wears in the tank. */
#ifndef KINGYO_PLATFORM_RENDER_UI_ALBUM_H
#define KINGYO_PLATFORM_RENDER_UI_ALBUM_H

#include "core/morph/species.h"
#include "core/scene.h"

/* What the album's screen keeps from frame to frame. Zero knows nothing yet. */
struct ui_album {
    uint32_t edition; /* Counts the fish that were dressed. */
    struct album_dress {
        uint32_t look, edition; /* Edition 0: nobody's. */
        struct species species; /* The wakin with this look's coats. */
    } dresses[ALBUM_FISH_MAX];
};

/* Sees to it that the `index`th dress is that look's; returns it. */
const struct album_dress *ui_album_dress(struct ui_album *album, uint32_t index, uint32_t look);

#endif
