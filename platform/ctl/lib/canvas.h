/* canvas.h -- a software canvas for rectangles, shadows and text that is written as a PNG file.
 *
 * Pixels are linear RGB, so that a half-covered pixel has half the light. Colours are given as
 * 0xRRGGBB in sRGB. Positions are in pixels from the top left corner, with x to the right and y
 * down. Drawing is clipped to the canvas. */
#ifndef KINGYO_PLATFORM_CTL_LIB_CANVAS_H
#define KINGYO_PLATFORM_CTL_LIB_CANVAS_H

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"

/* Longest side in pixels. Image viewers still open pictures of this size. */
#define CANVAS_SIDE_MAX 16384u

/* A canvas. canvas_open() fills it. */
struct canvas {
    uint32_t width, height;
    vec3 *pixels; /* Pixels of the canvas, width x height, top row first. The canvas owns them. */
};

/* A rectangle in pixels. The edges may lie between pixels. */
struct canvas_box {
    float left, top, width, height;
};

enum canvas_align { ALIGN_LEFT, ALIGN_CENTRE, ALIGN_RIGHT };

/* Allocates a canvas and clears it to black. Both sides are 1 .. CANVAS_SIDE_MAX pixels. Returns
 * false if memory is exhausted. */
bool canvas_open(struct canvas *canvas, uint32_t width, uint32_t height);
void canvas_close(struct canvas *canvas); /* Frees the pixels. A canvas whose canvas_open() failed
                                             is allowed. */

vec3 canvas_linear(vec3 srgb); /* Converts sRGB to linear light. Each component is in [0, 1]. */

/* Converts linear light to sRGB. Each component is in [0, 1]. */
vec3 canvas_srgb(vec3 linear);
vec3 canvas_colour(uint32_t rgb); /* Returns the sRGB colour 0xRRGGBB in linear light. */

/* Fills `box` with a vertical gradient from `above` at the top to `below` at the bottom. A pixel on
 * an edge is blended by its coverage. */
void canvas_fill(struct canvas *canvas, struct canvas_box box, uint32_t above, uint32_t below);

/* Draws a shadow: a soft-edged ellipse that darkens the pixels under it by up to `strength` [0,
 * 1]. */
void canvas_shade(struct canvas *canvas, struct canvas_box box, float strength);

/* Draws UTF-8 text in the kiosk's font with its baseline at `y`. The size of the em is `size_px`
 * pixels. */
void canvas_words(struct canvas *canvas, float x, float y, float size_px, enum canvas_align align,
                  uint32_t rgb, const char *words);

/* Writes the canvas as a PNG file. Returns 0, or a negative errno. After an error, an existing file
 * at `path` is unchanged and no new file exists. */
int canvas_write_png(const struct canvas *canvas, const char *path);

#endif
