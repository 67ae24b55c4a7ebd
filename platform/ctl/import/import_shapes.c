/* import_shapes.c -- adds the meshes of a scene to the result in every key shape, transformed by
 * nodes and joints. */
#include <stddef.h> /* This header is included so that the file is not empty without assimp. An
                       empty source file is not valid C. */

#ifdef HAS_ASSIMP

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/import/import_flat.h"

static const struct aiMeshMorphAnim *weights_of(const struct flattening *f, const char *node)
{
    const struct aiAnimation *animation =
        f->scene->mNumAnimations > 0 ? f->scene->mAnimations[0] : NULL;
    for (uint32_t i = 0; animation && i < animation->mNumMorphMeshChannels; i++) {
        if (strcmp(animation->mMorphMeshChannels[i]->mName.data, node) == 0) {
            return animation->mMorphMeshChannels[i];
        }
    }
    return NULL;
}

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
    const struct aiMeshMorphAnim *channel = weights_of(f, node);
    if (channel && channel->mNumKeys > 0) {
        import_keys_weights_at(f, channel, key, out);
    }
}

static vec3 vector(const struct aiVector3D *a)
{
    return v3(a->x, a->y, a->z);
}

static vec3 shape_at(const struct aiMesh *mesh, const float weights[TARGET_MAX], uint32_t vertex)
{
    const vec3 base = vector(&mesh->mVertices[vertex]);
    vec3 p = base;
    for (uint32_t t = 0; t < mesh->mNumAnimMeshes; t++) {
        const struct aiVector3D *target = mesh->mAnimMeshes[t]->mVertices;
        if (weights[t] != 0.0f && target) {
            p = v3_muladd(p, v3_sub(vector(&target[vertex]), base), weights[t]);
        }
    }
    return p;
}

/* Adds the vertices of a skinned mesh, transformed by its joints, in key shape `key`. `sums` is
 * scratch memory for the sum of the joint weights of each vertex. Returns false after
 * import_flat_error(). */
static bool add_skinned(struct flattening *f, const struct aiMesh *mesh, uint32_t key,
                        const float weights[TARGET_MAX], float *sums)
{
    CORE_ASSERT(key < f->mesh->key_count);
    vec3 *out = &f->mesh->positions[key][f->mesh->vertex_count];
    memset(out, 0, mesh->mNumVertices * sizeof *out);
    memset(sums, 0, mesh->mNumVertices * sizeof *sums);
    for (uint32_t i = 0; i < mesh->mNumBones; i++) {
        const struct aiBone *bone = mesh->mBones[i];
        const struct import_nodes_node *joint = import_nodes_find(&f->standing, bone->mName.data);
        if (!joint) {
            return import_flat_error(f, "a joint that is no node");
        }
        const struct place offset = import_nodes_place_of(&bone->mOffsetMatrix);
        const struct place at = import_nodes_place_within(&joint->at[key], &offset);
        for (uint32_t k = 0; k < bone->mNumWeights; k++) {
            const struct aiVertexWeight *w = &bone->mWeights[k];
            if (w->mVertexId >= mesh->mNumVertices) {
                return import_flat_error(f, "a joint of a vertex that is not there");
            }
            const vec3 p = import_nodes_apply(&at, shape_at(mesh, weights, w->mVertexId));
            out[w->mVertexId] = v3_muladd(out[w->mVertexId], p, w->mWeight);
            sums[w->mVertexId] += w->mWeight;
        }
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        if (!(fabsf(sums[i] - 1.0f) < 0.01f)) {
            return import_flat_error(f, "a skinned vertex whose weights do not sum to 1");
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
        return import_flat_error(f, "more than 65536 vertices");
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const uint32_t at = m->vertex_count + i;
        m->uv[at][0] = m->uv[at][1] = 0.0f;
        if (mesh->mTextureCoords[0]) {
            m->uv[at][0] = mesh->mTextureCoords[0][i].x;
            m->uv[at][1] = 1.0f - mesh->mTextureCoords[0][i].y; /* assimp flips the vertical
                                                                   texture coordinate. The second
                                                                   flip restores the value in the
                                                                   file. */
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
            out[i] = import_nodes_apply(&node->at[key], shape_at(mesh, weights, i));
        }
    }
    return true;
}

static bool add_mesh(struct flattening *f, const struct import_nodes_node *node,
                     const struct aiMesh *mesh)
{
    for (uint32_t i = 0; i < mesh->mNumAnimMeshes; i++) {
        if (mesh->mAnimMeshes[i]->mNumVertices != mesh->mNumVertices) {
            return import_flat_error(f, "a morph target of another topology than its mesh");
        }
    }
    if (mesh->mNumAnimMeshes > TARGET_MAX) {
        return import_flat_error(f, "more than 64 morph targets");
    }
    if (!f->sampled && mesh->mNumAnimMeshes > 0 && mesh->mNumAnimMeshes != f->target_count) {
        return import_flat_error(f, "meshes with different numbers of morph targets");
    }
    struct import_mesh *whole = f->mesh;
    struct aiString material = { .length = 0 };
    const char *const of = "material";
    if (whole->group_count == IMPORT_GROUP_MAX) {
        return import_flat_error(f, "more than 64 meshes");
    }
    if (mesh->mMaterialIndex < f->scene->mNumMaterials) {
        const struct aiMaterial *its = f->scene->mMaterials[mesh->mMaterialIndex];
        for (uint32_t i = 0; i < its->mNumProperties; i++) {
            const struct aiMaterialProperty *p = its->mProperties[i];
            if (strcmp(p->mKey.data, "?mat.name") == 0 && p->mDataLength > 4 &&
                p->mDataLength < 40) {
                memcpy(material.data, p->mData + 4, p->mDataLength - 4);
            }
        }
    }
    snprintf(whole->group_names[whole->group_count++], IMPORT_NAME_SIZE, "%.20s:%.20s:%.18s",
             node->node->mName.data, mesh->mName.data, material.data[0] ? material.data : of);
    struct import_mesh *m = f->mesh;
    for (uint32_t i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices != 3) {
            /* Points and lines are skipped, because they are not part of the surface. */
            continue;
        }
        if (m->triangle_count == IMPORT_TRIANGLE_MAX) {
            return import_flat_error(f, "more than 131072 triangles");
        }
        for (uint32_t k = 0; k < 3; k++) {
            if (face->mIndices[k] >= mesh->mNumVertices) {
                return import_flat_error(f, "a triangle that names a vertex that is not there");
            }
            m->triangles[m->triangle_count][k] = m->vertex_count + face->mIndices[k];
        }
        m->groups[m->triangle_count++] = (uint8_t)(m->group_count - 1);
    }
    if (!add_vertices(f, node, mesh)) {
        return false;
    }
    f->mesh->vertex_count += mesh->mNumVertices;
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

typedef int import_shapes_without_assimp; /* Declaration for a build without assimp, because an
                                             empty source file is not valid C. */

#endif
