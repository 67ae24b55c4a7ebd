/* paint_atlas.h -- computes the layout of a fish's paint atlas: the place of each body part on a
 * sheet of PAINT_SIZE x PAINT_SIZE texels.
 *
 * The upper half of the sheet shows the body, with the surface coordinate u to the right and v
 * downward. Below the body are cells of PAINT_CELL_WIDTH x PAINT_CELL_HEIGHT texels, four in a row.
 * Each fin in the midplane has one cell, and each pair of fins has two cells. The ends of u and v
 * are at texel centres, so that texture filtering never reads texels of another body part. */
#ifndef KINGYO_PLATFORM_RENDER_PAINT_ATLAS_H
#define KINGYO_PLATFORM_RENDER_PAINT_ATLAS_H

#include <stdbool.h>

#include "core/morph/species.h"

#define PAINT_SIZE 256u
#define PAINT_BODY_HEIGHT 128u
#define PAINT_CELL_WIDTH 64u
#define PAINT_CELL_HEIGHT 32u

/* Writes the atlas coordinates of a vertex to `uv`, each in [0, 1]. */
void paint_atlas_find(const struct species_vertex *vertex, float uv[2]);

/* Finds the surface point that is painted at (x, y), in texels [0, PAINT_SIZE). Texel centres are
 * at half texels. Returns false if no body part has texels at (x, y). */
bool paint_atlas_at(float x, float y, struct species_vertex *vertex);

#endif
