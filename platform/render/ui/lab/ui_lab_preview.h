/* ui_lab_preview.h -- the growth lab's state between frames: the selected species, as the lab and
 * as the ordinary morph blend it, and the trajectories of two of its points. */
#ifndef KINGYO_PLATFORM_RENDER_UI_LAB_UI_LAB_PREVIEW_H
#define KINGYO_PLATFORM_RENDER_UI_LAB_UI_LAB_PREVIEW_H

#include <stdbool.h>

#include "core/morph/morph.h"
#include "core/scene.h"
#include "platform/render/specimen.h"

#define LAB_PREVIEW_STEPS 64u /* Steps of a trajectory from hatching on. */

enum lab_preview_point { LAB_PREVIEW_DORSAL = 0, LAB_PREVIEW_EYE, LAB_PREVIEW_POINT_COUNT };

struct lab_preview_path {
    bool is_there; /* False if the species lacks the point. A ray has no dorsal root. */
    vec3 at[LAB_PREVIEW_STEPS + 1u]; /* Positions in lengths, in the body's frame, from hatching
                                        on. */
    vec3 ordinary[LAB_PREVIEW_STEPS + 1u]; /* Positions of the same point in the ordinary morph. */
    float bow; /* Largest distance of the trajectory from the straight line, in lengths. */
};

/* State of the growth lab's picture, about 180 KB, mostly the tables of the ordinary morph.
 * Zero-initialized: no species yet. */
struct ui_lab_preview {
    const struct species *species; /* Selected species; null: none. */
    uint32_t edition;              /* Counts the selected species. */
    struct species_card card;      /* Copy of the card from which the other fields were computed. */
    struct morph_rig rig;          /* Rig with the edited graphs. */
    struct morph_rig ordinary_rig;
    struct species ordinary;
    struct straight_memory memory;
    struct lab_preview_path ways[LAB_PREVIEW_POINT_COUNT];
    struct specimen_bounds bounds; /* Extent of the fish over all ages, in its usual view. */
    struct morph_pose pose;        /* Scratch. */
};

/* Selects a species with that card and recomputes only what changed. `card` has as many keys as the
 * species. */
void ui_lab_preview_set(struct ui_lab_preview *bench, const struct species *species,
                        const struct species_card *card);

#endif
