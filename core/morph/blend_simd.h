/* blend_simd.h -- morph_shape() for LANES vertices at once; see core/base/simd.h. */
#ifndef KINGYO_CORE_MORPH_BLEND_SIMD_H
#define KINGYO_CORE_MORPH_BLEND_SIMD_H

#include "core/base/simd.h"
#include "core/morph/morph.h"

SIMD_BEGIN
/* Blends whole blocks from vertex 0 on, but never the last vertices. Returns the index of the first
 * vertex that is left. */
uint32_t blend_blocks_4(const struct species_mesh *mesh, uint32_t key_count,
                        const struct morph_pose *pose, vec3 *positions, vec3 *normals);
uint32_t blend_blocks_8(const struct species_mesh *mesh, uint32_t key_count,
                        const struct morph_pose *pose, vec3 *positions, vec3 *normals);

/* Blends the vertices from `first` on, one by one. */
void blend_each(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                uint32_t first, vec3 *positions, vec3 *normals);
SIMD_END

#endif
