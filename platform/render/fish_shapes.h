/* fish_shapes.h -- stores the blended shapes of the tank's fish in a texture.
 *
 * The shape of a fish depends only on its progress through life. The shape is therefore blended on
 * the CPU (core/morph/blend.c) when a fish appears or has grown, and is then kept. The vertex
 * shader fish.vert.glsl reads two texels for each vertex and blends nothing.
 *
 * Each fish has a row of the texture. Vertex i has the texel 2 * i with the position in body
 * lengths, and the texel 2 * i + 1 with the unit normal. The texels are 16-bit floats, which are
 * exact to 0.0003 body lengths. */
#pragma once

#include "core/morph/morph.h"
#include "core/scene.h"
#include "platform/render/gl_util.h"

/* Maximum number of consecutive rows that are uploaded in one call. */
#define SHAPE_RUN 8u

struct fish_shapes {
    GLuint texture;
    uint32_t width; /* Number of texels of a row. */
    /* Progress through life that each row shows, [0, 1]. A negative value means that the row has
     * not been written yet. */
    float progress[SCENE_FISH_MAX];
    const struct species_mesh *mesh[SCENE_FISH_MAX]; /* Mesh that each row shows. */
    /* First row (`run_first`) and number (`run_count`) of the rows in `run`, which have not been
     * uploaded yet. */
    uint32_t run_first, run_count;
    uint16_t run[SHAPE_RUN * 2u * MESH_VERTEX_MAX][4];
    /* Number of rows written since the last fish_shapes_begin(), for measurements. */
    uint32_t written_count;
    struct morph_pose pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

void fish_shapes_open(struct gl_status *status, struct fish_shapes *shapes,
                      const struct species_mesh *mesh);
void fish_shapes_close(struct fish_shapes *shapes);

/* Starts an update of the shapes. The caller then calls fish_shapes_set() for each fish, and
 * fish_shapes_end() once. */
void fish_shapes_begin(struct fish_shapes *shapes);
/* Writes the shape of one fish to the row `row`, unless the row already has this shape. The shape
 * is blended from `mesh`, which has as many vertices as the mesh of fish_shapes_open(), with the
 * deformation graphs of `rig` at `progress` through life, [0, 1]. Fastest if the rows are written
 * in ascending order. */
void fish_shapes_set(struct fish_shapes *shapes, const struct morph_rig *rig,
                     const struct species_mesh *mesh, uint32_t row, float progress);
/* Uploads the written rows that have not been uploaded yet. */
void fish_shapes_end(struct fish_shapes *shapes);
