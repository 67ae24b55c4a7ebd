/* import_nodes.h -- where the nodes of assimp's scene stand at each key. Only where assimp is. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_NODES_H
#define KINGYO_PLATFORM_CTL_IMPORT_NODES_H

#include <assimp/types.h> /* First: others use its words without including it. */

#include <assimp/anim.h>
#include <assimp/scene.h>
#include <stdbool.h>

#include "platform/ctl/import_mesh.h"

#define NODE_MAX 4096u

struct place {
    float m[3][4]; /* Rows; the fourth column is the translation. */
};

struct standing_node {
    const struct aiNode *node;
    struct place at[MORPH_KEY_MAX]; /* In the scene, without the scale of what grows. */
};

struct standing {
    uint32_t key_count, node_count;
    double begin, end;            /* Of the animation: the first key's moment and the last one's. */
    float scales[MORPH_KEY_MAX];  /* Of the node that grows; 1 where none does. */
    struct standing_node nodes[NODE_MAX];
};

/* Sets every node's place. False where there are more than NODE_MAX. `key_count`, `begin` and `end`
 * are set; with end <= begin all keys stand as at rest. */
bool standing_fill(struct standing *standing, const struct aiScene *scene);

/* The node of that name, or null. */
const struct standing_node *standing_find(const struct standing *standing, const char *name);

/* Does any node turn or wander, but for growing? */
bool standing_moves(const struct aiScene *scene);

/* The moment of a key. */
double standing_time(const struct standing *standing, uint32_t key);

struct place place_of(const struct aiMatrix4x4 *matrix);
struct place place_within(const struct place *outer, const struct place *inner);
vec3 place_apply(const struct place *place, vec3 a);

#endif
