/* morph_skin.h -- a closed triangle surface with tests for points inside and their depth. The
 * functions are pure.
 *
 * The body is one surface, and the ball of each eye is another. A point is inside if a line from
 * the point to the right crosses the surface an odd number of times. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_SKIN_H
#define KINGYO_PLATFORM_CTL_MORPH_SKIN_H

#include <stdbool.h>

#include "core/morph/morph.h"

#define SKIN_TRIANGLE_MAX (MESH_INDEX_MAX / 3u)
#define SKIN_ROWS 16u    /* Number of bin rows from bottom to top. */
/* Number of bin columns from front to rear. A line to the right passes through exactly one bin. */
#define SKIN_COLUMNS 32u
#define SKIN_BINS (SKIN_ROWS * SKIN_COLUMNS)

struct skin { /* A surface with its bins. The size is about 3 MiB. */
    uint32_t triangle_count;
    vec3 corner[SKIN_TRIANGLE_MAX][3];
    float low_y, low_z, high_y, high_z;
    uint32_t bin_first[SKIN_BINS + 1u];
    uint16_t binned[SKIN_TRIANGLE_MAX * SKIN_BINS];
};

/* Builds the surface from the triangles of `part` on `side`. SIDE_MIDDLE selects all triangles of
 * the part. */
void skin_build(struct skin *skin, const struct species_mesh *mesh, const vec3 *positions,
                enum species_part part, enum species_side side);

/* Returns whether the surface has triangles and no hole. The area vectors of a closed surface have
 * the sum zero. */
bool skin_is_closed(const struct skin *skin);

/* Returns the volume inside a closed surface. */
float skin_volume(const struct skin *skin);

/* Returns whether `point` is inside the surface. */
bool skin_has(const struct skin *skin, vec3 point);

/* Returns the distance from `point` to the nearest point of the surface. The point may be inside or
 * outside. */
float skin_distance(const struct skin *skin, vec3 point);

/* Returns the distance from `point`, which is inside, to the exit in direction `way` (length 1).
 * Returns 0 if there is no exit. */
float skin_way_out(const struct skin *skin, vec3 point, vec3 way);

#endif
