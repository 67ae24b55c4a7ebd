/* import_flat_parts.h -- what the three files that flatten a scene share. Only where assimp is. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_FLAT_PARTS_H
#define KINGYO_PLATFORM_CTL_IMPORT_FLAT_PARTS_H

#include "platform/ctl/import_nodes.h"

/* Which shape of the scene a key is: the base, a target alone, or the scene at a moment. */
#define KEY_BASE 255u
#define TARGET_MAX 64u

struct flattening {
    struct import_mesh *mesh;
    const struct aiScene *scene;
    char *why;
    struct standing standing;
    uint32_t target_count;           /* The least that a mesh with targets has. */
    bool sampled;                    /* Keys are moments of the animation, not targets. */
    uint8_t key_target[MORPH_KEY_MAX]; /* A target or KEY_BASE, where keys are targets. */
};

/* Says why not, and answers false. */
bool flat_refuse(struct flattening *f, const char *text);

/* import_keys.c: which shapes are the keys, their names, and the graph of their animation. */
bool flat_choose_keys(struct flattening *f);
bool flat_read_weights(struct flattening *f);

/* The weights of `channel` at a key's moment, added to `out`. */
void flat_weights_at(const struct flattening *f, const struct aiMeshMorphAnim *channel,
                     uint32_t key, float out[TARGET_MAX]);

/* import_shapes.c: every node's meshes, in every key. */
bool flat_add_meshes(struct flattening *f);

#endif
