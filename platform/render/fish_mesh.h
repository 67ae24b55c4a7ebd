/* fish_mesh.h -- uploads a species' key shapes (modelled growth stages) as the vertex attributes
 * that the shader morph.glsl reads.
 *
 * Each key shape stores eight bytes per vertex, as in species.h: the position as three 16-bit
 * fractions of the mesh's reach, and the normal as a 16-bit octahedral code. OpenGL ES 3.0
 * guarantees sixteen attributes, which is enough for eight key shapes and the attributes of an
 * instance. */
#pragma once

#include "core/morph/morph.h"
#include "core/morph/species.h"
#include "platform/render/gl_util.h"

/* Locations of the vertex attributes, as in assets/shaders. Key shapes use the locations 0 to 7.
 * The attributes of instances use the locations that this enum does not list. */
enum fish_attribute {
    FISH_ATTRIBUTE_SURFACE = 8,
    /* Location of the paint coordinates of specimens. The tank's fish use patterns instead of
     * paint. */
    FISH_ATTRIBUTE_PAINT = 9,
    FISH_ATTRIBUTE_MASKS = 12,
    FISH_ATTRIBUTE_RIDES = 13,
};

/* Maximum size of a vertex in bytes. A vertex consists of one point for each of up to eight key
 * shapes, then the surface, mask, anchor and paint bytes. */
#define FISH_VERTEX_SIZE_MAX (MORPH_KEY_MAX * sizeof(struct species_point) + 16u)

/* Lists of triangles in the index buffer of a mesh, in the order of the buffer. */
enum fish_triangles {
    FISH_BODY, /* Body and eyes. */
    FISH_FINS, /* Fins. For specimens, each triangle is listed for each side. */
    /* Body, eyes and fins of a fish that is only some tens of pixels long: about half of the
     * vertices. Only fish_mesh_fill_tank() writes these lists. */
    FISH_SMALL_BODY,
    FISH_SMALL_FINS,
    FISH_TRIANGLES_COUNT,
};

/* Mesh of one level of detail of a fish. */
struct fish_mesh {
    GLuint vertex_array, vertex_buffer, index_buffer;
    GLsizei index_counts[FISH_TRIANGLES_COUNT];
    /* Length, in body lengths, of the largest coordinate that the packed vertices can store. The
     * shaders read this value as the uniform `reach`. */
    float reach;
};

/* Buffer in which a mesh is packed before its upload. The caller owns the buffer and may reuse it
 * after each fish_mesh_fill(). */
struct fish_mesh_memory {
    uint8_t vertices[MESH_VERTEX_MAX * FISH_VERTEX_SIZE_MAX];
    uint16_t indices[2u * MESH_INDEX_MAX]; /* The lists for small fish are at most as long. */
};

/* Creates the OpenGL objects of an empty mesh. */
void fish_mesh_reserve(struct fish_mesh *mesh);
/* Packs the mesh `source` with `key_count` key shapes in `memory`, and uploads the packed mesh. May
 * be called again with another mesh. */
void fish_mesh_fill(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                    const struct species_mesh *source, uint32_t key_count);
/* As fish_mesh_fill(), for the fish of the tank. Lists each triangle of a fin only once, and also
 * writes the lists for small fish. */
void fish_mesh_fill_tank(struct fish_mesh *mesh, struct fish_mesh_memory *memory,
                         const struct species_mesh *source, uint32_t key_count);
void fish_mesh_close(struct fish_mesh *mesh);

/* Draws the triangles of one list for `instance_count` fish. The caller has bound the shader
 * program and the instance attributes. */
void fish_mesh_draw(const struct fish_mesh *mesh, enum fish_triangles triangles,
                    GLsizei instance_count);

/* Maximum number of texels of one pose. A texel holds four floats. */
#define POSE_TEXELS_MAX (2u * MORPH_CURVE_MAX + 2u * ANCHOR_MAX)

/* Writes a pose to `out` in the texel layout that morph.glsl reads: two texels for each curve, then
 * two texels for each anchor. Returns the number of texels. `curve_count` is the number of
 * deformation curves (CURVES in the shader), and `anchor_count` is the number of anchors of the
 * mesh. */
uint32_t fish_poses_pack(float out[][4], const struct morph_pose *pose, uint32_t curve_count,
                         uint32_t anchor_count);
