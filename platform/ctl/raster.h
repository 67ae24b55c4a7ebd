/* raster.h -- triangles to pixels: sixteen samples a pixel, in any order, however clear.
 *
 * A pixel keeps every layer that touches it: its colour, how much it hides, its plane of depth and
 * which samples it covers. At the end each sample's layers are put in order by depth, so a glass
 * larva shows its far eye, an eye meets the skin in a clean line, and nobody sorts triangles. */
#ifndef KINGYO_PLATFORM_CTL_RASTER_H
#define KINGYO_PLATFORM_CTL_RASTER_H

#include <stddef.h>

#include "platform/ctl/canvas.h"

struct raster_layer {
    vec3 colour;                      /* Linear. */
    float hides;                      /* [0, 1]; 1 is opaque. */
    float depth, depth_dx, depth_dy;  /* At the pixel's centre; larger is nearer. */
    uint32_t below;                   /* The pixel's layer drawn before, from 1; 0: none. */
    uint16_t samples;                 /* Which of the sixteen it covers. */
};

struct raster {
    uint32_t width, height;
    uint32_t *top; /* width x height: a pixel's newest layer, from 1. */
    struct raster_layer *layers;
    size_t layer_count, layer_room;
    bool failed; /* There was no memory for a layer. */
};

/* What a triangle looks like at a point: `part` are its corners' shares, which sum to 1. */
struct raster_skin {
    struct raster_colour {
        vec3 colour; /* Linear. */
        float hides;
    } (*look)(const void *triangle, const float part[3]);
    const void *triangle;
};

/* Sides as a canvas's. False when there is no memory. */
bool raster_open(struct raster *raster, uint32_t width, uint32_t height);
void raster_close(struct raster *raster);

/* Corners in pixels (y down), z nearer the larger. Drawn where it is counter-clockwise as seen;
 * triangles that share an edge share no sample. The skin is asked once a pixel. */
void raster_triangle(struct raster *raster, const vec3 corner[3], struct raster_skin skin);

/* Lays what was drawn over the canvas, its corner at `left`, `top`, and is empty again. False when
 * memory failed since it was opened: the picture is not whole. */
bool raster_finish(struct raster *raster, struct canvas *canvas, uint32_t left, uint32_t top);

#endif
