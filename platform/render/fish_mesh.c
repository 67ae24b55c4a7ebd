/* fish_mesh.c -- packs the meshes of fish into OpenGL buffers, and poses into texels. */
#include "platform/render/fish_mesh.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/render/paint_atlas.h"

#define KEY_SIZE sizeof(struct species_point)
/* Size in bytes of the vertex attribute with the surface coordinates u and v, the body part and the
 * flexibility of the vertex. */
#define SURFACE_SIZE 4u
/* Size in bytes of the vertex attribute with the anchor (the point of the skin to which the vertex
 * is attached), the side of the body, and the two bytes of pack_mouth(). */
#define RIDES_SIZE 4u
/* Size in bytes of the vertex attribute with the paint coordinates, which are two 16-bit
 * fractions. */
#define PAINT_SIZE_BYTES 4u
#define BYTES_SIZE (SURFACE_SIZE + MORPH_CURVE_MAX + RIDES_SIZE)
#define REST_SIZE (BYTES_SIZE + PAINT_SIZE_BYTES)
_Static_assert(MORPH_KEY_MAX *KEY_SIZE + REST_SIZE == FISH_VERTEX_SIZE_MAX, "as fish_mesh.h");

/* Returns true for the vertex that closes the snout, which lies on the axis of the body. The first
 * ring of vertices around the mouth has the same body coordinate, but its normals point outward. */
static bool is_snout_end(const struct species_mesh *source, uint32_t index)
{
    const struct species_vertex *const vertex = &source->vertices[index];
    return vertex->part == PART_BODY && vertex->u <= 0.002f &&
           morph_normal(source->points[0][index].normal).z <= -0.95f;
}

/* Length of the moving part of the mouth, in the body coordinate u. */
#define JAWS 0.080f
/* Distances, in body lengths, by which an opening mouth moves its parts: the upper lip upward, the
 * lower lip downward, both lips forward, and the vertex that closes the snout backward. */
#define UPPER_LIP 0.010f
#define LOWER_LIP 0.022f
#define PROTRUSION 0.014f
#define THROAT 0.042f
/* Value of a byte of pack_mouth() that stands for no motion, and number of steps from there to the
 * largest motion. */
#define MOUTH_REST 128.0f
#define MOUTH_STEPS 127.0f

/* Writes the motion of a vertex when the mouth opens completely: forward in units of THROAT, and
 * upward in units of LOWER_LIP. A carp's mouth protrudes and its lower jaw drops. The vertex that
 * closes the snout moves backward and becomes the throat. It is the only vertex that moves
 * backward. */
static void pack_mouth(uint8_t out[2], const struct species_mesh *source, uint32_t index)
{
    const struct species_vertex *const vertex = &source->vertices[index];
    const bool is_end = is_snout_end(source, index);
    const float lips =
        vertex->part == PART_BODY ? 1.0f - f_smoothstep(0.0f, JAWS, vertex->u) : 0.0f;
    const float under = 1.0f - f_abs(vertex->v * 2.0f - 1.0f);
    const float rise =
        is_end ? 0.0f : lips * f_lerp(UPPER_LIP, -LOWER_LIP, f_smoothstep(0.30f, 0.70f, under));
    const float forward = lips * (is_end ? -THROAT : PROTRUSION);
    out[0] = (uint8_t)(MOUTH_REST + forward / THROAT * MOUTH_STEPS + 0.5f);
    out[1] = (uint8_t)(MOUTH_REST + rise / LOWER_LIP * MOUTH_STEPS + 0.5f);
}

/* Writes the weights with which fish.vert.glsl colours a vertex: of the belly, of the bright ridge
 * of the back and of the gill cover's edge, each 0 to 255, and 255 for an eye. */
static void pack_weights(uint8_t out[MORPH_CURVE_MAX], const struct species_vertex *vertex)
{
    const float under = 1.0f - f_abs(vertex->v * 2.0f - 1.0f); /* 0 at the back, 1 at the belly. */
    const float belly = f_smoothstep(0.36f, 0.92f, under);
    const float ridge =
        (1.0f - f_smoothstep(0.0f, 0.42f, under)) * f_smoothstep(0.0f, 0.12f, vertex->u);
    const float gill = f_smoothstep(0.15f, 0.35f, under) * (1.0f - 0.6f * belly);
    const bool is_eye = vertex->part != PART_BODY;
    out[0] = paint_atlas_byte(belly);
    out[1] = is_eye ? 0 : paint_atlas_byte(ridge);
    out[2] = is_eye ? 0 : paint_atlas_byte(gill);
    out[3] = is_eye ? UINT8_MAX : 0;
}

/* Writes a vertex to `out`. A fish of the tank has the bytes of pack_weights() in place of the
 * masks, because its shape is blended on the CPU. */
static void pack_vertex(uint8_t *out, const struct species_mesh *source, uint32_t key_count,
                        uint32_t index, bool is_tank)
{
    CORE_ASSERT(index < source->vertex_count && key_count <= MORPH_KEY_MAX);
    for (uint32_t key = 0; key < key_count; key++, out += KEY_SIZE) {
        memcpy(out, &source->points[key][index], KEY_SIZE);
    }
    const struct species_vertex *const vertex = &source->vertices[index];
    uint8_t rest[BYTES_SIZE] = { paint_atlas_byte(vertex->u), paint_atlas_byte(vertex->v),
                                 vertex->part, vertex->flex };
    memcpy(rest + SURFACE_SIZE, vertex->mask, MORPH_CURVE_MAX);
    if (is_tank) {
        pack_weights(rest + SURFACE_SIZE, vertex);
        /* An eye has the v of the belly, where the pattern has no scales. */
        rest[1] = vertex->part == PART_EYE ? UINT8_MAX / 2u : rest[1];
    }
    rest[SURFACE_SIZE + MORPH_CURVE_MAX] = vertex->anchor;
    rest[SURFACE_SIZE + MORPH_CURVE_MAX + 1u] = vertex->side;
    pack_mouth(rest + SURFACE_SIZE + MORPH_CURVE_MAX + 2u, source, index);
    float uv[2];
    paint_atlas_find(vertex, uv);
    const uint16_t paint[2] = { (uint16_t)(uv[0] * 65535.0f + 0.5f),
                                (uint16_t)(uv[1] * 65535.0f + 0.5f) };
    memcpy(out, rest, sizeof rest);
    memcpy(out + sizeof rest, paint, sizeof paint);
}

/* Body coordinate u of an eye's vertex below which the vertex belongs to the front half. */
#define EYE_FRONT 0.75f

static bool is_fin(uint8_t part)
{
    return part != PART_BODY && part != PART_EYE;
}

/* Copies the triangles of the fins if `fins` is true, otherwise the triangles of the body and the
 * eyes. Returns the number of indices written. */
static uint32_t gather(uint16_t *out, const struct species_mesh *source, bool fins)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < source->index_count / 3u; i++) {
        if (is_fin(source->vertices[source->indices[i * 3u]].part) == fins) {
            memcpy(out + count, source->indices + i * 3u, 3u * sizeof *out);
            count += 3u;
        }
    }
    return count;
}

/* Number of preceding triangles among which a triangle of a fin has its other side. */
#define SIDES_APART 2u

/* Removes the triangles with the same vertices as a preceding triangle, which are the other sides
 * of fins, and the triangles without an area. Returns the number of remaining indices. */
static uint32_t remove_sides(uint16_t *indices, uint32_t count)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < count; i += 3u) {
        const uint16_t *const t = indices + i;
        bool is_spare = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        for (uint32_t k = kept > 3u * SIDES_APART ? kept - 3u * SIDES_APART : 0; k < kept;
             k += 3u) {
            const uint16_t *const other = indices + k;
            is_spare |= t[0] == other[0] && t[1] == other[2] && t[2] == other[1];
        }
        if (!is_spare) {
            memmove(indices + kept, t, 3u * sizeof *indices);
            kept += 3u;
        }
    }
    return kept;
}

/* Returns the vertex that replaces vertex `index` in the mesh of a small fish. The mesh keeps every
 * second spoke of the body, every second ray of the dorsal fin, and the ends of the tail's rays. */
static uint16_t small_vertex(const struct species_mesh *source, uint16_t index)
{
    const struct species_vertex *const all = source->vertices;
    const struct species_vertex *const vertex = &all[index];
    const uint32_t row = source->grid_spokes + 1u;
    if (vertex->part == PART_BODY) {
        const uint32_t at = index - source->grid_first;
        const bool is_odd =
            index >= source->grid_first && at < source->grid_rings * row && at % row % 2u == 1u;
        return (uint16_t)(index - is_odd);
    }
    /* The vertices of a fin are consecutive, ray by ray. All vertices of a ray have the same u. */
    uint32_t first = index, ray_first = index, end = index;
    while (first > 0 && all[first - 1u].part == vertex->part) {
        first--;
    }
    while (ray_first > first && all[ray_first - 1u].u == vertex->u) {
        ray_first--;
    }
    while (end < source->vertex_count && all[end].part == vertex->part && all[end].u == vertex->u) {
        end++;
    }
    const uint32_t length = end - ray_first;
    CORE_ASSERT(length > 0);
    if (vertex->part == PART_TAIL && index + 1u < end) {
        return (uint16_t)ray_first;
    }
    if (vertex->part == PART_DORSAL && (ray_first - first) / length % 2u == 1u) {
        return (uint16_t)(index - length);
    }
    return index;
}

/* Returns true if a triangle with the vertex belongs to the mesh of a small fish. The rear half of
 * an eye and the fins below the body do not. */
static bool is_in_small(const struct species_vertex *vertex)
{
    return vertex->part == PART_EYE ? vertex->u < EYE_FRONT
                                    : vertex->part != PART_ANAL && vertex->part != PART_PELVIC;
}

/* Copies the triangles of the mesh for small fish. Returns the number of indices written. */
static uint32_t gather_small(uint16_t *out, const struct species_mesh *source, bool fins)
{
    const uint32_t count = gather(out, source, fins);
    uint32_t kept = 0;
    for (uint32_t i = 0; i < count; i += 3u) {
        bool is_kept = true;
        for (uint32_t k = 0; k < 3; k++) {
            is_kept = is_kept && is_in_small(&source->vertices[out[i + k]]);
            out[kept + k] = small_vertex(source, out[i + k]);
        }
        kept += is_kept ? 3u : 0u;
    }
    return remove_sides(out, kept);
}

void fish_mesh_reserve(struct fish_mesh *mesh)
{
    glGenVertexArrays(1, &mesh->vertex_array);
    glGenBuffers(1, &mesh->vertex_buffer);
    glGenBuffers(1, &mesh->index_buffer);
}

/* Uploads the mesh `source`, and the lists of triangles in memory->indices, whose lengths are in
 * mesh->index_counts. `is_tank` is true for a fish of the tank. */
static void upload(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                   const struct species_mesh *source, uint32_t key_count, bool is_tank)
{
    CORE_ASSERT(key_count > 0 && key_count <= MORPH_KEY_MAX);
    const size_t rest = key_count * KEY_SIZE, stride = rest + REST_SIZE;
    size_t index_count = 0;
    for (uint32_t i = 0; i < FISH_TRIANGLES_COUNT; i++) {
        index_count += (size_t)mesh->index_counts[i];
    }
    CORE_ASSERT(source->vertex_count <= MESH_VERTEX_MAX);
    for (uint32_t i = 0; i < source->vertex_count; i++) {
        pack_vertex(memory->vertices + i * stride, source, key_count, i, is_tank);
    }
    glBindVertexArray(mesh->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, mesh->vertex_buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(source->vertex_count * stride), memory->vertices,
                 GL_STATIC_DRAW);
    /* A species may have fewer key shapes (modelled growth stages) than the shader has attributes.
     * The loop disables the remaining attributes. The shader reads a disabled attribute as a
     * constant, and gives it the weight 0. */
    for (uint32_t key = key_count; key < MORPH_KEY_MAX; key++) {
        glDisableVertexAttribArray(key);
    }
    for (uint32_t key = 0; key < key_count; key++) {
        glEnableVertexAttribArray(key);
        glVertexAttribPointer(key, 4, GL_SHORT, GL_TRUE, (GLsizei)stride,
                              (const void *)(size_t)(key * KEY_SIZE));
    }
    gl_attribute_bytes(FISH_ATTRIBUTE_SURFACE, 4, true, stride, rest);
    gl_attribute_bytes(FISH_ATTRIBUTE_MASKS, 4, true, stride, rest + SURFACE_SIZE);
    gl_attribute_bytes(FISH_ATTRIBUTE_RIDES, 4, false, stride,
                       rest + SURFACE_SIZE + MORPH_CURVE_MAX);
    glEnableVertexAttribArray(FISH_ATTRIBUTE_PAINT);
    glVertexAttribPointer(FISH_ATTRIBUTE_PAINT, 2, GL_UNSIGNED_SHORT, GL_TRUE, (GLsizei)stride,
                          (const void *)(rest + BYTES_SIZE));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->index_buffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(index_count * sizeof *memory->indices),
                 memory->indices, GL_STATIC_DRAW);
    mesh->reach = source->reach;
    glBindVertexArray(0);
}

void fish_mesh_fill(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                    const struct species_mesh *source, uint32_t key_count)
{
    CORE_ASSERT(source->index_count <= MESH_INDEX_MAX);
    const uint32_t body = gather(memory->indices, source, false);
    const uint32_t fins = gather(memory->indices + body, source, true);
    memset(mesh->index_counts, 0, sizeof mesh->index_counts);
    mesh->index_counts[FISH_BODY] = (GLsizei)body;
    mesh->index_counts[FISH_FINS] = (GLsizei)fins;
    upload(mesh, memory, source, key_count, false);
}

void fish_mesh_fill_tank(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                         const struct species_mesh *source, uint32_t key_count)
{
    uint32_t first = 0;
    for (enum fish_triangles list = 0; list < FISH_TRIANGLES_COUNT; list++) {
        uint16_t *const out = memory->indices + first;
        const bool fins = list == FISH_FINS || list == FISH_SMALL_FINS;
        CORE_ASSERT(first + source->index_count <= 2u * MESH_INDEX_MAX);
        const uint32_t count = list < FISH_SMALL_BODY ? remove_sides(out, gather(out, source, fins))
                                                      : gather_small(out, source, fins);
        mesh->index_counts[list] = (GLsizei)count;
        first += count;
    }
    upload(mesh, memory, source, key_count, true);
}

void fish_mesh_close(struct fish_mesh *mesh)
{
    const GLuint names[2] = { mesh->vertex_buffer, mesh->index_buffer };
    glDeleteVertexArrays(1, &mesh->vertex_array);
    glDeleteBuffers(2, names);
    *mesh = (struct fish_mesh){ 0 };
}

void fish_mesh_draw(const struct fish_mesh *mesh, enum fish_triangles triangles,
                    GLsizei instance_count)
{
    CORE_ASSERT(instance_count > 0 && triangles < FISH_TRIANGLES_COUNT);
    size_t first = 0;
    for (uint32_t i = 0; i < triangles; i++) {
        first += (size_t)mesh->index_counts[i];
    }
    glDrawElementsInstanced(GL_TRIANGLES, mesh->index_counts[triangles], GL_UNSIGNED_SHORT,
                            (const void *)(first * sizeof(uint16_t)), instance_count);
}

uint32_t fish_poses_pack(float out[][4], const struct morph_pose *pose, uint32_t curve_count,
                         uint32_t anchor_count)
{
    CORE_ASSERT(curve_count <= MORPH_CURVE_MAX);
    CORE_ASSERT(anchor_count <= ANCHOR_MAX);
    uint32_t at = 0;
    for (uint32_t i = 0; i < curve_count; i++, at += 2) {
        memcpy(out[at], pose->weight[i], 2 * sizeof *out);
    }
    for (uint32_t i = 0; i < anchor_count; i++, at += 2) {
        const struct anchor_pose *const anchor = &pose->anchor[i];
        const float texels[2][4] = {
            { anchor->position.x, anchor->position.y, anchor->position.z, 0.0f },
            { anchor->turn.x, anchor->turn.y, anchor->turn.z, anchor->turn.w },
        };
        memcpy(out[at], texels, sizeof texels);
    }
    return at;
}
