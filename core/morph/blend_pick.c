/* blend_pick.c -- calls the SIMD blend for the number of lanes that the caller requests.
 *
 * The caller must request a number of lanes that the processor supports, because the core does not
 * detect processor features. */
#include "core/base/panic.h"
#include "core/morph/blend_simd.h"

void morph_shape_lanes(const struct species_mesh *mesh, uint32_t key_count,
                       const struct morph_pose *pose, vec3 *positions, vec3 *normals,
                       uint32_t lanes)
{
    uint32_t done = 0;
    CORE_ASSERT(key_count >= 1 && key_count <= MORPH_KEY_MAX);
    if (lanes > 1) {
        done = SIMD_PICK(lanes, blend_blocks)(mesh, key_count, pose, positions, normals);
    }
    blend_each(mesh, key_count, pose, done, positions, normals);
}
