/* glb.h -- a builder for binary glTF 2.0 files.
 *
 * Arrays go to the binary buffer, and their descriptions go to lists of JSON objects. glb_next()
 * starts a list entry and writes the comma, and byte_buffer_print() writes the entry. Names of
 * species contain only a-z, 0-9 and _, so that no string needs escaping. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_GLB_H
#define KINGYO_PLATFORM_CTL_MORPH_GLB_H

#include "platform/ctl/lib/byte_buffer.h"

/* Lists of JSON objects in the file. */
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

/* A file under construction. All zero is a valid empty file. */
struct glb {
    struct byte_buffer buffer;
    struct byte_buffer lists[GLB_LIST_COUNT];
    uint32_t counts[GLB_LIST_COUNT];
};

enum glb_type { GLB_SCALAR, GLB_VEC2, GLB_VEC3, GLB_VEC4, GLB_MAT4 };

/* Use of an array. The use determines which properties glTF requires. */
enum glb_use {
    GLB_FOR_VERTICES, /* A vertex attribute, or an attribute of a morph target. */
    GLB_FOR_PLACES,   /* A vertex attribute with bounds, as glTF requires for POSITION. */
    GLB_FOR_TIMES,    /* The input of an animation sampler, with the bounds that glTF requires. */
    GLB_FOR_DATA,     /* The output of an animation sampler, or the matrices of a skin. */
};

/* Starts a new entry of a list and returns its index. The caller prints the entry to
 * `lists[list]`. */
uint32_t glb_next(struct glb *glb, enum glb_list list);

/* Copies `count` >= 1 elements of floats to the buffer. Returns the index of the new accessor. */
uint32_t glb_floats(struct glb *glb, enum glb_use use, enum glb_type type, const float *values,
                    uint32_t count);

/* Copies `count` triangle indices to the buffer. Returns the index of the new accessor. */
uint32_t glb_indices(struct glb *glb, const uint16_t *indices, uint32_t count);
/* Copies four joint numbers for each of `count` vertices to the buffer. Returns the index of the
 * new accessor. */
uint32_t glb_joints(struct glb *glb, const uint8_t (*joints)[4], uint32_t count);

/* Writes the file. `animation` names the samplers and channels, and `scene` is the JSON list of the
 * scene's nodes ("0,3"). Returns 0 or a negative errno. -ENOMEM means that an earlier allocation
 * failed and `glb` is incomplete. */
int glb_write(struct glb *glb, const char *path, const char *animation, const char *scene);

/* Frees the buffer and all lists. */
void glb_free(struct glb *glb);

#endif
