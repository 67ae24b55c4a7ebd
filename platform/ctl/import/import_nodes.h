/* import_nodes.h -- the transforms of an assimp scene's nodes at each key shape.
 *
 * Included only if assimp is available. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_NODES_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_NODES_H

#include <assimp/types.h> /* Included first because other assimp headers need its types. */

#include <assimp/anim.h>
#include <assimp/scene.h>
#include <stdbool.h>

#include "platform/ctl/import/import_mesh.h"

#define NODE_MAX 4096u

/* An affine transform. */
struct place {
    float m[3][4]; /* Rows of the matrix. The fourth column is the translation. */
};

/* A scene node and its transforms. */
struct import_nodes_node {
    const struct aiNode *node;
    struct place at[MORPH_KEY_MAX]; /* Transform from the node to the scene at each key shape,
                                       without the scale of a growing node. */
};

/* Transforms of all nodes of a scene. */
struct import_nodes {
    uint32_t key_count, node_count;
    double begin, end;           /* Animation times of the first key shape (`begin`) and of the
                                    last one (`end`). */
    float scales[MORPH_KEY_MAX]; /* Scale of the growing node at each key shape, or 1 if no node
                                    grows. */
    struct import_nodes_node nodes[NODE_MAX];
};

/* Computes the transform of every node. The caller sets `key_count`, `begin` and `end`. If end
 * <= begin, all key shapes use the rest pose. Returns false if the scene has more than NODE_MAX
 * nodes. */
bool import_nodes_fill(struct import_nodes *standing, const struct aiScene *scene);

/* Returns the node called `name`, or null. */
const struct import_nodes_node *import_nodes_find(const struct import_nodes *standing,
                                                  const char *name);

/* Returns whether the animation rotates or moves any node. Growth by a uniform scale does not
 * count. */
bool import_nodes_moves(const struct aiScene *scene);

/* Returns the animation time of a key shape. */
double import_nodes_time(const struct import_nodes *standing, uint32_t key);

/* Converts a matrix of assimp to a transform. The last row of the matrix is ignored. */
struct place import_nodes_place_of(const struct aiMatrix4x4 *matrix);

/* Returns the product outer * inner: first `inner` is applied, then `outer`. */
struct place import_nodes_place_within(const struct place *outer, const struct place *inner);

/* Returns the transformed point. */
vec3 import_nodes_apply(const struct place *place, vec3 a);

#endif
