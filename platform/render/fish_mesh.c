/* fish_mesh.c -- see fish_mesh.h. */
#include "platform/render/fish_mesh.h"

#include <stdlib.h>
#include <string.h>

#define KEY_SIZE sizeof(struct species_point)
#define SURFACE_SIZE 4u /* u, v, part, flex; */
#define RIDES_SIZE 4u   /* anchor, side, and two of padding. */
#define REST_SIZE (SURFACE_SIZE + MORPH_CURVE_MAX + RIDES_SIZE)

static uint8_t byte(float x)
{
    return (uint8_t)(f_clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

static void pack_vertex(uint8_t *out, const struct species_mesh *source, uint32_t key_count,
                        uint32_t index)
{
    for (uint32_t key = 0; key < key_count; key++, out += KEY_SIZE) {
        memcpy(out, &source->points[key][index], KEY_SIZE);
    }
    const struct species_vertex *const vertex = &source->vertices[index];
    const uint8_t rest[REST_SIZE] = {
        byte(vertex->u), byte(vertex->v), vertex->part,    vertex->flex,
        vertex->mask[0], vertex->mask[1], vertex->mask[2], vertex->mask[3],
        vertex->anchor,  vertex->side,
    };
    memcpy(out, rest, sizeof rest);
}

static bool is_fin(const struct species_mesh *source, uint32_t triangle)
{
    const uint8_t part = source->vertices[source->indices[triangle * 3u]].part;
    return part != PART_BODY && part != PART_EYE;
}

/* Copies the triangles that are (or are not) of fins; returns how many indices that made. */
static uint32_t gather(uint16_t *out, const struct species_mesh *source, bool fins)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < source->index_count / 3u; i++) {
        if (is_fin(source, i) == fins) {
            memcpy(out + count, source->indices + i * 3u, 3u * sizeof *out);
            count += 3u;
        }
    }
    return count;
}

static void describe_bytes(GLuint location, GLint count, GLboolean fraction, GLsizei stride,
                           size_t offset)
{
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_UNSIGNED_BYTE, fraction, stride,
                          (const void *)offset);
}

static void describe_vertex(uint32_t key_count)
{
    const size_t rest = key_count * KEY_SIZE;
    const GLsizei stride = (GLsizei)(rest + REST_SIZE);
    for (uint32_t key = 0; key < key_count; key++) {
        glEnableVertexAttribArray(key);
        glVertexAttribPointer(key, 4, GL_SHORT, GL_TRUE, stride,
                              (const void *)(size_t)(key * KEY_SIZE));
    }
    describe_bytes(FISH_ATTRIBUTE_SURFACE, 4, GL_TRUE, stride, rest);
    describe_bytes(FISH_ATTRIBUTE_MASKS, 4, GL_TRUE, stride, rest + SURFACE_SIZE);
    describe_bytes(FISH_ATTRIBUTE_RIDES, 2, GL_FALSE, stride,
                   rest + SURFACE_SIZE + MORPH_CURVE_MAX);
}

void fish_mesh_open(struct gl_status *status, struct fish_mesh *mesh,
                    const struct species_mesh *source, uint32_t key_count)
{
    const size_t stride = key_count * KEY_SIZE + REST_SIZE;
    uint8_t *const vertices = malloc(source->vertex_count * stride);
    uint16_t *const indices = malloc(source->index_count * sizeof *indices);
    if (!vertices || !indices) {
        gl_fail(status, "fish mesh: out of memory");
    } else {
        for (uint32_t i = 0; i < source->vertex_count; i++) {
            pack_vertex(vertices + i * stride, source, key_count, i);
        }
        const uint32_t body = gather(indices, source, false);
        const uint32_t fins = gather(indices + body, source, true);
        glGenVertexArrays(1, &mesh->vertex_array);
        glBindVertexArray(mesh->vertex_array);
        mesh->vertex_buffer = gl_buffer(GL_ARRAY_BUFFER, vertices, source->vertex_count * stride);
        describe_vertex(key_count);
        mesh->index_buffer =
            gl_buffer(GL_ELEMENT_ARRAY_BUFFER, indices, (body + fins) * sizeof *indices);
        mesh->body_index_count = (GLsizei)body;
        mesh->fin_index_count = (GLsizei)fins;
        mesh->reach = source->reach;
        glBindVertexArray(0);
    }
    free(vertices);
    free(indices);
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
    const size_t first = fins ? (size_t)mesh->body_index_count * sizeof(uint16_t) : 0u;
    glDrawElementsInstanced(GL_TRIANGLES, fins ? mesh->fin_index_count : mesh->body_index_count,
                            GL_UNSIGNED_SHORT, (const void *)first, instance_count);
}
