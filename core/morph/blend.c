/* blend.c -- P = sum of V_i K_i: the 2005 thesis' eq. 3.2, for any number of key shapes.
 *
 * The renderer blends in the vertex shader; this is the same sum for whoever has no GPU. It goes
 * key by key, so that each pass streams through one array. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

static void blend(const vec3 *const keys[MORPH_KEY_MAX], uint32_t key_count,
                  const float weights[MORPH_KEY_MAX], uint32_t vertex_count, vec3 *out)
{
    for (uint32_t i = 0; i < vertex_count; i++) {
        out[i] = v3_scale(keys[0][i], weights[0]);
    }
    for (uint32_t key = 1; key < key_count; key++) {
        const vec3 *shape = keys[key];
        const float weight = weights[key];
        for (uint32_t i = 0; i < vertex_count; i++) {
            out[i] = v3_mad(out[i], shape[i], weight);
        }
    }
}

void morph_blend(const struct species_mesh *mesh, uint32_t key_count,
                 const float weights[MORPH_KEY_MAX], vec3 *positions, vec3 *normals)
{
    CORE_ASSERT(key_count >= 1 && key_count <= MORPH_KEY_MAX);
    if (positions) {
        blend(mesh->positions, key_count, weights, mesh->vertex_count, positions);
    }
    if (normals) {
        blend(mesh->normals, key_count, weights, mesh->vertex_count, normals);
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            normals[i] = v3_normalize_or(normals[i], v3(0.0f, 1.0f, 0.0f));
        }
    }
}
