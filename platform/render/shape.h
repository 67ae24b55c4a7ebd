/* shape.h -- builds small solids, such as the bowl, as meshes. The vertices are computed from
 * formulas when the renderer opens. */
#pragma once

#include "core/base/vec.h"
#include "platform/render/gl_util.h"

/* Maximum number of vertices. The bowl is the largest solid, with about 1,800 vertices. */
#define SHAPE_VERTEX_MAX 3072u
#define SHAPE_INDEX_MAX 16384u

struct shape_vertex {
    vec3 position, normal;
    float u, v;
};

/* Mesh under construction. The size of about 130 KiB is small enough for the stack of the function
 * that opens a pass. */
struct shape {
    uint32_t vertex_count, index_count;
    struct shape_vertex vertices[SHAPE_VERTEX_MAX];
    uint16_t indices[SHAPE_INDEX_MAX];
};

/* Mesh of a solid in OpenGL buffers. Vertex attribute 0 is the position, 1 the normal, 2 the
 * surface coordinates (u, v). */
struct shape_buffers {
    GLuint vertex_array, vertex_buffer, index_buffer;
    GLsizei index_count;
};

/* Returns the vertex of a surface at (u, v), each in [0, 1]. `context` is the last argument of
 * shape_grid(). */
typedef struct shape_vertex (*shape_point)(float u, float v, const void *context);
/* Appends a grid of `columns` x `rows` vertices, at least 2 of each, at the points that `point`
 * returns. Normals are computed from neighbouring points. Front faces are visible from the side on
 * which a turn from the direction of u to the direction of v is counter-clockwise. */
void shape_grid(struct shape *shape, uint32_t columns, uint32_t rows, shape_point point,
                const void *context);

void shape_upload(const struct shape *shape, struct shape_buffers *buffers);
void shape_close(struct shape_buffers *buffers);
/* Draws all triangles. */
void shape_draw(const struct shape_buffers *buffers);
/* Draws the triangles of the index buffer from position `first` to `end`, which is excluded. */
void shape_draw_range(const struct shape_buffers *buffers, uint32_t first, uint32_t end);
