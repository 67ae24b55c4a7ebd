/* canvas.h -- a software canvas on which rectangles and text are drawn, and which is written
 * as a PNG file.
 *
 * Pixels are stored as linear RGB, so that partial coverage is blended correctly. Colour parameters
 * are 0xRRGGBB in sRGB. Positions are in pixels from the top left corner, with x to the right and y
 * downward. Drawing is clipped to the canvas. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"

/* Longest side of a canvas in pixels. Common image viewers open pictures of this size. */
#define CANVAS_SIDE_MAX 16384u

/* A canvas. canvas_open() initializes the structure. */
struct canvas {
    uint32_t width, height;
    vec3 *pixels; /* Array of width x height pixels, top row first. The canvas owns the array. */
};

/* A rectangle in pixels. The edges may lie between pixels. */
struct canvas_box {
    float left, top, width, height;
};

enum canvas_align { ALIGN_LEFT, ALIGN_CENTRE, ALIGN_RIGHT };

/* Allocates a canvas and clears it to black. Asserts that each side is 1 .. CANVAS_SIDE_MAX pixels.
 * Returns false if memory allocation fails. */
bool canvas_open(struct canvas *canvas, uint32_t width, uint32_t height);
/* Frees the pixels. May also be called after canvas_open() failed. */
void canvas_close(struct canvas *canvas);

/* Converts an sRGB colour to linear light. Each component is in [0, 1]. */
vec3 canvas_linear(vec3 srgb);

vec3 canvas_colour(uint32_t rgb); /* Converts the sRGB colour 0xRRGGBB to linear light. */

/* Fills `box` with a vertical gradient from the colour `above` at the top to the colour `below` at
 * the bottom. A partly covered pixel at the edge of the box is blended by its coverage. */
void canvas_fill(struct canvas *canvas, struct canvas_box box, uint32_t above, uint32_t below);

/* Draws UTF-8 text in the kiosk's font with the baseline at `y`. `x` is the left end, the middle or
 * the right end of the text, as `align` selects. The font's em is `size_px` pixels high. */
void canvas_words(struct canvas *canvas, float x, float y, float size_px, enum canvas_align align,
                  uint32_t rgb, const char *words);

/* Writes the canvas as a PNG file. Returns 0, or a negative errno. After an error, no new file
 * exists, and an existing file at `path` is unchanged. */
int canvas_write_png(const struct canvas *canvas, const char *path);
