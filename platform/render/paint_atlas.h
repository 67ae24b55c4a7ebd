/* paint_atlas.h -- computes the layout of a fish's paint atlas, and paints its texels. The layout
 * is the place of each body part on a sheet of PAINT_SIZE x PAINT_SIZE texels. Uses no OpenGL.
 *
 * The upper half of the sheet shows the body, with the surface coordinate u to the right and v
 * downward. Below the body are cells of PAINT_CELL_WIDTH x PAINT_CELL_HEIGHT texels, four in a row.
 * Each unpaired fin has one cell, and each pair of fins has two cells. The ends of u and v are at
 * texel centres, so that texture filtering never reads texels of another body part. */
#pragma once

#include <stdbool.h>

#include "core/morph/morph.h"
#include "core/morph/species.h"

#define PAINT_SIZE 256u
#define PAINT_BODY_HEIGHT 128u
#define PAINT_CELL_WIDTH 64u
#define PAINT_CELL_HEIGHT 32u

/* Writes the atlas coordinates of a vertex to `uv`, each in [0, 1]. */
void paint_atlas_find(const struct species_vertex *vertex, float uv[2]);

/* Finds the point of the fish's surface whose paint is at (x, y) of the sheet, in texels [0,
 * PAINT_SIZE). The centre of a texel has coordinates that end in .5. Returns false if no body part
 * has texels at (x, y). */
bool paint_atlas_at(float x, float y, struct species_vertex *vertex);

/* Converts a fraction to a byte. `x` is clamped to [0, 1]. */
uint8_t paint_atlas_byte(float x);

#define PAINT_BAND 8u   /* Number of texel rows that are painted together. */
#define PAINT_COARSE 4u /* Distance in texels between two points of the coarse painting. */
#define PAINT_COARSE_SIZE (PAINT_SIZE / PAINT_COARSE)

/* Temporary memory for painting PAINT_BAND texel rows at a time. All sheets may share one struct
 * paint_brush. */
struct paint_brush {
    uint8_t paint[PAINT_BAND * PAINT_SIZE][4]; /* Colour and transparency of each texel. */
    uint8_t shine[PAINT_BAND * PAINT_SIZE];    /* Reflectance of each texel. */
    /* Colour, transparency and reflectance of each coarse point. */
    float coarse[PAINT_COARSE_SIZE * PAINT_COARSE_SIZE][5];
};

/* Parameters for painting one sheet (a texture layer with a fish's paint). */
struct painting {
    const struct species *species;
    float weights[MORPH_KEY_MAX]; /* Weight of each key shape in the sheet's paint. */
    struct paint_brush *brush;
};

/* Computes the paint at the points of a coarse grid over the whole sheet. Must be called before
 * paint_atlas_coarse_band(). */
void paint_atlas_coarse_points(const struct painting *painting);
/* Paints PAINT_BAND texel rows of the sheet by interpolation between the coarse points. `first` is
 * the first row and a multiple of PAINT_BAND. */
void paint_atlas_coarse_band(const struct painting *painting, uint32_t first);
/* Paints PAINT_BAND texel rows of the sheet, with the paint computed for each texel. `first` is the
 * first row and a multiple of PAINT_BAND. */
void paint_atlas_fine_band(const struct painting *painting, uint32_t first);
