/* import_shapes.c -- computes the transforms of nested scene nodes at the time of each key shape,
 * and adds the meshes of a scene to the result in every key shape, transformed by nodes and
 * joints. */
/* Included only so that the file is not empty in a build without assimp. An empty source file is
 * not valid C. */
#include <stddef.h>

#ifdef HAS_ASSIMP

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/import/import_flat.h"

/* ---- Transforms of the nodes ----------------------------------------------------------------- */

/* Converts a matrix of assimp to a transform. The last row of the matrix is ignored. */
static struct place place_of(const struct aiMatrix4x4 *a)
{
    struct place p;
    memcpy(p.m, a, sizeof p.m); /* assimp stores the rows of the matrix in the same order as `m`. */
    return p;
}

/* Returns the product outer * inner, which applies `inner` first and then `outer`. */
static struct place place_within(const struct place *outer, const struct place *inner)
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

static vec3 place_apply(const struct place *p, vec3 a)
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
    if (count < 2) {
        return import_vector(&keys[0].mValue);
    }
    const float t = between((const char *)keys, sizeof *keys, count, time, &i);
    return v3_lerp(import_vector(&keys[i].mValue), import_vector(&keys[i + 1].mValue), t);
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
    const float from[4] = { a->x, a->y, a->z, a->w }, to[4] = { b->x, b->y, b->z, b->w };
    float square = 0.0f;
    for (int k = 0; k < 4; k++) {
        q[k] = from[k] * (1.0f - t) + to[k] * turned;
        square += q[k] * q[k];
    }
    const float length = sqrtf(square);
    for (int k = 0; k < 4; k++) {
        q[k] = length > 0.0f ? q[k] / length : (k == 3 ? 1.0f : 0.0f);
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
    const struct aiAnimation *animation = s->end > s->begin ? import_animation(scene) : NULL;
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
        const struct place own =
            motion ? animated_node_place(s, motion, key) : place_of(&node->mTransformation);
        out->at[key] = parent ? place_within(&parent->at[key], &own) : own;
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

bool import_nodes_moves(const struct aiScene *scene)
{
    const struct aiAnimation *animation = import_animation(scene);
    for (uint32_t i = 0; animation && i < animation->mNumChannels; i++) {
        const struct aiNodeAnim *channel = animation->mChannels[i];
        if (channel->mNumPositionKeys > 1 || channel->mNumRotationKeys > 1) {
            return true;
        }
    }
    return false;
}

/* ---- Meshes ---------------------------------------------------------------------------------- */

/* Computes the weight of each morph target of `mesh` under the node `node` at key shape `key`. */
static void target_weights(const struct flattening *f, const struct aiMesh *mesh, const char *node,
                           uint32_t key, float out[TARGET_MAX])
{
    CORE_ASSERT(key < MORPH_KEY_MAX);
    memset(out, 0, TARGET_MAX * sizeof *out);
    if (!f->sampled) {
        if (f->key_target[key] != KEY_BASE && mesh->mNumAnimMeshes > 0) {
            out[f->key_target[key]] = 1.0f;
        }
        return;
    }
    const struct aiAnimation *animation = import_animation(f->scene);
    for (uint32_t i = 0; animation && i < animation->mNumMorphMeshChannels; i++) {
        const struct aiMeshMorphAnim *channel = animation->mMorphMeshChannels[i];
        if (strcmp(channel->mName.data, node) == 0) {
            if (channel->mNumKeys > 0) {
                import_keys_weights_at(f, channel, key, out);
            }
            return;
        }
    }
}

static vec3 shape_at(const struct aiMesh *mesh, const float weights[TARGET_MAX], uint32_t vertex)
{
    const vec3 base = import_vector(&mesh->mVertices[vertex]);
    vec3 p = base;
    for (uint32_t t = 0; t < mesh->mNumAnimMeshes; t++) {
        const struct aiVector3D *target = mesh->mAnimMeshes[t]->mVertices;
        if (weights[t] != 0.0f && target) {
            p = v3_muladd(p, v3_sub(import_vector(&target[vertex]), base), weights[t]);
        }
    }
    return p;
}

/* Returns the node called `name`, or null if there is no such node. */
static const struct import_nodes_node *find_node(const struct import_nodes *s, const char *name)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        if (strcmp(s->nodes[i].node->mName.data, name) == 0) {
            return &s->nodes[i];
        }
    }
    return NULL;
}

/* Adds the vertices of a skinned mesh, transformed by its joints, in key shape `key`. `sums` is
 * scratch memory for the sum of the joint weights of each vertex. After an error returns false, and
 * import_error() has written the reason. */
static bool add_skinned(struct flattening *f, const struct aiMesh *mesh, uint32_t key,
                        const float weights[TARGET_MAX], float *sums)
{
    CORE_ASSERT(key < f->mesh->key_count);
    vec3 *out = &f->mesh->positions[key][f->mesh->vertex_count];
    memset(out, 0, mesh->mNumVertices * sizeof *out);
    memset(sums, 0, mesh->mNumVertices * sizeof *sums);
    for (uint32_t i = 0; i < mesh->mNumBones; i++) {
        const struct aiBone *bone = mesh->mBones[i];
        const struct import_nodes_node *joint = find_node(&f->standing, bone->mName.data);
        if (!joint) {
            return import_error(f->why, "a joint is not a node");
        }
        const struct place offset = place_of(&bone->mOffsetMatrix);
        const struct place at = place_within(&joint->at[key], &offset);
        for (uint32_t k = 0; k < bone->mNumWeights; k++) {
            const struct aiVertexWeight *w = &bone->mWeights[k];
            if (w->mVertexId >= mesh->mNumVertices) {
                return import_error(f->why, "a joint refers to a missing vertex");
            }
            const vec3 p = place_apply(&at, shape_at(mesh, weights, w->mVertexId));
            out[w->mVertexId] = v3_muladd(out[w->mVertexId], p, w->mWeight);
            sums[w->mVertexId] += w->mWeight;
        }
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        if (!(fabsf(sums[i] - 1.0f) < 0.01f)) {
            return import_error(f->why, "the joint weights of a vertex do not sum to 1");
        }
    }
    return true;
}

/* Converts a linear colour of glTF to an sRGB colour 0xRRGGBB. */
static uint32_t colour_of(const struct aiColor4D *colour)
{
    const float linear[3] = { colour->r, colour->g, colour->b };
    uint32_t out = 0;
    for (int i = 0; i < 3; i++) {
        const float x = fminf(fmaxf(linear[i], 0.0f), 1.0f);
        const float s = x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1.0f / 2.4f) - 0.055f;
        out = out << 8 | (uint32_t)(s * 255.0f + 0.5f);
    }
    return out;
}

static bool add_vertices(struct flattening *f, const struct import_nodes_node *node,
                         const struct aiMesh *mesh)
{
    struct import_mesh *m = f->mesh;
    if (mesh->mNumVertices > IMPORT_VERTEX_MAX - m->vertex_count) {
        return import_error(f->why, "more than 65536 vertices");
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const uint32_t at = m->vertex_count + i;
        m->uv[at][0] = m->uv[at][1] = 0.0f;
        if (mesh->mTextureCoords[0]) {
            m->uv[at][0] = mesh->mTextureCoords[0][i].x;
            /* assimp has flipped the vertical texture coordinate. Flipping it again restores the
             * value of the file. */
            m->uv[at][1] = 1.0f - mesh->mTextureCoords[0][i].y;
        }
        m->colours[at] = mesh->mColors[0] ? colour_of(&mesh->mColors[0][i]) : 0x808080u;
    }
    m->has_uv |= mesh->mTextureCoords[0] != NULL;
    m->has_colours |= mesh->mColors[0] != NULL;
    static float sums[IMPORT_VERTEX_MAX];
    for (uint32_t key = 0; key < f->mesh->key_count; key++) {
        float weights[TARGET_MAX];
        vec3 *out = &f->mesh->positions[key][f->mesh->vertex_count];
        target_weights(f, mesh, node->node->mName.data, key, weights);
        if (mesh->mNumBones > 0) {
            if (!add_skinned(f, mesh, key, weights, sums)) {
                return false;
            }
            continue;
        }
        for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
            out[i] = place_apply(&node->at[key], shape_at(mesh, weights, i));
        }
    }
    return true;
}

static bool add_mesh(struct flattening *f, const struct import_nodes_node *node,
                     const struct aiMesh *mesh)
{
    for (uint32_t i = 0; i < mesh->mNumAnimMeshes; i++) {
        if (mesh->mAnimMeshes[i]->mNumVertices != mesh->mNumVertices) {
            return import_error(f->why,
                                "a morph target and its mesh have different numbers of vertices");
        }
    }
    if (mesh->mNumAnimMeshes > TARGET_MAX) {
        return import_error(f->why, "more than 64 morph targets");
    }
    if (!f->sampled && mesh->mNumAnimMeshes > 0 && mesh->mNumAnimMeshes != f->target_count) {
        return import_error(f->why, "meshes with different numbers of morph targets");
    }
    struct import_mesh *m = f->mesh;
    struct aiString material = { .data = "material" };
    if (m->group_count == IMPORT_GROUP_MAX) {
        return import_error(f->why, "more than 64 meshes");
    }
    if (mesh->mMaterialIndex < f->scene->mNumMaterials) {
        const struct aiMaterial *its = f->scene->mMaterials[mesh->mMaterialIndex];
        for (uint32_t i = 0; i < its->mNumProperties; i++) {
            const struct aiMaterialProperty *p = its->mProperties[i];
            if (strcmp(p->mKey.data, "?mat.name") == 0 && p->mDataLength > 5 &&
                p->mDataLength < 40) {
                snprintf(material.data, sizeof material.data, "%.*s", (int)p->mDataLength - 4,
                         p->mData + 4);
            }
        }
    }
    snprintf(m->group_names[m->group_count++], IMPORT_NAME_SIZE, "%.20s:%.20s:%.18s",
             node->node->mName.data, mesh->mName.data, material.data);
    for (uint32_t i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices != 3) {
            /* Points and lines are skipped, because they are not part of the surface. */
            continue;
        }
        if (m->triangle_count == IMPORT_TRIANGLE_MAX) {
            return import_error(f->why, "more than 131072 triangles");
        }
        for (uint32_t k = 0; k < 3; k++) {
            if (face->mIndices[k] >= mesh->mNumVertices) {
                return import_error(f->why, "a triangle refers to a missing vertex");
            }
            m->triangles[m->triangle_count][k] = m->vertex_count + face->mIndices[k];
        }
        m->groups[m->triangle_count++] = (uint8_t)(m->group_count - 1);
    }
    if (!add_vertices(f, node, mesh)) {
        return false;
    }
    m->vertex_count += mesh->mNumVertices;
    return true;
}

bool import_shapes_add_meshes(struct flattening *f)
{
    CORE_ASSERT(f->standing.node_count <= NODE_MAX);
    for (uint32_t n = 0; n < f->standing.node_count; n++) {
        const struct import_nodes_node *node = &f->standing.nodes[n];
        for (uint32_t i = 0; i < node->node->mNumMeshes; i++) {
            const uint32_t index = node->node->mMeshes[i];
            if (index < f->scene->mNumMeshes && !add_mesh(f, node, f->scene->mMeshes[index])) {
                return false;
            }
        }
    }
    return true;
}

#else

/* This declaration only prevents an empty source file in a build without assimp, because an empty
 * source file is not valid C. */
typedef int import_shapes_without_assimp;

#endif
