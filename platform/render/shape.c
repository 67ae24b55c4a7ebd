/* shape.c -- builds the meshes of small solids as grids of vertices, and uploads the meshes. */
#include "platform/render/shape.h"

#include "core/base/panic.h"

#define NORMAL_STEP 1e-3f
/* Number of columns of a band. Two rows of a band fit into the vertex cache of V3D. */
#define BAND 16u

/* Appends the two triangles of the cell of a grid with the first corner `at`. */
static void add_cell(struct shape *shape, uint32_t at, uint32_t columns)
{
    const uint32_t corners[6] = { at,      at + 1u,           at + columns,
                                  at + 1u, at + columns + 1u, at + columns };
    for (uint32_t i = 0; i < 6; i++) {
        shape->indices[shape->index_count++] = (uint16_t)corners[i];
    }
}

void shape_grid(struct shape *shape, uint32_t columns, uint32_t rows, shape_point point,
                const void *context)
{
    CORE_ASSERT(columns >= 2 && rows >= 2);
    CORE_ASSERT(shape->vertex_count + columns * rows <= SHAPE_VERTEX_MAX);
    CORE_ASSERT(shape->index_count + (columns - 1u) * (rows - 1u) * 6u <= SHAPE_INDEX_MAX);
    const uint32_t first = shape->vertex_count;
    for (uint32_t row = 0; row < rows; row++) {
        for (uint32_t column = 0; column < columns; column++) {
            const float u = (float)column / (float)(columns - 1u);
            const float v = (float)row / (float)(rows - 1u);
            struct shape_vertex vertex = point(u, v, context);
            const float u0 = f_max(u - NORMAL_STEP, 0.0f);
            const float u1 = f_min(u + NORMAL_STEP, 1.0f);
            const float v0 = f_max(v - NORMAL_STEP, 0.0f);
            const float v1 = f_min(v + NORMAL_STEP, 1.0f);
            const vec3 along_u =
                v3_sub(point(u1, v, context).position, point(u0, v, context).position);
            const vec3 along_v =
                v3_sub(point(u, v1, context).position, point(u, v0, context).position);
            vertex.normal = v3_normalize_or(v3_cross(along_u, along_v), v3(0.0f, 1.0f, 0.0f));
            shape->vertices[shape->vertex_count++] = vertex;
        }
    }
    /* The triangles are ordered in bands of BAND columns, because a GPU computes a vertex again if
     * too many other vertices lie between two of its triangles. */
    const uint32_t cells = columns - 1u;
    for (uint32_t begin = 0; begin < cells; begin += BAND) {
        const uint32_t end = begin + BAND < cells ? begin + BAND : cells;
        for (uint32_t row = 0; row + 1 < rows; row++) {
            for (uint32_t column = begin; column < end; column++) {
                add_cell(shape, first + row * columns + column, columns);
            }
        }
    }
}

void shape_upload(const struct shape *shape, struct shape_buffers *buffers)
{
    CORE_ASSERT(shape->vertex_count > 0 && shape->index_count > 0);
    const size_t stride = sizeof(struct shape_vertex);
    glGenVertexArrays(1, &buffers->vertex_array);
    glBindVertexArray(buffers->vertex_array);
    buffers->vertex_buffer =
        gl_buffer(GL_ARRAY_BUFFER, shape->vertices, shape->vertex_count * stride);
    gl_attribute_floats(0, 3, stride, offsetof(struct shape_vertex, position));
    gl_attribute_floats(1, 3, stride, offsetof(struct shape_vertex, normal));
    gl_attribute_floats(2, 2, stride, offsetof(struct shape_vertex, u));
    buffers->index_buffer = gl_buffer(GL_ELEMENT_ARRAY_BUFFER, shape->indices,
                                      shape->index_count * sizeof *shape->indices);
    buffers->index_count = (GLsizei)shape->index_count;
    glBindVertexArray(0);
}

void shape_close(struct shape_buffers *buffers)
{
    const GLuint names[2] = { buffers->vertex_buffer, buffers->index_buffer };
    glDeleteVertexArrays(1, &buffers->vertex_array);
    glDeleteBuffers(2, names);
    *buffers = (struct shape_buffers){ 0 };
}

void shape_draw_range(const struct shape_buffers *buffers, uint32_t first, uint32_t end)
{
    CORE_ASSERT(first < end && end <= (uint32_t)buffers->index_count);
    glBindVertexArray(buffers->vertex_array);
    glDrawElements(GL_TRIANGLES, (GLsizei)(end - first), GL_UNSIGNED_SHORT,
                   (const void *)(first * sizeof(uint16_t)));
}

void shape_draw(const struct shape_buffers *buffers)
{
    shape_draw_range(buffers, 0, (uint32_t)buffers->index_count);
}
