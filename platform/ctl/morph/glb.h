/* glb.h -- a builder for binary glTF 2.0 files (.glb), and the declarations that the writer of a
 * fish's life shares.
 *
 * Arrays are stored in the binary buffer. The JSON objects that describe the arrays are stored in
 * one text list for each type of object. glb_next() starts a list entry, and the functions of
 * platform/os/json.h then write the entry.
 *
 * glb.c writes the file and its nodes, morph_glb_mesh.c the meshes and their shapes, and
 * morph_glb_life.c the animation. A piece is a mesh of one part of the fish on one side. A key is a
 * modelled growth stage. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "platform/ctl/morph/morph_export.h"
#include "platform/os/json.h"

/* Lists of JSON objects in a glTF file, and the binary buffer. */
enum glb_list {
    GLB_VIEWS,
    GLB_ACCESSORS,
    GLB_MATERIALS,
    GLB_MESHES,
    GLB_SKINS,
    GLB_NODES,
    GLB_SCENE, /* Indices of the root nodes of the scene. */
    GLB_SAMPLERS,
    GLB_CHANNELS,
    GLB_BUFFER,
    GLB_LIST_COUNT,
};

/* A file under construction. Each list is a stream of open_memstream(3), whose text is in the
 * `buffer` and `size` of the struct after fflush(3). */
struct glb {
    struct json lists[GLB_LIST_COUNT];
    uint32_t counts[GLB_LIST_COUNT];
};

enum glb_type { GLB_SCALAR, GLB_VEC2, GLB_VEC3, GLB_VEC4, GLB_MAT4 };

/* Use of an array in the file. The use determines the type of the components and the properties
 * that glTF requires. The components are floats unless the comment states another type. */
enum glb_use {
    GLB_FOR_VERTICES, /* The array is a vertex attribute, or an attribute of a morph target. */
    /* The array contains vertex positions (POSITION), for which glTF requires bounds. */
    GLB_FOR_PLACES,
    /* The array is the input of an animation sampler, for which glTF requires bounds. */
    GLB_FOR_TIMES,
    /* The array is the output of an animation sampler, or contains the matrices of a skin. */
    GLB_FOR_DATA,
    GLB_FOR_TRIANGLES, /* The array contains the vertex indices of triangles as uint16_t. */
    GLB_FOR_JOINTS,    /* The array contains four joint numbers for each vertex as uint8_t. */
};

/* Starts a new entry of a list and returns the entry's index. The caller writes the entry to
 * lists[list]. */
uint32_t glb_next(struct glb *glb, enum glb_list list);

/* Copies `count` elements to the buffer and adds an accessor, the glTF description of the array.
 * Returns the index of the accessor. `count` must be at least 1. */
uint32_t glb_array(struct glb *glb, enum glb_use use, enum glb_type type, const void *data,
                   uint32_t count);

/* ---- Life of a fish -------------------------------------------------------------------------- */

#define GLB_SECONDS 10.0f /* Duration in seconds of the animation of a whole life. */
/* Index of the fish's node in the file. The nodes of the pieces follow, and then the nodes of the
 * anchors. */
#define GLB_ROOT_NODE 0u
#define GLB_PIECE_NODE 1u
#define TARGET_MAX (MORPH_CURVE_MAX * (MORPH_KEY_MAX - 1u))

/* Morph targets of a piece. Each curve of the deformation graph that moves the piece has one target
 * for each key except the last key. The curve of the whole fish is always included, because this
 * curve also blends the colours. */
struct target_list {
    uint32_t count;
    uint8_t curves; /* Bit mask of the curves that have targets. Bit i is curve i. */
    uint8_t curve[TARGET_MAX], key[TARGET_MAX];
};

struct morph_glb {
    const struct morph_options *pick;
    const struct species_mesh *mesh;
    struct glb file;
    /* Pose of the fish at progress 1 (adult). A viewer shows this pose if no animation runs. */
    struct morph_pose adult;
    struct morph_mesh cut;
    /* Colour of each vertex for each key, indexed by key and vertex. */
    struct paint paints[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct target_list targets[PIECE_MAX];
    /* True if at least one vertex of the piece has an anchor on the body's surface. */
    bool skinned[PIECE_MAX];
    /* Number of the glTF material of each part, counted from 1. 0 means that the material was not
     * written yet. */
    uint32_t materials[PART_COUNT];
};

/* Adds the mesh of `piece` to the file. Also sets the morph targets of the piece, and sets
 * `skinned` for the piece. Returns the index of the mesh. */
uint32_t morph_glb_add_mesh(struct morph_glb *fish, uint32_t piece);

/* Adds the animation of all nodes to the file. Must be called after all meshes were added. Returns
 * false if memory allocation fails. */
bool morph_glb_animate(struct morph_glb *fish);
