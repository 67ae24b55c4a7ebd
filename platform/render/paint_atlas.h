/* paint_atlas.h -- where each part of a fish lies on its sheet of paint: PAINT_SIZE texels a side.
 *
 * The upper half is the body, u to the right and v down; below it are cells of PAINT_CELL_WIDTH x
 * PAINT_CELL_HEIGHT, four in a row: each fin, and both of a pair. Texels' middles are the ends of u
 * and v, so filtering never reaches into another part. */
#ifndef KINGYO_PLATFORM_RENDER_PAINT_ATLAS_H
#define KINGYO_PLATFORM_RENDER_PAINT_ATLAS_H

#include <stdbool.h>

#include "core/morph/species.h"

#define PAINT_SIZE 256u
#define PAINT_BODY_HEIGHT 128u
#define PAINT_CELL_WIDTH 64u
#define PAINT_CELL_HEIGHT 32u

/* Where a vertex's paint is, [0, 1] each. */
void paint_atlas_find(const struct species_vertex *vertex, float uv[2]);

/* What is painted at a point of the sheet: texels, [0, PAINT_SIZE) each, with a texel's middle half
 * a texel in. False where nothing is. */
bool paint_atlas_at(float x, float y, struct species_vertex *vertex);

#endif
