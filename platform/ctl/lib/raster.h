/* raster.h -- rasterizes triangles of any opacity in any order, with sixteen samples for each
 * pixel.
 *
 * Each pixel stores a list of layers, one for each triangle that covers a part of the pixel. A
 * layer has a colour, an opacity, a depth plane and the mask of covered samples. raster_finish()
 * sorts the layers of each sample by depth. Therefore transparent parts are blended correctly,
 * edges are smooth, and the caller does not have to sort triangles.
 *
 * The kiosk draws the same fish with OpenGL ES (platform/render/pass/specimen_pass.c). `kingyoctl`
 * does not use that pass for two reasons. The rasterizer needs neither a screen nor an OpenGL
 * driver. The pass draws another picture, because it does not sort transparent parts by depth. */
#pragma once

#include <stddef.h>

#include "platform/ctl/lib/canvas.h"

struct raster_layer {
    vec3 colour; /* Colour in linear light. */
    float hides; /* Opacity in [0, 1]. 0 means invisible, and 1 means opaque. */
    /* `depth` is the depth at the centre of the pixel. A larger depth is nearer. `depth_dx` and
     * `depth_dy` are the changes of the depth per pixel to the right and per pixel down. */
    float depth, depth_dx, depth_dy;
    /* Number, counted from 1, of the layer that was added to the same pixel before this layer. 0
     * means the end of the pixel's list. */
    uint32_t below;
    uint16_t samples; /* Bit mask of the samples of the pixel that the triangle covers. */
};

struct raster {
    uint32_t width, height;
    /* Newest layer of each pixel, as a number counted from 1. 0 means that the pixel has no layer.
     * The array has width x height elements. */
    uint32_t *top;
    struct raster_layer *layers;
    size_t layer_count, layer_room;
    bool failed; /* True after memory allocation for a layer has failed. */
};

/* Callback that returns the colour and the opacity of a triangle at a point. `part` contains the
 * barycentric weights of the three corners, whose sum is 1. */
struct raster_skin {
    struct raster_colour {
        vec3 colour; /* Colour in linear light. */
        float hides;
    } (*look)(const void *triangle, const float part[3]);
    const void *triangle;
};

/* Allocates a raster. Each side is 1 .. CANVAS_SIDE_MAX pixels, as for a canvas. Returns false if
 * memory allocation fails. */
bool raster_open(struct raster *raster, uint32_t width, uint32_t height);

/* Frees the memory of the raster. */
void raster_close(struct raster *raster);

/* Draws a triangle. The corners are in pixels with y downward, and a larger z is nearer. A triangle
 * is drawn only if its corners appear counter-clockwise. Two triangles that share an edge never
 * cover the same sample. `skin` is called once for each covered pixel. */
void raster_triangle(struct raster *raster, const vec3 corner[3], struct raster_skin skin);

/* Blends the raster over the canvas, with the raster's top left corner at (`left`, `top`) in
 * pixels, and clears the raster. Returns false if the picture is incomplete because an earlier
 * memory allocation failed. */
bool raster_finish(struct raster *raster, struct canvas *canvas, uint32_t left, uint32_t top);
