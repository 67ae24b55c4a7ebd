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
                      FISH_ATTRIBUTE_MASKS = 12,
                      FISH_ATTRIBUTE_RIDES = 13,
};

/* One level of detail: body and eyes first, then fins, in one index buffer. */
struct fish_mesh {
    GLuint vertex_array, vertex_buffer, index_buffer;
    GLsizei body_index_count, fin_index_count;
    float reach; /* For the uniform of that name. */
};

void fish_mesh_open(struct gl_status *status, struct fish_mesh *mesh,
                    const struct species_mesh *source, uint32_t key_count);
void fish_mesh_close(struct fish_mesh *mesh);

/* Draws `instance_count` fish with the bound program and instance attributes. */
void fish_mesh_draw(const struct fish_mesh *mesh, bool fins, GLsizei instance_count);

#endif
