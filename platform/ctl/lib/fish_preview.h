/* fish_preview.h -- draws one fish from its left side, from above or at an angle, as in a book of
 * natural history.
 *
 * The fish's nose points to the left of the picture in every view. paint_at() gives the colour at
 * every pixel, and the light is soft and comes from the upper left. Transparent parts show the
 * parts behind them. */
#pragma once

#include "core/morph/morph.h"
#include "platform/ctl/lib/raster.h"

enum fish_preview_view {
    VIEW_SIDE,  /* View of the fish's left side. */
    VIEW_ABOVE, /* View of the fish's back from above. */
    /* View from the left, the front and above, similar to the view of the kiosk's tank. */
    VIEW_ASLANT,
    VIEW_COUNT,
};

/* Names of the views, as --view accepts them. The list ends with null. */
extern const char *const fish_preview_view_names[VIEW_COUNT + 1];

/* Returns the opacity of a painted point, in [0, 1]. Fins are partly transparent. The opacity is
 * least at the fin tips, which consist only of rays and thin skin. */
float fish_preview_hides(const struct paint *paint, const struct species_vertex *at);

/* A fish in a fixed pose, ready to be drawn. The structure has about 50 KiB. */
struct fish_preview {
    const struct species *species;
    const struct species_mesh *mesh;
    struct morph_pose pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* Bounds of the fish in a view, in units of the fish's measured length. x points right and y points
 * up. The bounds are empty if `left` > `right`. */
struct fish_preview_bounds {
    float left, right, low, high;
};

extern const struct fish_preview_bounds fish_preview_nowhere;

/* Computes the pose of the fish at the life progress `progress`, in [0, 1], and blends the near
 * mesh (level of detail 0) for it. `species` must outlive `preview`. */
void fish_preview_pose(struct fish_preview *preview, const struct species *species,
                       const struct morph_rig *rig, float progress);

/* Extends `bounds` so that they contain the fish in `view`. */
void fish_preview_measure(const struct fish_preview *preview, enum fish_preview_view view,
                          struct fish_preview_bounds *bounds);

/* Draws the fish into the raster. The point (`x`, `y`) of the view is placed at the middle of the
 * raster. The fish's measured length is `scale_px` pixels. The caller then calls raster_finish() to
 * copy the picture to a canvas. */
void fish_preview_draw(const struct fish_preview *preview, enum fish_preview_view view, float x,
                       float y, float scale_px, struct raster *raster);
