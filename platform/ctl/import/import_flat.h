/* import_flat.h -- declarations that import_flat.c, import_keys.c and import_shapes.c share while
 * they convert an assimp scene to one mesh with several key shapes.
 *
 * Included only if assimp is available. A key shape of the result is the base shape, one morph
 * target alone, or the scene at one time of its animation. */
#pragma once

/* <assimp/types.h> must precede the other headers of assimp, because they need its types. */
#include <assimp/types.h>

#include <assimp/anim.h>
#include <assimp/scene.h>
#include <stdbool.h>

#include "platform/ctl/import/import.h"

/* ---- Transforms of the nodes (import_shapes.c) ----------------------------------------------- */

#define NODE_MAX 4096u

/* An affine transform of positions. */
struct place {
    float m[3][4]; /* Rows of the transform's matrix. The fourth column is the translation. */
};

/* A scene node and its transforms. */
struct import_nodes_node {
    const struct aiNode *node;
    /* Transform from the axes of the node to the axes of the scene at each key shape. If the node
     * grows, its growth scale is not included. */
    struct place at[MORPH_KEY_MAX];
};

/* Transforms of all nodes of a scene. A growing node is a node whose animated uniform scale
 * represents the growth of the fish. */
struct import_nodes {
    uint32_t key_count, node_count;
    /* Animation time of the first key shape (`begin`) and of the last key shape (`end`). */
    double begin, end;
    /* Scale of the growing node at each key shape. The value is 1 if no node grows. */
    float scales[MORPH_KEY_MAX];
    struct import_nodes_node nodes[NODE_MAX];
};

/* Computes the transforms of all nodes. The caller sets `key_count`, `begin` and `end` before the
 * call. If `end` is not greater than `begin`, all key shapes use the transforms without animation.
 * Returns false if the scene has more than NODE_MAX nodes. */
bool import_nodes_fill(struct import_nodes *standing, const struct aiScene *scene);

/* Returns true if the animation rotates or moves any node. The changing scale of a growing node
 * does not count as motion. */
bool import_nodes_moves(const struct aiScene *scene);

/* Returns the animation time of key shape `key`. */
double import_nodes_time(const struct import_nodes *standing, uint32_t key);

/* Returns the first animation of the scene, or null if the scene has no animation. */
static inline const struct aiAnimation *import_animation(const struct aiScene *scene)
{
    return scene->mNumAnimations > 0 ? scene->mAnimations[0] : NULL;
}

static inline vec3 import_vector(const struct aiVector3D *a)
{
    return v3(a->x, a->y, a->z);
}

/* ---- Conversion of a scene ------------------------------------------------------------------- */

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
    /* Smallest number of morph targets of the meshes that have morph targets. */
    uint32_t target_count;
    /* True if key shapes are samples of the animation. False if key shapes are morph targets. */
    bool sampled;
    /* Morph target of each key shape, or KEY_BASE for the base shape. Used only if `sampled` is
     * false. */
    uint8_t key_target[MORPH_KEY_MAX];
};

/* Selects the key shapes and sets their names. After an error returns false, and import_error() has
 * written the reason. Defined in import_keys.c. */
bool import_keys_choose(struct flattening *f);

/* Reads the animation of the morph target weights, which becomes the deformation graph. After an
 * error returns false, and import_error() has written the reason. Defined in import_keys.c. */
bool import_keys_read_weights(struct flattening *f);

/* Adds the morph target weights of `channel`, at the animation time of key shape `key`, to
 * `out`. */
void import_keys_weights_at(const struct flattening *f, const struct aiMeshMorphAnim *channel,
                            uint32_t key, float out[TARGET_MAX]);

/* Adds the meshes of every node to the result, in every key shape. After an error returns false,
 * and import_error() has written the reason. Defined in import_shapes.c. */
bool import_shapes_add_meshes(struct flattening *f);
