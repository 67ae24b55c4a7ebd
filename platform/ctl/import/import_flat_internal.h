/* import_flat_internal.h -- internal declarations of the three files that flatten a scene.
 *
 * Included only if assimp is available. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_INTERNAL_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_INTERNAL_H

#include "platform/ctl/import/import_nodes.h"

/* Value of `key_target` for the base shape. A key shape is the base shape, one morph target alone,
 * or the scene at an animation time. */
#define KEY_BASE 255u

/* Most morph targets of a mesh. */
#define TARGET_MAX 64u

/* State of flattening one scene. */
struct flattening {
    struct import_mesh *mesh;
    const struct aiScene *scene;
    char *why;
    struct import_nodes standing;
    uint32_t target_count;             /* Smallest number of targets of the meshes that have
                                          targets. */
    bool sampled;                      /* Whether key shapes are samples of the animation and not
                                          morph targets. */
    uint8_t key_target[MORPH_KEY_MAX]; /* Morph target of each key shape, or KEY_BASE. Used only if
                                          `sampled` is false. */
};

/* Writes `text` as the reason and returns false. */
bool import_flat_error(struct flattening *f, const char *text);

/* Selects the key shapes and their names. Returns false after import_flat_error(). Defined in
 * import_keys.c. */
bool import_keys_choose(struct flattening *f);

/* Reads the graph of the key shapes' animation. Returns false after import_flat_error(). Defined in
 * import_keys.c. */
bool import_keys_read_weights(struct flattening *f);

/* Adds the weights of `channel` at the time of key shape `key` to `out`. */
void import_keys_weights_at(const struct flattening *f, const struct aiMeshMorphAnim *channel,
                            uint32_t key, float out[TARGET_MAX]);

/* Adds every node's meshes in every key shape. Returns false after import_flat_error(). Defined in
 * import_shapes.c. */
bool import_shapes_add_meshes(struct flattening *f);

#endif
