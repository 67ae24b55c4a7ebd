/* blend.c -- blends the key shapes of a fish on the CPU, one vertex at a time.
 *
 * A key shape (key) is one modelled growth stage. The blend is P = sum over the keys of V_i * K_i,
 * where V_i is the weight of key i, and K_i is the vertex's point in key i (2005 thesis, eq. 3.2).
 * The number of keys is not limited to the three keys of the thesis. The renderer computes the same
 * sum in the vertex shader from the same tables, and blend_lanes.c computes the sum for blocks of
 * vertices. */
#include "core/morph/morph.h"

#include <stddef.h>

#include "core/base/panic.h"
#include "core/morph/blend_lanes.h"

#define COUNTS 32767.0f

vec3 morph_position(const struct species_mesh *mesh, uint32_t key, uint32_t vertex)
{
    CORE_ASSERT(key < MORPH_KEY_MAX && vertex < mesh->vertex_count);
    const struct species_point *p = &mesh->points[key][vertex];
    const float step = mesh->reach / COUNTS;
    return v3((float)p->x * step, (float)p->y * step, (float)p->z * step);
}

/* Decodes a normal to a vector on the octahedron |x| + |y| + |z| = 127, which is not a unit vector.
 * The caller blends these vectors over all keys and normalises the sum once, because one
 * normalisation per vertex is cheaper than one per key. */
static vec3 unfold(int16_t folded)
{
    const int32_t code = (int32_t)folded + 32767;
    const float x = (float)((code >> 8) - 127), y = (float)((code & 255) - 127);
    const float z = 127.0f - f_abs(x) - f_abs(y);
    const float t = f_max(-z, 0.0f);
    return v3(x - (x >= 0.0f ? t : -t), y - (y >= 0.0f ? t : -t), z);
}

vec3 morph_normal(int16_t folded)
{
    const vec3 n = unfold(folded);
    return v3_scale(n, 1.0f / v3_length(n));
}

int16_t morph_count(float x, float reach)
{
    CORE_ASSERT(reach > 0.0f);
    const float counts = f_clamp(x / reach * COUNTS, -COUNTS, COUNTS);
    return (int16_t)(counts + (counts < 0.0f ? -0.5f : 0.5f));
}

/* Encodes a unit vector in 16 bits by octahedral encoding. The vector is projected onto the
 * octahedron |x| + |y| + |z| = 1, the octahedron is unfolded to a square, and both coordinates of
 * the square are quantised in steps of 1/127. The result is in [-32767, 32257], and a normalised
 * 16-bit vertex attribute represents it exactly. */
int16_t morph_fold_normal(vec3 n)
{
    const float sum = f_max(f_abs(n.x) + f_abs(n.y) + f_abs(n.z), 1e-6f);
    float x = n.x / sum;
    float y = n.y / sum;
    if (n.z < 0.0f) {
        const float flat_x = (1.0f - f_abs(y)) * (x >= 0.0f ? 1.0f : -1.0f);
        y = (1.0f - f_abs(x)) * (y >= 0.0f ? 1.0f : -1.0f);
        x = flat_x;
    }
    const int32_t high = (int32_t)((x + 1.0f) * 127.0f + 0.5f);
    const int32_t low = (int32_t)((y + 1.0f) * 127.0f + 0.5f);
    return (int16_t)(high * 256 + low - 32767);
}

/* Returns the weight of a key for one vertex: the mean of the key's weights in all curves, weighted
 * by the masks of the vertex. The masks are integers, and the sum is scaled afterwards. Therefore a
 * key with the weight 1 in all curves gets exactly the weight 1. */
static float vertex_weight(const struct species_vertex *vertex, const struct morph_pose *pose,
                           uint32_t key)
{
    float sum = 0.0f;
    if (vertex->mask[0] == 255) {
        return pose->weight[0][key];
    }
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        sum += pose->weight[curve][key] * (float)vertex->mask[curve];
    }
    return sum * (1.0f / 255.0f); /* In float arithmetic, 255 * (1.0f / 255.0f) is exactly 1. */
}

/* Returns the blended position of a vertex. If `facing` is not null, adds the blended normal of the
 * vertex to `facing`. */
static vec3 blend_vertex(const struct species_mesh *mesh, uint32_t key_count,
                         const struct morph_pose *pose, uint32_t vertex, vec3 *facing)
{
    vec3 counts = { 0.0f, 0.0f, 0.0f };
    CORE_ASSERT(vertex < mesh->vertex_count);
    for (uint32_t key = 0; key < key_count; key++) {
        const float weight = vertex_weight(&mesh->vertices[vertex], pose, key);
        if (weight != 0.0f) {
            const struct species_point *p = &mesh->points[key][vertex];
            counts = v3_muladd(counts, v3((float)p->x, (float)p->y, (float)p->z), weight);
            if (facing) {
                *facing = v3_muladd(*facing, unfold(p->normal), weight);
            }
        }
    }
    return v3_scale(counts, mesh->reach / COUNTS);
}

vec3 morph_place(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 uint32_t vertex)
{
    return blend_vertex(mesh, key_count, pose, vertex, NULL);
}

struct morph_point morph_point(const struct species_mesh *mesh, uint32_t key_count,
                               const struct morph_pose *pose, uint32_t vertex)
{
    vec3 normal = { 0.0f, 0.0f, 0.0f };
    const vec3 position = blend_vertex(mesh, key_count, pose, vertex, &normal);
    return (struct morph_point){ position, v3_normalize_or(normal, v3(0.0f, 1.0f, 0.0f)) };
}

void blend_each(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                uint32_t first, vec3 *positions, vec3 *normals)
{
    CORE_ASSERT(first <= mesh->vertex_count && mesh->anchor_count <= ANCHOR_MAX);
    for (uint32_t i = first; i < mesh->vertex_count; i++) {
        const uint8_t anchor = mesh->vertices[i].anchor;
        struct morph_point point = morph_point(mesh, key_count, pose, i);
        if (anchor != ANCHOR_NONE) {
            CORE_ASSERT(anchor < mesh->anchor_count);
            const struct anchor_pose *at = &pose->anchor[anchor];
            point.position = v3_add(at->position, pose_rotate(at->turn, point.position));
            point.normal = pose_rotate(at->turn, point.normal);
        }
        if (positions) {
            positions[i] = point.position;
        }
        if (normals) {
            normals[i] = point.normal;
        }
    }
}

void morph_shape(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 vec3 *positions, vec3 *normals)
{
    CORE_ASSERT(key_count >= 1 && key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(mesh->vertex_count <= MESH_VERTEX_MAX && mesh->reach > 0.0f);
    const uint32_t done = blend_blocks(mesh, key_count, pose, positions, normals);
    blend_each(mesh, key_count, pose, done, positions, normals);
}
