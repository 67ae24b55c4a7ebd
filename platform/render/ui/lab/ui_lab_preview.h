/* ui_lab_preview.h -- the growth lab's state between frames: the selected species and the
 * trajectories of two points of the fish. Each trajectory is computed twice: with the deformation
 * graphs of the growth lab, and with the ordinary morph (linear interpolation between two keys,
 * 2005 thesis, eq. 3.1). */
#pragma once

#include <stdbool.h>

#include "core/morph/morph.h"
#include "core/scene.h"
#include "platform/render/specimen.h"

/* Number of steps into which a trajectory is divided. A trajectory is the path of a point of the
 * fish from hatching to the adult. */
#define LAB_PREVIEW_STEPS 64u

enum lab_preview_point { LAB_PREVIEW_DORSAL = 0, LAB_PREVIEW_EYE, LAB_PREVIEW_POINT_COUNT };

struct lab_preview_path {
    /* True if the species has the traced point. A stingray, for example, has no dorsal fin. */
    bool is_there;
    /* Positions of the traced point from hatching to the adult, in body lengths, in the body's
     * coordinate system. */
    vec3 at[LAB_PREVIEW_STEPS + 1u];
    /* Positions of the traced point in the ordinary morph, in body lengths. */
    vec3 ordinary[LAB_PREVIEW_STEPS + 1u];
    /* Largest distance between the trajectory and the straight line from its start to its end, in
     * body lengths. */
    float bow;
};

/* State of the growth lab's picture. The size is about 180 KB, mostly the tables of the ordinary
 * morph. All fields 0 means that no species is selected yet. */
struct ui_lab_preview {
    const struct species *species; /* Selected species. Null means that no species is selected. */
    /* Counter that increases by 1 with each selection of a species. */
    uint32_t edition;
    /* True if the selected species is the species of the scene. False if this kiosk does not have
     * the species of the scene. */
    bool is_shown;
    /* Copy of the species card from which the other fields were computed. */
    struct species_card card;
    /* Deformation graphs with the player's edits, prepared for computing poses. */
    struct morph_rig rig;
    struct morph_rig ordinary_rig;
    struct species ordinary;
    struct straight_memory memory;
    struct lab_preview_path ways[LAB_PREVIEW_POINT_COUNT];
    /* Extents of the fish over all ages, in the usual view (specimen_portrait()). */
    struct specimen_bounds bounds;
    struct morph_pose pose; /* Temporary memory for computing trajectories. */
};

/* Selects `species` with the card `card` that the player edited. Recomputes only the fields that
 * changed. `card` must have as many keys as the species. */
void ui_lab_preview_set(struct ui_lab_preview *bench, const struct species *species,
                        const struct species_card *card);
