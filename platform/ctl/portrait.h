/* portrait.h -- a fish as a natural history plate shows it: from its left, from above, aslant.
 *
 * The nose points left in every view. The skin is painted by paint_at() at every pixel, in soft
 * light from the upper left; what is clear lets through what is behind it. */
#ifndef KINGYO_PLATFORM_CTL_PORTRAIT_H
#define KINGYO_PLATFORM_CTL_PORTRAIT_H

#include "core/morph/morph.h"
#include "platform/ctl/raster.h"

enum portrait_view {
    VIEW_SIDE,   /* Its left side. */
    VIEW_ABOVE,  /* Its back. */
    VIEW_ASLANT, /* From the left, before it and above: as it looks in the stall's tank. */
    VIEW_COUNT,
};

extern const char *const portrait_view_names[VIEW_COUNT];

/* How much of what is behind it a painted point hides, [0, 1]: fins let light through, most of all
 * at their tips, where only rays and a thin skin are. */
float portrait_hides(const struct paint *paint, const struct species_vertex *at);

/* A fish that stands still to be drawn. About 50 KiB. */
struct portrait {
    const struct species *species;
    const struct species_mesh *mesh;
    struct morph_pose pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* Where the fish is in a view, in its own measure: x right, y up. Empty: `left` > `right`. */
struct portrait_bounds {
    float left, right, low, high;
};

extern const struct portrait_bounds portrait_nowhere;

/* Blends the near mesh (level of detail 0) at `progress` [0, 1]. `species` must outlive it. */
void portrait_take(struct portrait *portrait, const struct species *species,
                   const struct morph_rig *rig, float progress);

/* Grows `bounds` to hold the fish too. */
void portrait_measure(const struct portrait *portrait, enum portrait_view view,
                      struct portrait_bounds *bounds);

/* Draws it so that the view's point (`x`, `y`) falls on the raster's middle, one measure
 * `scale_px` long. Finish the raster to see it. */
void portrait_draw(const struct portrait *portrait, enum portrait_view view, float x, float y,
                   float scale_px, struct raster *raster);

#endif
