/* fish_preview.h -- draws a fish as in a natural history plate: from its left, from above or
 * aslant.
 *
 * The nose points left in every view. The skin is painted by paint_at() at every pixel, in soft
 * light from the upper left. Transparent parts show the parts behind them. */
#ifndef KINGYO_PLATFORM_CTL_LIB_FISH_PREVIEW_H
#define KINGYO_PLATFORM_CTL_LIB_FISH_PREVIEW_H

#include "core/morph/morph.h"
#include "platform/ctl/lib/raster.h"

enum fish_preview_view {
    VIEW_SIDE,  /* View of the fish's left side. */
    VIEW_ABOVE, /* View of the fish's back from above. */
    /* View from the left, the front and above, as a visitor sees a fish in the kiosk's tank. */
    VIEW_ASLANT,
    VIEW_COUNT,
};

extern const char *const fish_preview_view_names[VIEW_COUNT];

/* Returns the opacity of a painted point, in [0, 1]. Fins are partly transparent, most of all at
 * their tips, where only rays and a thin skin are left. */
float fish_preview_hides(const struct paint *paint, const struct species_vertex *at);

/* A fish in a fixed pose that is ready for drawing. The size is about 50 KiB. */
struct fish_preview {
    const struct species *species;
    const struct species_mesh *mesh;
    struct morph_pose pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* Extent of the fish in a view, in its own measure (1 is the measured length). x points right and y
 * points up. The bounds are empty if `left` > `right`. */
struct fish_preview_bounds {
    float left, right, low, high;
};

extern const struct fish_preview_bounds fish_preview_nowhere;

/* Blends the near mesh (level of detail 0) at `progress`, in [0, 1]. `species` must outlive the
 * portrait. */
void fish_preview_pose(struct fish_preview *preview, const struct species *species,
                       const struct morph_rig *rig, float progress);

/* Extends `bounds` so that they also contain the fish. */
void fish_preview_measure(const struct fish_preview *preview, enum fish_preview_view view,
                          struct fish_preview_bounds *bounds);

/* Draws the fish so that the view's point (`x`, `y`) lies at the middle of the raster. One measured
 * length of the fish is `scale_px` pixels long. Call raster_finish() to copy the picture to a
 * canvas. */
void fish_preview_draw(const struct fish_preview *preview, enum fish_preview_view view, float x,
                       float y, float scale_px, struct raster *raster);

#endif
