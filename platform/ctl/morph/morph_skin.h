/* morph_skin.h -- a closed triangle surface, with tests whether a point is inside and how deep. The
 * functions are pure.
 *
 * The body of a fish is one surface, and each eyeball is another surface. A point is inside if a
 * ray from the point to the right crosses the surface an odd number of times. The triangles are
 * sorted into bins, a grid seen from the right, to make the test fast. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SKIN_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SKIN_H

#include <stdbool.h>

#include "core/morph/morph.h"

#define MORPH_SKIN_TRIANGLE_MAX (MESH_INDEX_MAX / 3u)
#define MORPH_SKIN_ROWS 16u /* Number of rows of the bin grid, from bottom to top. */
/* Number of columns of the bin grid, from front to rear. A ray to the right passes through exactly
 * one bin. */
#define MORPH_SKIN_COLUMNS 32u
#define MORPH_SKIN_BINS (MORPH_SKIN_ROWS * MORPH_SKIN_COLUMNS)

struct morph_skin { /* A closed surface with its bins. The structure has about 3 MiB. */
    uint32_t triangle_count;
    vec3 corner[MORPH_SKIN_TRIANGLE_MAX][3];
    float low_y, low_z, high_y, high_z;
    uint32_t bin_first[MORPH_SKIN_BINS + 1u];
    uint16_t binned[MORPH_SKIN_TRIANGLE_MAX * MORPH_SKIN_BINS];
};

/* Builds the surface from the triangles of the part `part` on `side`. SIDE_MIDDLE selects the
 * triangles of all sides. */
void morph_skin_build(struct morph_skin *skin, const struct species_mesh *mesh,
                      const vec3 *positions, enum species_part part, enum species_side side);

/* Returns true if the surface has triangles and no hole. In a closed surface, the sum of the
 * triangles' area vectors is zero. */
bool morph_skin_is_closed(const struct morph_skin *skin);

/* Returns the volume inside a closed surface. */
float morph_skin_volume(const struct morph_skin *skin);

/* Returns whether `point` is inside the surface. */
bool morph_skin_has(const struct morph_skin *skin, vec3 point);

/* Returns the distance from `point` to the nearest point of the surface. The point may be inside or
 * outside. */
float morph_skin_distance(const struct morph_skin *skin, vec3 point);

/* Returns the distance from `point`, which must be inside, to the surface in the direction `way`, a
 * unit vector. Returns 0 if the ray does not meet the surface. */
float morph_skin_way_out(const struct morph_skin *skin, vec3 point, vec3 way);

#endif
