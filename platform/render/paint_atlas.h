/* paint_atlas.h -- the layout of a fish's paint atlas: where each part lies on a sheet of
 * PAINT_SIZE texels a side.
 *
 * The upper half is the body, u to the right and v down. Below it are cells of PAINT_CELL_WIDTH x
 * PAINT_CELL_HEIGHT, four in a row: one for each fin, and two for a pair. The ends of u and v are
 * at texel centres, so that filtering never reaches another part. */
#ifndef KINGYO_PLATFORM_RENDER_PAINT_ATLAS_H
#define KINGYO_PLATFORM_RENDER_PAINT_ATLAS_H

#include <stdbool.h>

#include "core/morph/species.h"

#define PAINT_SIZE 256u
#define PAINT_BODY_HEIGHT 128u
#define PAINT_CELL_WIDTH 64u
#define PAINT_CELL_HEIGHT 32u

/* Writes the atlas coordinates of a vertex, [0, 1] each. */
void paint_atlas_find(const struct species_vertex *vertex, float uv[2]);

/* Finds the surface point painted at (x, y), in texels [0, PAINT_SIZE), where texel centres are at
 * half texels. Returns false if the atlas has no part there. */
bool paint_atlas_at(float x, float y, struct species_vertex *vertex);

#endif
