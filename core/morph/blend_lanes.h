/* blend_lanes.h -- blends four vertices at a time for morph_shape() (core/base/simd.h).
 * Internal to core/morph. */
#pragma once

#include "core/base/simd.h"
#include "core/morph/morph.h"

/* Blends blocks of four vertices, beginning with vertex 0. At least one vertex at the end is not
 * blended. Returns the index of the first vertex that is not blended. */
uint32_t blend_blocks(const struct species_mesh *mesh, uint32_t key_count,
                      const struct morph_pose *pose, vec3 *positions, vec3 *normals);

/* Blends the vertices from index `first` to the end, one at a time. */
void blend_each(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                uint32_t first, vec3 *positions, vec3 *normals);
