/* fish_mesh.h -- a species' key shapes, packed into the vertex attributes of morph.glsl.
 *
 * Eight bytes a key and vertex, as species.h has them: position in three 16-bit fractions of the
 * mesh's reach, normal folded on an octahedron in 16 bits. So eight keys fit beside the instance's
 * attributes in the sixteen that OpenGL ES 3.0 promises. */
#ifndef KINGYO_PLATFORM_RENDER_FISH_MESH_H
#define KINGYO_PLATFORM_RENDER_FISH_MESH_H

#include "core/morph/species.h"
#include "platform/render/gl_util.h"

enum fish_attribute { /* As in assets/shaders: keys are 0 .. 7, instances take what is left. */
                      FISH_ATTRIBUTE_SURFACE = 8,
                      FISH_ATTRIBUTE_PAINT = 9, /* Of specimens; the tank's fish wear patterns. */
                      FISH_ATTRIBUTE_MASKS = 12,
                      FISH_ATTRIBUTE_RIDES = 13,
};

/* Of eight keys: a point each, then surface, masks, what it rides on, and where its paint is. */
#define FISH_VERTEX_SIZE_MAX (MORPH_KEY_MAX * sizeof(struct species_point) + 16u)

/* One level of detail: body and eyes first, then fins, in one index buffer. */
struct fish_mesh {
    GLuint vertex_array, vertex_buffer, index_buffer;
    GLsizei body_index_count, fin_index_count;
    float reach; /* For the uniform of that name. */
};

/* Where a mesh is packed on its way to the GPU; the caller's, and only while it is filled. */
struct fish_mesh_memory {
    uint8_t vertices[MESH_VERTEX_MAX * FISH_VERTEX_SIZE_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* reserve() makes a mesh's names, fill() (as often as one likes) gives it a shape. */
void fish_mesh_reserve(struct fish_mesh *mesh);
void fish_mesh_fill(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                    const struct species_mesh *source, uint32_t key_count);
void fish_mesh_close(struct fish_mesh *mesh);

/* Draws `instance_count` fish with the bound program and instance attributes. */
void fish_mesh_draw(const struct fish_mesh *mesh, bool fins, GLsizei instance_count);

#endif
