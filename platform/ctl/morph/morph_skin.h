/* morph_skin.h -- a closed triangle surface with tests for points inside and their depth. The
 * functions are pure.
 *
 * The body is one surface, and the ball of each eye is another. A point is inside if a line from
 * the point to the right crosses the surface an odd number of times. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SKIN_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SKIN_H

#include <stdbool.h>

#include "core/morph/morph.h"

#define MORPH_SKIN_TRIANGLE_MAX (MESH_INDEX_MAX / 3u)
#define MORPH_SKIN_ROWS 16u /* Number of bin rows from bottom to top. */
/* Number of bin columns from front to rear. A line to the right passes through exactly one bin. */
#define MORPH_SKIN_COLUMNS 32u
#define MORPH_SKIN_BINS (MORPH_SKIN_ROWS * MORPH_SKIN_COLUMNS)

struct morph_skin { /* A surface with its bins. The size is about 3 MiB. */
    uint32_t triangle_count;
    vec3 corner[MORPH_SKIN_TRIANGLE_MAX][3];
    float low_y, low_z, high_y, high_z;
    uint32_t bin_first[MORPH_SKIN_BINS + 1u];
    uint16_t binned[MORPH_SKIN_TRIANGLE_MAX * MORPH_SKIN_BINS];
};

/* Builds the surface from the triangles of `part` on `side`. SIDE_MIDDLE selects all triangles of
 * the part. */
void morph_skin_build(struct morph_skin *skin, const struct species_mesh *mesh,
                      const vec3 *positions, enum species_part part, enum species_side side);

/* Returns whether the surface has triangles and no hole. The area vectors of a closed surface have
 * the sum zero. */
bool morph_skin_is_closed(const struct morph_skin *skin);

/* Returns the volume inside a closed surface. */
float morph_skin_volume(const struct morph_skin *skin);

/* Returns whether `point` is inside the surface. */
bool morph_skin_has(const struct morph_skin *skin, vec3 point);

/* Returns the distance from `point` to the nearest point of the surface. The point may be inside or
 * outside. */
float morph_skin_distance(const struct morph_skin *skin, vec3 point);

/* Returns the distance from `point`, which is inside, to the exit in direction `way` (length 1).
 * Returns 0 if there is no exit. */
float morph_skin_way_out(const struct morph_skin *skin, vec3 point, vec3 way);

#endif
