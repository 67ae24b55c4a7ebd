/* import_nodes.c -- computes the transforms of nested scene nodes at the time of each key shape. */
#include <stddef.h> /* This header is included so that the file is not empty without assimp. An
                       empty source file is not valid C. */

#ifdef HAS_ASSIMP

#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/import/import_flat.h"

struct place import_nodes_place_of(const struct aiMatrix4x4 *a)
{
    return (struct place){ { { a->a1, a->a2, a->a3, a->a4 },
                             { a->b1, a->b2, a->b3, a->b4 },
                             { a->c1, a->c2, a->c3, a->c4 } } };
}

struct place import_nodes_place_within(const struct place *outer, const struct place *inner)
{
    struct place p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            p.m[i][j] = j == 3 ? outer->m[i][3] : 0.0f;
            for (int k = 0; k < 3; k++) {
                p.m[i][j] += outer->m[i][k] * inner->m[k][j];
            }
        }
    }
    return p;
}

vec3 import_nodes_apply(const struct place *p, vec3 a)
{
    float out[3];
    for (int i = 0; i < 3; i++) {
        out[i] = p->m[i][0] * a.x + p->m[i][1] * a.y + p->m[i][2] * a.z + p->m[i][3];
    }
    return v3(out[0], out[1], out[2]);
}

/* Finds the interval between two keyframes that contains `time`. `keys` contains `count` keyframes
 * with rising times. Sets `*i` to the first keyframe of the interval. Returns the fraction, in [0,
 * 1], of the interval that has passed at `time`. */
static float between(const char *keys, size_t stride, uint32_t count, double time, uint32_t *i)
{
    double low = 0.0, high = 0.0;
    for (*i = 0; *i + 2 < count; (*i)++) {
        memcpy(&high, keys + (*i + 1) * stride, sizeof high);
        if (time < high) {
            break;
        }
    }
    memcpy(&low, keys + *i * stride, sizeof low);
    memcpy(&high, keys + (*i + 1) * stride, sizeof high);
    return high > low ? (float)fmin(fmax((time - low) / (high - low), 0.0), 1.0) : 0.0f;
}

static vec3 vector_at(const struct aiVectorKey *keys, uint32_t count, double time)
{
    uint32_t i = 0;
    const struct aiVector3D *a = &keys[0].mValue;
    if (count < 2) {
        return v3(a->x, a->y, a->z);
    }
    const float t = between((const char *)keys, sizeof *keys, count, time, &i);
    a = &keys[i].mValue;
    const struct aiVector3D *b = &keys[i + 1].mValue;
    return v3_lerp(v3(a->x, a->y, a->z), v3(b->x, b->y, b->z), t);
}

double import_nodes_time(const struct import_nodes *s, uint32_t key)
{
    CORE_ASSERT(key < s->key_count);
    const double last = fmax((double)s->key_count - 1.0, 1.0);
    return s->begin + (s->end - s->begin) * (double)key / last;
}

/* Returns the transform of an animated node at a key shape. An animated uniform scale represents
 * the growth of the fish. The scale is stored as the size of the key shape and is not applied. */
static struct place animated_node_place(struct import_nodes *s, const struct aiNodeAnim *motion,
                                        uint32_t key)
{
    const double time = import_nodes_time(s, key);
    const vec3 at = vector_at(motion->mPositionKeys, motion->mNumPositionKeys, time);
    vec3 scale = vector_at(motion->mScalingKeys, motion->mNumScalingKeys, time);
    float q[4];
    const struct aiQuatKey *keys = motion->mRotationKeys;
    const uint32_t count = motion->mNumRotationKeys;
    uint32_t i = 0;
    const float t = count < 2 ? 0.0f : between((const char *)keys, sizeof *keys, count, time, &i);
    const struct aiQuaternion *a = &keys[i].mValue, *b = &keys[count < 2 ? i : i + 1].mValue;
    const float dot = a->x * b->x + a->y * b->y + a->z * b->z + a->w * b->w;
    const float turned = dot < 0.0f ? -t : t;
    const float mixed[4] = { a->x * (1.0f - t) + b->x * turned, a->y * (1.0f - t) + b->y * turned,
                             a->z * (1.0f - t) + b->z * turned, a->w * (1.0f - t) + b->w * turned };
    const float length = sqrtf(mixed[0] * mixed[0] + mixed[1] * mixed[1] + mixed[2] * mixed[2] +
                               mixed[3] * mixed[3]);
    for (int k = 0; k < 4; k++) {
        q[k] = length > 0.0f ? mixed[k] / length : (k == 3 ? 1.0f : 0.0f);
    }
    if (motion->mNumScalingKeys > 1 && fabsf(scale.x - scale.y) <= 1e-5f * fabsf(scale.x) &&
        fabsf(scale.x - scale.z) <= 1e-5f * fabsf(scale.x)) {
        s->scales[key] = scale.x;
        scale = v3(1.0f, 1.0f, 1.0f);
    }
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    return (struct place){ { { (1 - 2 * (y * y + z * z)) * scale.x, 2 * (x * y - z * w) * scale.y,
                               2 * (x * z + y * w) * scale.z, at.x },
                             { 2 * (x * y + z * w) * scale.x, (1 - 2 * (x * x + z * z)) * scale.y,
                               2 * (y * z - x * w) * scale.z, at.y },
                             { 2 * (x * z - y * w) * scale.x, 2 * (y * z + x * w) * scale.y,
                               (1 - 2 * (x * x + y * y)) * scale.z, at.z } } };
}

static void add_scene_node(struct import_nodes *s, const struct aiScene *scene,
                           const struct aiNode *node, const struct import_nodes_node *parent)
{
    const struct aiAnimation *animation =
        s->end > s->begin && scene->mNumAnimations > 0 ? scene->mAnimations[0] : NULL;
    const struct aiNodeAnim *motion = NULL;
    for (uint32_t i = 0; animation && !motion && i < animation->mNumChannels; i++) {
        const struct aiNodeAnim *channel = animation->mChannels[i];
        if (strcmp(channel->mNodeName.data, node->mName.data) == 0 &&
            channel->mNumPositionKeys > 0 && channel->mNumRotationKeys > 0 &&
            channel->mNumScalingKeys > 0) {
            motion = channel;
        }
    }
    CORE_ASSERT(s->node_count < NODE_MAX);
    struct import_nodes_node *out = &s->nodes[s->node_count++];
    out->node = node;
    for (uint32_t key = 0; key < s->key_count; key++) {
        const struct place own = motion ? animated_node_place(s, motion, key)
                                        : import_nodes_place_of(&node->mTransformation);
        out->at[key] = parent ? import_nodes_place_within(&parent->at[key], &own) : own;
    }
}

/* Visits the tree of nodes in breadth-first order. The array of nodes is also the queue of the
 * traversal. */
bool import_nodes_fill(struct import_nodes *s, const struct aiScene *scene)
{
    CORE_ASSERT(s->key_count >= 1 && s->key_count <= MORPH_KEY_MAX);
    s->node_count = 0;
    for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
        s->scales[key] = 1.0f;
    }
    add_scene_node(s, scene, scene->mRootNode, NULL);
    for (uint32_t i = 0; i < s->node_count; i++) {
        for (uint32_t child = 0; child < s->nodes[i].node->mNumChildren; child++) {
            if (s->node_count == NODE_MAX) {
                return false;
            }
            add_scene_node(s, scene, s->nodes[i].node->mChildren[child], &s->nodes[i]);
        }
    }
    return true;
}

const struct import_nodes_node *import_nodes_find(const struct import_nodes *s, const char *name)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        if (strcmp(s->nodes[i].node->mName.data, name) == 0) {
            return &s->nodes[i];
        }
    }
    return NULL;
}

bool import_nodes_moves(const struct aiScene *scene)
{
    const struct aiAnimation *animation = scene->mNumAnimations > 0 ? scene->mAnimations[0] : NULL;
    for (uint32_t i = 0; animation && i < animation->mNumChannels; i++) {
        const struct aiNodeAnim *channel = animation->mChannels[i];
        if (channel->mNumPositionKeys > 1 || channel->mNumRotationKeys > 1) {
            return true;
        }
    }
    return false;
}

#else

typedef int import_nodes_without_assimp; /* Declaration for a build without assimp, because an empty
                                            source file is not valid C. */

#endif
