/* canvas.h -- a picture in the making: linear light, rectangles, words, and a PNG at the end.
 *
 * Pixels are linear RGB, so that what is half covered is half as bright; colours are given as
 * 0xRRGGBB in sRGB. x goes right and y down, in pixels, from the top left corner; drawing outside
 * is cut off. */
#ifndef KINGYO_PLATFORM_CTL_CANVAS_H
#define KINGYO_PLATFORM_CTL_CANVAS_H

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"

#define CANVAS_SIDE_MAX 16384u /* Pixels of a side: what viewers still open. */

struct canvas {
    uint32_t width, height;
    vec3 *pixels; /* width x height, top row first; the canvas's own. */
};

struct canvas_box {
    float left, top, width, height;
};

enum canvas_align { ALIGN_LEFT, ALIGN_CENTRE, ALIGN_RIGHT };

/* Allocates and clears to black. Sides 1 .. CANVAS_SIDE_MAX. False when there is no memory. */
bool canvas_open(struct canvas *canvas, uint32_t width, uint32_t height);
void canvas_close(struct canvas *canvas); /* Also of a canvas that could not be opened. */

vec3 canvas_linear(vec3 srgb); /* Each in [0, 1]; and back: */
vec3 canvas_srgb(vec3 linear);
vec3 canvas_colour(uint32_t rgb); /* 0xRRGGBB, linear. */

/* Fills `box` from the colour `above` at its top to `below` at its bottom; edges that lie between
 * pixels cover them in part. */
void canvas_fill(struct canvas *canvas, struct canvas_box box, uint32_t above, uint32_t below);

/* A soft-edged ellipse that darkens what is under it by up to `strength` [0, 1]: a shadow. */
void canvas_shade(struct canvas *canvas, struct canvas_box box, float strength);

/* UTF-8 in the kiosk's own lettering, `size_px` an em, on the baseline `y`. */
void canvas_words(struct canvas *canvas, float x, float y, float size_px, enum canvas_align align,
                  uint32_t rgb, const char *words);

/* 0, or a negative errno; then the file is not there, or as it was before. */
int canvas_write_png(const struct canvas *canvas, const char *path);

#endif
