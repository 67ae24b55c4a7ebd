/* morph_skin.h -- a closed surface that can be asked what is inside it, and how deep. Pure.
 *
 * The body is one, each eye's ball another. A point is inside where a line from it to the right
 * leaves the surface an odd number of times. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_SKIN_H
#define KINGYO_PLATFORM_CTL_MORPH_SKIN_H

#include <stdbool.h>

#include "core/morph/morph.h"

#define SKIN_TRIANGLE_MAX (MESH_INDEX_MAX / 3u)
#define SKIN_ROWS 16u    /* Bins from below to above ... */
#define SKIN_COLUMNS 32u /* ... and from front to rear: a line to the right passes one. */
#define SKIN_BINS (SKIN_ROWS * SKIN_COLUMNS)

struct skin { /* About 3 MiB. */
    uint32_t triangle_count;
    vec3 corner[SKIN_TRIANGLE_MAX][3];
    float low_y, low_z, high_y, high_z;
    uint32_t bin_first[SKIN_BINS + 1u];
    uint16_t binned[SKIN_TRIANGLE_MAX * SKIN_BINS];
};

/* The triangles of `part` on `side` (SIDE_MIDDLE for all of the part). */
void skin_build(struct skin *skin, const struct species_mesh *mesh, const vec3 *positions,
                enum species_part part, enum species_side side);

/* Whether it has triangles and no hole: the areas' vectors of a closed surface sum to nothing. */
bool skin_is_closed(const struct skin *skin);

float skin_volume(const struct skin *skin);

bool skin_has(const struct skin *skin, vec3 point);

/* To the nearest point of the surface, inside or out. */
float skin_distance(const struct skin *skin, vec3 point);

/* How far `point`, inside, is from coming out along `way` (of length 1); 0 where it never does. */
float skin_way_out(const struct skin *skin, vec3 point, vec3 way);

#endif
