/* import_flat_internal.h -- declarations that the three files import_flat.c, import_keys.c and
 * import_shapes.c share.
 *
 * Included only if assimp is available. A key shape of the result is the base shape, one morph
 * target alone, or the scene at one time of its animation. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_INTERNAL_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_INTERNAL_H

#include "platform/ctl/import/import_nodes.h"

/* Value of `key_target` for the base shape, which is the mesh without any morph target. */
#define KEY_BASE 255u

/* Maximum number of morph targets of a mesh. */
#define TARGET_MAX 64u

/* State of the conversion of one scene. */
struct flattening {
    struct import_mesh *mesh;
    const struct aiScene *scene;
    char *why;
    struct import_nodes standing;
    uint32_t target_count;             /* Smallest number of morph targets of the meshes that have
                                          morph targets. */
    bool sampled;                      /* True if key shapes are samples of the animation. False if
                                          key shapes are morph targets. */
    uint8_t key_target[MORPH_KEY_MAX]; /* Morph target of each key shape, or KEY_BASE for the base
                                          shape. Used only if `sampled` is false. */
};

/* Writes `text` to `why` and returns false. */
bool import_flat_error(struct flattening *f, const char *text);

/* Selects the key shapes and sets their names. Returns false after import_flat_error(). Defined in
 * import_keys.c. */
bool import_keys_choose(struct flattening *f);

/* Reads the animation of the morph target weights, which becomes the deformation graph. Returns
 * false after import_flat_error(). Defined in import_keys.c. */
bool import_keys_read_weights(struct flattening *f);

/* Adds the morph target weights of `channel`, at the animation time of key shape `key`, to
 * `out`. */
void import_keys_weights_at(const struct flattening *f, const struct aiMeshMorphAnim *channel,
                            uint32_t key, float out[TARGET_MAX]);

/* Adds the meshes of every node to the result, in every key shape. Returns false after
 * import_flat_error(). Defined in import_shapes.c. */
bool import_shapes_add_meshes(struct flattening *f);

#endif
