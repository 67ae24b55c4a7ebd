/* specimen.h -- one fish of any species, of any age, seen from any side: what the growth lab and
 * the album put on the screen. Plain data and arithmetic; specimen_pass.h draws it.
 *
 * A screen adds specimens to its batch (ui_batch.h) between its quads. Pixels, origin at the top
 * left, +y down. There is no perspective: `length_px` is the fish's length wherever it is. */
#ifndef KINGYO_PLATFORM_RENDER_SPECIMEN_H
#define KINGYO_PLATFORM_RENDER_SPECIMEN_H

#include <stdbool.h>
#include <stdint.h>

#include "core/morph/morph.h"

#define SPECIMEN_MAX 24u /* Of a screen: a lab's fish, its rival and eight keys; an album's page. */

struct specimen {
    const struct species *species; /* Stays as it is until the frame is drawn, ... */
    uint32_t edition; /* ... and longer: another number says that it holds another fish now. */
    const struct morph_rig *rig; /* Kept until the frame is drawn; null: the species' own curves. */
    float progress;              /* [0, 1] */
    float x_px, y_px;            /* Where the middle of the body (z = 0 of its frame) is seen. */
    float length_px;             /* Of one measure of the species; > 0. */
    /* 0: it shows its left side, nose to the left. Yaw turns the nose toward the viewer, pitch its
     * back, roll tips the nose down on the screen. */
    float yaw_rad, pitch_rad, roll_rad;
    float phase_rad; /* Of its swimming in place, ... */
    float amplitude; /* ... and how strongly: 0 still, 1 cruising. */
    float shadow;    /* [0, 1] how dark a shadow lies under it; 0: none. */
    float fade;      /* [0, 1] 0: whole, 1: gone. */
    uint32_t tint;   /* 0xRRGGBBAA, mixed over its own paint by its alpha; 0: its own alone. */
    uint32_t look;   /* Of a goldfish: whose pattern it wears, as struct scene_fish has it, ... */
    float ripe;      /* ... how far that has come through its youth's coat, [0, 1], ... */
    float maturity;  /* ... and how far its grey has turned, as struct scene_fish has it. */
};

/* What becomes of the body's axes: screen right, screen up, and toward the viewer. */
struct specimen_axes {
    vec3 right, up, toward;
};
struct specimen_axes specimen_axes(const struct specimen *specimen);

/* Where a point of the body's frame is seen: lengths, as morph_shape() gives it, not swimming. */
void specimen_project(const struct specimen *specimen, vec3 point, float *x_px, float *y_px);

/* How far it is seen to reach from its middle, in lengths, at whichever of its keys it reaches
 * most: a frame that holds it all its life. Swimming in place is not counted. */
struct specimen_bounds {
    float left, right, up, down; /* >= 0 each. */
};
struct specimen_bounds specimen_bounds(const struct specimen *specimen);

/* Sets place and length so that it fits the box all its life, in the middle of it. About 0.1 ms. */
void specimen_fit(struct specimen *specimen, float x_px, float y_px, float width_px,
                  float height_px);

/* The sides from which a species is drawn in books: most from the left, an eel a little from above
 * so that its wave is seen, a ray from high above. Fills yaw and pitch and leaves the rest. */
void specimen_portrait(struct specimen *specimen);

#endif
