/* part.h -- part names, and the vertex that represents each part. Pure functions. */
#ifndef KINGYO_PLATFORM_SPECIES_PART_H
#define KINGYO_PLATFORM_SPECIES_PART_H

#include "core/morph/morph.h"

/* Returns the enum species_part of a maker's name such as "dorsal2", or PART_COUNT. */
enum species_part part_of_vertex(const char *name);

/* Returns the vertex whose trajectory represents the part: the root of a fin's leading ray, the
 * centre of a pupil, the tip of the tail's upper lobe, the back where the body is deepest. For a
 * pair, the vertex of `side`. Returns vertex_count if the fish lacks the part. */
uint32_t part_vertex_range(const struct species_mesh *mesh, enum species_part part,
                           enum species_side side);

/* Returns that vertex's position at `progress`, in the species' measure. */
vec3 part_of_place(const struct species *species, const struct morph_rig *rig, uint32_t vertex,
                   float progress);

#endif
