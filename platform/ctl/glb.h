/* glb.h -- a binary glTF 2.0 file in the making: arrays to its buffer, what they mean to its JSON.
 *
 * Lists of the JSON are filled by bytes_print(); glb_next() puts the comma and counts. Names that
 * come from species have a-z, 0-9 and _ alone, so nothing needs escaping. */
#ifndef KINGYO_PLATFORM_CTL_GLB_H
#define KINGYO_PLATFORM_CTL_GLB_H

#include "platform/ctl/bytes.h"

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

struct glb {
    struct bytes buffer;
    struct bytes lists[GLB_LIST_COUNT];
    uint32_t counts[GLB_LIST_COUNT];
};

enum glb_type { GLB_SCALAR, GLB_VEC2, GLB_VEC3, GLB_VEC4, GLB_MAT4 };
enum glb_use {
    GLB_FOR_VERTICES, /* An attribute or a target's. */
    GLB_FOR_PLACES,   /* The same, with its bounds, as POSITION must have them. */
    GLB_FOR_TIMES,    /* An animation's input, with its bounds too. */
    GLB_FOR_DATA,     /* An animation's output, a skin's matrices. */
};

/* Begins another entry of a list; answers its index. Print it to `lists[list]`. */
uint32_t glb_next(struct glb *glb, enum glb_list list);

/* Each copies `count` >= 1 elements and answers the accessor. */
uint32_t glb_floats(struct glb *glb, enum glb_use use, enum glb_type type, const float *values,
                    uint32_t count);
uint32_t glb_indices(struct glb *glb, const uint16_t *indices, uint32_t count);
/* Four joints a vertex. */
uint32_t glb_joints(struct glb *glb, const uint8_t (*joints)[4], uint32_t count);

/* Writes what was gathered: `animation` names its samplers and channels, `scene` is the list of the
 * scene's nodes as JSON has it ("0,3"). 0 or a negative errno; -ENOMEM: `glb` is not whole. */
int glb_write(struct glb *glb, const char *path, const char *animation, const char *scene);

void glb_free(struct glb *glb);

#endif
