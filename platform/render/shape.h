/* shape.h -- small solids, built from formulas when the renderer opens. */
#ifndef KINGYO_PLATFORM_RENDER_SHAPE_H
#define KINGYO_PLATFORM_RENDER_SHAPE_H

#include "core/base/vec.h"
#include "platform/render/gl_util.h"

#define SHAPE_VERTEX_MAX 3072u /* The bowl is the largest solid, with about 1,800 vertices. */
#define SHAPE_INDEX_MAX 16384u

struct shape_vertex {
    vec3 position, normal;
    float u, v;
};

/* Solid under construction, about 130 KiB, for the stack of an open function. */
struct shape {
    uint32_t vertex_count, index_count;
    struct shape_vertex vertices[SHAPE_VERTEX_MAX];
    uint16_t indices[SHAPE_INDEX_MAX];
};

/* Solid in OpenGL buffers: attribute 0 is the position, 1 the normal, 2 (u, v). */
struct shape_buffers {
    GLuint vertex_array, vertex_buffer, index_buffer;
    GLsizei index_count;
};

/* shape_grid() appends a grid of `columns` x `rows` vertices, >= 2 each, at the points that `point`
 * returns. Normals are computed from neighbouring points. A front face is one where columns turn
 * counter-clockwise into rows. */
typedef struct shape_vertex (*shape_point)(float u, float v, const void *context);
void shape_grid(struct shape *shape, uint32_t columns, uint32_t rows, shape_point point,
                const void *context);

void shape_upload(const struct shape *shape, struct shape_buffers *buffers);
void shape_close(struct shape_buffers *buffers);
void shape_draw(const struct shape_buffers *buffers);
/* Draws only `count` indices from `first` on. */
void shape_draw_part(const struct shape_buffers *buffers, uint32_t first, uint32_t count);

#endif
