/* fish_mesh.c -- packs the meshes of fish into OpenGL buffers, and the poses of fish into a
 * texture. */
#include "platform/render/fish_mesh.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/render/paint_atlas.h"

#define KEY_SIZE sizeof(struct species_point)
/* Size in bytes of the vertex attribute with the surface coordinates u and v, the body part and the
 * flexibility of the vertex. */
#define SURFACE_SIZE 4u
/* Size in bytes of the vertex attribute with the anchor (the point of the skin to which the vertex
 * is attached), the side of the body, the flag of is_snout_end(), and one byte of padding. */
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

static void pack_vertex(uint8_t *out, const struct species_mesh *source, uint32_t key_count,
                        uint32_t index)
{
    CORE_ASSERT(index < source->vertex_count && key_count <= MORPH_KEY_MAX);
    for (uint32_t key = 0; key < key_count; key++, out += KEY_SIZE) {
        memcpy(out, &source->points[key][index], KEY_SIZE);
    }
    const struct species_vertex *const vertex = &source->vertices[index];
    uint8_t rest[BYTES_SIZE] = { paint_atlas_byte(vertex->u), paint_atlas_byte(vertex->v),
                                 vertex->part, vertex->flex };
    memcpy(rest + SURFACE_SIZE, vertex->mask, MORPH_CURVE_MAX);
    rest[SURFACE_SIZE + MORPH_CURVE_MAX] = vertex->anchor;
    rest[SURFACE_SIZE + MORPH_CURVE_MAX + 1u] = vertex->side;
    rest[SURFACE_SIZE + MORPH_CURVE_MAX + 2u] = is_snout_end(source, index);
    float uv[2];
    paint_atlas_find(vertex, uv);
    const uint16_t paint[2] = { (uint16_t)(uv[0] * 65535.0f + 0.5f),
                                (uint16_t)(uv[1] * 65535.0f + 0.5f) };
    memcpy(out, rest, sizeof rest);
    memcpy(out + sizeof rest, paint, sizeof paint);
}

/* Copies the triangles of the fins if `fins` is true, otherwise the triangles of the body and the
 * eyes. Returns the number of indices written. */
static uint32_t gather(uint16_t *out, const struct species_mesh *source, bool fins)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < source->index_count / 3u; i++) {
        const uint8_t part = source->vertices[source->indices[i * 3u]].part;
        if ((part != PART_BODY && part != PART_EYE) == fins) {
            memcpy(out + count, source->indices + i * 3u, 3u * sizeof *out);
            count += 3u;
        }
    }
    return count;
}

void fish_mesh_reserve(struct fish_mesh *mesh)
{
    glGenVertexArrays(1, &mesh->vertex_array);
    glGenBuffers(1, &mesh->vertex_buffer);
    glGenBuffers(1, &mesh->index_buffer);
}

void fish_mesh_fill(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                    const struct species_mesh *source, uint32_t key_count)
{
    CORE_ASSERT(key_count > 0);
    const size_t rest = key_count * KEY_SIZE, stride = rest + REST_SIZE;
    CORE_ASSERT(key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(source->vertex_count <= MESH_VERTEX_MAX && source->index_count <= MESH_INDEX_MAX);
    for (uint32_t i = 0; i < source->vertex_count; i++) {
        pack_vertex(memory->vertices + i * stride, source, key_count, i);
    }
    const uint32_t body = gather(memory->indices, source, false);
    const uint32_t fins = gather(memory->indices + body, source, true);
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
    gl_attribute_bytes(FISH_ATTRIBUTE_RIDES, 3, false, stride,
                       rest + SURFACE_SIZE + MORPH_CURVE_MAX);
    glEnableVertexAttribArray(FISH_ATTRIBUTE_PAINT);
    glVertexAttribPointer(FISH_ATTRIBUTE_PAINT, 2, GL_UNSIGNED_SHORT, GL_TRUE, (GLsizei)stride,
                          (const void *)(rest + BYTES_SIZE));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->index_buffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)((body + fins) * sizeof *memory->indices),
                 memory->indices, GL_STATIC_DRAW);
    mesh->body_index_count = (GLsizei)body;
    mesh->fin_index_count = (GLsizei)fins;
    mesh->reach = source->reach;
    glBindVertexArray(0);
}

void fish_mesh_close(struct fish_mesh *mesh)
{
    const GLuint names[2] = { mesh->vertex_buffer, mesh->index_buffer };
    glDeleteVertexArrays(1, &mesh->vertex_array);
    glDeleteBuffers(2, names);
    *mesh = (struct fish_mesh){ 0 };
}

void fish_mesh_draw(const struct fish_mesh *mesh, bool fins, GLsizei instance_count)
{
    CORE_ASSERT(instance_count > 0);
    const size_t first = fins ? (size_t)mesh->body_index_count * sizeof(uint16_t) : 0u;
    glDrawElementsInstanced(GL_TRIANGLES, fins ? mesh->fin_index_count : mesh->body_index_count,
                            GL_UNSIGNED_SHORT, (const void *)first, instance_count);
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

/* Returns the value of the macro ANCHORS for morph.glsl. 0 means that no vertex has an anchor. 1
 * means that vertices have anchors and that no anchor rotates with the skin. 2 means that at least
 * one anchor rotates. */
static uint32_t riding(const struct species_mesh *mesh, bool fins)
{
    uint32_t most = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *const vertex = &mesh->vertices[i];
        if (vertex->anchor != ANCHOR_NONE && (!fins || vertex->part >= PART_TAIL)) {
            const uint32_t rides = mesh->anchors[vertex->anchor].turns ? 2u : 1u;
            most = rides > most ? rides : most;
        }
    }
    return most;
}

void fish_poses_defines(char *out, size_t size, const struct species *species, bool fins)
{
    CORE_ASSERT(size > 0);
    const uint32_t near = riding(&species->lod[0], fins), far = riding(&species->lod[1], fins);
    snprintf(out, size,
             "#define POSE_ROWS\n#define KEYS %u\n#define CURVES %u\n#define ANCHORS %u\n",
             species->card.key_count, species->card.curve_count, near > far ? near : far);
}

_Static_assert(SCENE_FISH_MAX <= GL_TEXTURE_SURE && POSE_TEXELS_MAX <= GL_TEXTURE_SURE,
               "a row for each fish, on every driver");

void fish_poses_open(struct gl_status *status, struct fish_poses *poses,
                     const struct species *species, uint32_t lod)
{
    CORE_ASSERT(species->card.curve_count <= MORPH_CURVE_MAX);
    CORE_ASSERT(lod < SPECIES_LOD_COUNT);
    poses->mesh = &species->lod[lod];
    poses->curve_count = species->card.curve_count;
    poses->width = 2u * poses->curve_count + 2u * poses->mesh->anchor_count;
    for (uint32_t i = 0; i < SCENE_FISH_MAX; i++) {
        poses->progress[i] = -1.0f;
    }
    poses->texture = gl_texture(status, "poses",
                                &(struct gl_texture_desc){ .internal_format = GL_RGBA32F,
                                                           .width = poses->width,
                                                           .height = SCENE_FISH_MAX,
                                                           .nearest = true });
}

void fish_poses_close(struct fish_poses *poses)
{
    glDeleteTextures(1, &poses->texture);
}

void fish_poses_end(struct fish_poses *poses)
{
    CORE_ASSERT(poses->run_count <= POSE_RUN);
    if (poses->run_count > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, (GLint)poses->run_first, (GLsizei)poses->width,
                        (GLsizei)poses->run_count, GL_RGBA, GL_FLOAT, poses->run);
        poses->run_count = 0;
    }
}

void fish_poses_begin(struct fish_poses *poses)
{
    poses->run_count = poses->posed_count = 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_bind_texture(0, GL_TEXTURE_2D, poses->texture);
}

void fish_poses_set(struct fish_poses *poses, const struct morph_rig *rig, uint32_t row,
                    float progress)
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    CORE_ASSERT(row < SCENE_FISH_MAX);
    if (poses->progress[row] == progress) {
        return;
    }
    if (poses->run_count == POSE_RUN || row != poses->run_first + poses->run_count) {
        fish_poses_end(poses);
    }
    if (poses->run_count == 0) {
        poses->run_first = row;
    }
    morph_pose(rig, poses->mesh, progress, &poses->pose);
    fish_poses_pack(poses->run + poses->run_count * poses->width, &poses->pose, poses->curve_count,
                    poses->mesh->anchor_count);
    poses->progress[row] = progress;
    poses->run_count++;
    poses->posed_count++;
}
