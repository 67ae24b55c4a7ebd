/* fish_mesh.h -- a species' key shapes, packed into the vertex attributes of morph.glsl.
 *
 * Each key and vertex takes eight bytes, as in species.h: the position as three 16-bit fractions of
 * the mesh's reach, and the normal as an octahedral code in 16 bits. Eight keys fit beside the
 * instance's attributes in the sixteen attributes that OpenGL ES 3.0 guarantees. */
#ifndef KINGYO_PLATFORM_RENDER_FISH_MESH_H
#define KINGYO_PLATFORM_RENDER_FISH_MESH_H

#include "core/morph/species.h"
#include "platform/render/gl_util.h"

enum fish_attribute { /* Attribute locations as in assets/shaders: keys use 0 .. 7, instances use
                         the remaining locations. */
                      FISH_ATTRIBUTE_SURFACE = 8,
                      FISH_ATTRIBUTE_PAINT = 9, /* Location of the paint coordinates of specimens.
                                                   The tank's fish use patterns instead. */
                      FISH_ATTRIBUTE_MASKS = 12,
                      FISH_ATTRIBUTE_RIDES = 13,
};

/* Size of the largest vertex: a point for each of eight keys, then surface, masks, anchor bytes and
 * paint coordinates. */
#define FISH_VERTEX_SIZE_MAX (MORPH_KEY_MAX * sizeof(struct species_point) + 16u)

/* One level of detail in one index buffer: body and eyes first, then fins. */
struct fish_mesh {
    GLuint vertex_array, vertex_buffer, index_buffer;
    GLsizei body_index_count, fin_index_count;
    float reach; /* Value of the shaders' uniform `reach`. */
};

/* Buffer in which a mesh is packed before the upload. The caller owns it and may reuse it after
 * each fish_mesh_fill(). */
struct fish_mesh_memory {
    uint8_t vertices[MESH_VERTEX_MAX * FISH_VERTEX_SIZE_MAX];
    uint16_t indices[MESH_INDEX_MAX];
};

/* fish_mesh_reserve() creates the mesh's OpenGL names. fish_mesh_fill() uploads a shape and may be
 * called again for another shape. */
void fish_mesh_reserve(struct fish_mesh *mesh);
void fish_mesh_fill(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                    const struct species_mesh *source, uint32_t key_count);
void fish_mesh_close(struct fish_mesh *mesh);

/* Draws `instance_count` fish with the bound program and instance attributes. */
void fish_mesh_draw(const struct fish_mesh *mesh, bool fins, GLsizei instance_count);

#endif
