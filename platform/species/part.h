/* part.h -- the names of body parts, and the vertex that represents each part. Pure functions. */
#ifndef KINGYO_PLATFORM_SPECIES_PART_H
#define KINGYO_PLATFORM_SPECIES_PART_H

#include "core/morph/morph.h"

/* Returns the enum species_part of a part name in a species text, such as "dorsal2". Returns
 * PART_COUNT for an unknown name. */
enum species_part part_of_vertex(const char *name);

/* Returns the index of the vertex whose trajectory represents the part. The vertex is the root of a
 * fin's leading ray, the centre of a pupil, the tip of the tail's upper lobe, or, for the body, the
 * back where the body is deepest. For a pair, the vertex is on `side`. Returns vertex_count if the
 * fish lacks the part. */
uint32_t part_vertex_range(const struct species_mesh *mesh, enum species_part part,
                           enum species_side side);

/* Returns the position of a vertex at `progress` through life, in units of the species' measure. */
vec3 part_of_place(const struct species *species, const struct morph_rig *rig, uint32_t vertex,
                   float progress);

#endif
