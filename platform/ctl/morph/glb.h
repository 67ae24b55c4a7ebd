/* glb.h -- a builder for binary glTF 2.0 files (.glb).
 *
 * Arrays are stored in the binary buffer. The JSON objects that describe the arrays are stored in
 * one text list for each type of object. glb_next() starts a list entry and writes the comma, and
 * byte_buffer_print() then writes the entry. Names of species contain only a-z, 0-9 and _, so that
 * no string needs escaping. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_GLB_H
#define KINGYO_PLATFORM_CTL_MORPH_GLB_H

#include "platform/ctl/lib/byte_buffer.h"

/* Lists of JSON objects in a glTF file. */
enum glb_list {
    GLB_VIEWS,
    GLB_ACCESSORS,
    GLB_MATERIALS,
    GLB_MESHES,
    GLB_SKINS,
    GLB_NODES,
    GLB_SAMPLERS,
    GLB_CHANNELS,
    GLB_LIST_COUNT,
};

/* A file under construction. A zero-initialized structure is a valid empty file. */
struct glb {
    struct byte_buffer buffer;
    struct byte_buffer lists[GLB_LIST_COUNT];
    uint32_t counts[GLB_LIST_COUNT];
};

enum glb_type { GLB_SCALAR, GLB_VEC2, GLB_VEC3, GLB_VEC4, GLB_MAT4 };

/* Use of an array in the file. The use determines which properties of the array glTF requires. */
enum glb_use {
    GLB_FOR_VERTICES, /* The array is a vertex attribute, or an attribute of a morph target. */
    GLB_FOR_PLACES,   /* The array contains vertex positions (POSITION), for which glTF requires
                         bounds. */
    GLB_FOR_TIMES,    /* The array is the input of an animation sampler, for which glTF requires
                         bounds. */
    GLB_FOR_DATA,     /* The array is the output of an animation sampler, or contains the matrices
                         of a skin. */
};

/* Starts a new entry of a list and returns the entry's index. The caller appends the entry's text
 * to `lists[list]`. */
uint32_t glb_next(struct glb *glb, enum glb_list list);

/* Copies `count` elements of floats to the buffer and adds an accessor, the glTF description of the
 * array. Returns the index of the accessor. `count` must be at least 1. */
uint32_t glb_floats(struct glb *glb, enum glb_use use, enum glb_type type, const float *values,
                    uint32_t count);

/* Copies `count` vertex indices of triangles to the buffer. Returns the index of the new
 * accessor. */
uint32_t glb_indices(struct glb *glb, const uint16_t *indices, uint32_t count);
/* Copies four joint numbers for each of `count` vertices to the buffer. Returns the index of the
 * new accessor. */
uint32_t glb_joints(struct glb *glb, const uint8_t (*joints)[4], uint32_t count);

/* Writes the file to `path`. `animation` is the name of the animation that contains all samplers
 * and channels. `scene` is a JSON list of the node numbers in the scene, for example "0,3". Returns
 * 0 or a negative errno. -ENOMEM means that an earlier memory allocation failed and `glb` is
 * incomplete. */
int glb_write(struct glb *glb, const char *path, const char *animation, const char *scene);

/* Frees the memory of the buffer and of all lists. */
void glb_free(struct glb *glb);

#endif
