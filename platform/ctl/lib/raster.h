/* raster.h -- rasterizes triangles of any opacity in any order, with sixteen samples for each
 * pixel.
 *
 * A pixel stores every layer that covers a part of it: the colour, the opacity, the depth plane and
 * the mask of covered samples. Finally, the layers of each sample are sorted by depth. A glass
 * larva therefore shows its far eye, an eye has a clean border to the skin, and the caller does not
 * have to sort triangles. */
#ifndef KINGYO_PLATFORM_CTL_LIB_RASTER_H
#define KINGYO_PLATFORM_CTL_LIB_RASTER_H

#include <stddef.h>

#include "platform/ctl/lib/canvas.h"

struct raster_layer {
    vec3 colour; /* Linear colour. */
    float hides; /* Opacity in [0, 1]. A value of 1 is opaque. */
    /* `depth` is the depth at the pixel's centre, and a larger depth is nearer. `depth_dx` and
     * `depth_dy` are its slopes. */
    float depth, depth_dx, depth_dy;
    /* Number of the layer that was drawn before in the same pixel, counted from 1. A value of 0
     * means no layer. */
    uint32_t below;
    uint16_t samples; /* Mask of the covered samples of the pixel. */
};

struct raster {
    uint32_t width, height;
    /* Number of the newest layer of each pixel, counted from 1. The array has width x height
     * elements. */
    uint32_t *top;
    struct raster_layer *layers;
    size_t layer_count, layer_room;
    bool failed; /* True if memory allocation for a layer failed. */
};

/* Returns the colour and the opacity of a triangle at a point. `part` are the weights of the
 * corners, which have the sum 1. */
struct raster_skin {
    struct raster_colour {
        vec3 colour; /* Linear colour. */
        float hides;
    } (*look)(const void *triangle, const float part[3]);
    const void *triangle;
};

/* Allocates a raster. The limits of the sides are those of a canvas. Returns false if memory
 * allocation fails. */
bool raster_open(struct raster *raster, uint32_t width, uint32_t height);

/* Frees the raster. */
void raster_close(struct raster *raster);

/* Draws a triangle. The corners are in pixels (y down), and a larger z is nearer. Only triangles
 * that appear counter-clockwise are drawn. Two triangles that share an edge never share a sample.
 * The skin function is called once for each pixel. */
void raster_triangle(struct raster *raster, const vec3 corner[3], struct raster_skin skin);

/* Blends the picture over the canvas with its corner at `left`, `top`, and clears the raster.
 * Returns false if a memory allocation failed after raster_open(), because the picture is then
 * incomplete. */
bool raster_finish(struct raster *raster, struct canvas *canvas, uint32_t left, uint32_t top);

#endif
