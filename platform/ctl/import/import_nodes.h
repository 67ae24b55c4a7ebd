/* import_nodes.h -- computes the transforms of the nodes of an assimp scene at the time of each key
 * shape.
 *
 * A key shape is the shape of the fish at one modelled growth stage. Included only if assimp is
 * available. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_NODES_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_NODES_H

#include <assimp/types.h> /* This header must precede the other headers of assimp, because they need
                             its types. */

#include <assimp/anim.h>
#include <assimp/scene.h>
#include <stdbool.h>

#include "platform/ctl/import/import_mesh.h"

#define NODE_MAX 4096u

/* An affine transform of positions. */
struct place {
    float m[3][4]; /* Rows of the transform's matrix. The fourth column is the translation. */
};

/* A scene node and its transforms. */
struct import_nodes_node {
    const struct aiNode *node;
    struct place at[MORPH_KEY_MAX]; /* Transform from the axes of the node to the axes of the scene
                                       at each key shape. The scale of a growing node is not
                                       included. */
};

/* Transforms of all nodes of a scene. A growing node is a node whose animated uniform scale
 * represents the growth of the fish. */
struct import_nodes {
    uint32_t key_count, node_count;
    double begin, end;           /* Animation time of the first key shape (`begin`) and of the last
                                    key shape (`end`). */
    float scales[MORPH_KEY_MAX]; /* Scale of the growing node at each key shape. The value is 1 if
                                    no node grows. */
    struct import_nodes_node nodes[NODE_MAX];
};

/* Computes the transforms of all nodes. The caller sets `key_count`, `begin` and `end` before the
 * call. If `end` is not greater than `begin`, all key shapes use the transforms without animation.
 * Returns false if the scene has more than NODE_MAX nodes. */
bool import_nodes_fill(struct import_nodes *standing, const struct aiScene *scene);

/* Returns the node called `name`, or null if there is no such node. */
const struct import_nodes_node *import_nodes_find(const struct import_nodes *standing,
                                                  const char *name);

/* Returns true if the animation rotates or moves any node. A growing node, whose uniform scale
 * changes, does not count. */
bool import_nodes_moves(const struct aiScene *scene);

/* Returns the animation time of key shape `key`. */
double import_nodes_time(const struct import_nodes *standing, uint32_t key);

/* Converts a matrix of assimp to a transform. The last row of the matrix is ignored. */
struct place import_nodes_place_of(const struct aiMatrix4x4 *matrix);

/* Returns the product outer * inner, which applies `inner` first and then `outer`. */
struct place import_nodes_place_within(const struct place *outer, const struct place *inner);

/* Applies a transform to the point `a` and returns the result. */
vec3 import_nodes_apply(const struct place *place, vec3 a);

#endif
