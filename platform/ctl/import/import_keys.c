/* import_keys.c -- selects the key shapes of a scene, sorts them by age, and reads their
 * deformation graph. */
/* Included only so that the file is not empty in a build without assimp. An empty source file is
 * not valid C. */
#include <stddef.h>

#ifdef HAS_ASSIMP

#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/import/import_flat.h"

/* Distance in the unit of the file. If a morph target moves no vertex farther than this distance,
 * the target equals the base shape. */
#define SAME 1e-7f

static void add_weights(const struct aiMeshMorphKey *moment, float share, float out[TARGET_MAX])
{
    for (uint32_t i = 0; i < moment->mNumValuesAndWeights; i++) {
        if (moment->mValues[i] < TARGET_MAX) {
            out[moment->mValues[i]] += share * (float)moment->mWeights[i];
        }
    }
}

/* Interpolates linearly between the keyframes before and after the time of the key shape. */
void import_keys_weights_at(const struct flattening *f, const struct aiMeshMorphAnim *channel,
                            uint32_t key, float out[TARGET_MAX])
{
    CORE_ASSERT(key < f->mesh->key_count);
    const double time = import_nodes_time(&f->standing, key);
    uint32_t i = 0;
    while (i + 1 < channel->mNumKeys && channel->mKeys[i + 1].mTime <= time) {
        i++;
    }
    const struct aiMeshMorphKey *from = &channel->mKeys[i];
    const bool last = i + 1 == channel->mNumKeys;
    const double span = last ? 1.0 : from[1].mTime - from->mTime;
    const double share = last || !(span > 0.0) ? 0.0 : fmax((time - from->mTime) / span, 0.0);
    add_weights(from, (float)(1.0 - share), out);
    if (!last) {
        add_weights(from + 1, (float)share, out);
    }
}

static bool is_base(const struct aiMesh *mesh, const struct aiAnimMesh *target)
{
    if (!target->mVertices || target->mNumVertices != mesh->mNumVertices) {
        return !target->mVertices;
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const vec3 d =
            v3_sub(import_vector(&mesh->mVertices[i]), import_vector(&target->mVertices[i]));
        if (!(fabsf(d.x) <= SAME && fabsf(d.y) <= SAME && fabsf(d.z) <= SAME)) {
            return false;
        }
    }
    return true;
}

static const struct aiMeshMorphAnim *first_weights(const struct flattening *f)
{
    const struct aiAnimation *animation = import_animation(f->scene);
    return animation && animation->mNumMorphMeshChannels > 0 ? animation->mMorphMeshChannels[0]
                                                             : NULL;
}

/* Returns the weight of the morph target `target` at a keyframe. For KEY_BASE, returns the weight
 * of the base shape, which is 1 minus the sum of the weights of all morph targets. */
static double weight_of(const struct aiMeshMorphKey *moment, uint32_t target)
{
    double sum = 0.0, own = 0.0;
    for (uint32_t i = 0; i < moment->mNumValuesAndWeights; i++) {
        sum += moment->mWeights[i];
        own += moment->mValues[i] == target ? moment->mWeights[i] : 0.0;
    }
    /* A slightly negative weight of the base shape is a rounding error and becomes 0. */
    return target != KEY_BASE ? own : sum > 1.0 && sum < 1.0 + 1e-5 ? 0.0 : 1.0 - sum;
}

/* Sorts the key shapes by their mean animation time. In this mean, each keyframe counts with the
 * weight that the morph target has at the keyframe. Without an animation, the base shape is the
 * youngest key shape. */
static void sort_by_season(struct flattening *f, const struct aiMeshMorphAnim *channel)
{
    double season[MORPH_KEY_MAX];
    for (uint32_t i = 0; i < f->mesh->key_count; i++) {
        const uint8_t target = f->key_target[i];
        double sum = 0.0, when = 0.0;
        for (uint32_t k = 0; k < channel->mNumKeys; k++) {
            const struct aiMeshMorphKey *moment = &channel->mKeys[k];
            const double before = k > 0 ? moment->mTime - moment[-1].mTime : 0.0;
            const double after = k + 1 < channel->mNumKeys ? moment[1].mTime - moment->mTime : 0.0;
            const double weight = weight_of(moment, target) * (before + after);
            sum += weight;
            when += weight * moment->mTime;
        }
        when = sum > 0.0 ? when / sum : 0.0;
        uint32_t at = i;
        for (; at > 0 && season[at - 1] > when; at--) {
            season[at] = season[at - 1];
            f->key_target[at] = f->key_target[at - 1];
        }
        season[at] = when;
        f->key_target[at] = target;
    }
}

/* Returns the morph target with the greatest weight at the time of a key shape, or KEY_BASE if the
 * base shape has the greatest weight. */
static uint32_t most_shown(const struct flattening *f, uint32_t key)
{
    const struct aiMeshMorphAnim *channel = first_weights(f);
    float weights[TARGET_MAX] = { 0 }, base = 1.0f;
    uint32_t most = KEY_BASE;
    import_keys_weights_at(f, channel, key, weights);
    for (uint32_t t = 0; t < f->target_count; t++) {
        base -= weights[t];
    }
    for (uint32_t t = 0; t < f->target_count; t++) {
        if (weights[t] > base) {
            base = weights[t];
            most = t;
        }
    }
    return most;
}

bool import_keys_choose(struct flattening *f)
{
    CORE_ASSERT(f->scene && f->mesh);
    const struct aiMeshMorphAnim *channel = first_weights(f);
    const struct aiMesh *plain = NULL; /* Mesh with the fewest morph targets, which determines the
                                          number and the names of the key shapes. */
    bool is_twice = true; /* True if the first morph target equals the base shape in every mesh.
                             Some programs write the base shape twice. */
    /* The key shapes must be sampled from the animation if joints or moving nodes change the shape,
     * or if meshes have different numbers of morph targets. */
    bool more = import_nodes_moves(f->scene);
    for (uint32_t i = 0; i < f->scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = f->scene->mMeshes[i];
        more = more || mesh->mNumBones > 0;
        if (mesh->mNumAnimMeshes > 0) {
            more = more || (plain && mesh->mNumAnimMeshes != plain->mNumAnimMeshes);
            is_twice = is_twice && is_base(mesh, mesh->mAnimMeshes[0]);
            plain = !plain || mesh->mNumAnimMeshes < plain->mNumAnimMeshes ? mesh : plain;
        }
    }
    f->target_count = plain ? plain->mNumAnimMeshes : 0;
    f->sampled = more && channel;
    const bool twice = !f->sampled && plain && is_twice;
    const uint32_t count = f->target_count + (twice ? 0u : 1u);
    if (count > MORPH_KEY_MAX) {
        return import_error(f->why, "more than 7 morph targets");
    }
    f->mesh->key_count = f->standing.key_count = count;
    for (uint32_t key = 0; key < count; key++) {
        f->key_target[key] = twice ? (uint8_t)key : key == 0 ? KEY_BASE : (uint8_t)(key - 1);
    }
    if (channel && channel->mNumKeys > 0) {
        f->standing.begin = channel->mKeys[0].mTime;
        f->standing.end = channel->mKeys[channel->mNumKeys - 1].mTime;
    }
    if (channel && !f->sampled && !twice) {
        sort_by_season(f, channel);
    }
    for (uint32_t key = 0; key < count; key++) {
        const uint32_t target = f->sampled ? most_shown(f, key) : f->key_target[key];
        const bool named = plain && target < plain->mNumAnimMeshes;
        snprintf(f->mesh->key_names[key], IMPORT_NAME_SIZE, "%.40s",
                 named              ? plain->mAnimMeshes[target]->mName.data
                 : f->mesh->is_ours ? "last"
                                    : "base");
    }
    return true;
}

/* Copies the animation of the weights, which becomes the deformation graph. Nothing is copied if
 * the key shapes are not morph targets. After an error returns false, and import_error() has
 * written the reason. */
bool import_keys_read_weights(struct flattening *f)
{
    struct import_mesh *m = f->mesh;
    const struct aiMeshMorphAnim *channel = first_weights(f);
    if (!channel || f->sampled || f->target_count == 0) {
        return true;
    }
    if (channel->mNumKeys > IMPORT_TIME_MAX) {
        return import_error(f->why, "an animation of more than 4096 keyframes");
    }
    for (uint32_t i = 0; i < channel->mNumKeys; i++) {
        const struct aiMeshMorphKey *moment = &channel->mKeys[i];
        bool base_is_a_key = false;
        for (uint32_t key = 0; key < m->key_count; key++) {
            m->weights[i][key] = (float)weight_of(moment, f->key_target[key]);
            base_is_a_key = base_is_a_key || f->key_target[key] == KEY_BASE;
        }
        if (!base_is_a_key) {
            m->weights[i][0] += (float)weight_of(moment, KEY_BASE);
        }
        m->times[i] = (float)moment->mTime;
    }
    m->time_count = channel->mNumKeys;
    return true;
}

#else

/* This declaration only prevents an empty source file in a build without assimp, because an empty
 * source file is not valid C. */
typedef int import_keys_without_assimp;

#endif
