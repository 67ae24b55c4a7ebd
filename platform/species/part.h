/* part.h -- parts by their names, and the vertex that stands for each. Pure. */
#ifndef KINGYO_PLATFORM_SPECIES_PART_H
#define KINGYO_PLATFORM_SPECIES_PART_H

#include "core/morph/morph.h"

/* As makers write it: "dorsal2". enum species_part, or PART_COUNT. */
enum species_part morph_part_of(const char *name);

/* The vertex whose path is the part's: where a fin's leading ray is rooted, the middle of a pupil,
 * the tip of the tail's upper lobe, the body's back where it is deepest. Of a pair, that of `side`.
 * vertex_count where the fish has no such part. */
uint32_t morph_part_vertex(const struct species_mesh *mesh, enum species_part part,
                           enum species_side side);

/* Where that vertex is at `progress`, in the species' measure. */
vec3 morph_part_place(const struct species *species, const struct morph_rig *rig, uint32_t vertex,
                      float progress);

#endif
