/* import_flat.c -- walks assimp's scene: every node's meshes, where the node stands at each key. */
#include "platform/ctl/import_flat.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#if __has_include(<assimp/cimport.h>)

#include "platform/ctl/import_nodes.h"

#include <assimp/cimport.h>
#include <assimp/metadata.h>
#include <assimp/postprocess.h>
#include <dlfcn.h>

#define SAME 1e-7f         /* A target that moves nothing by more is the base shape again. */

/* By its soname: the one whose headers this was built with. */
static const char *const libraries[] = { "libassimp.so.5", "libassimp.so" };

struct assimp {
    const struct aiScene *(*read)(const char *path, unsigned int flags);
    const char *(*error)(void);
};

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

static bool load(struct assimp *assimp)
{
    void *library = NULL;
    for (size_t i = 0; !library && i < sizeof libraries / sizeof libraries[0]; i++) {
        library = dlopen(libraries[i], RTLD_NOW | RTLD_LOCAL);
    }
    if (!library) {
        return false;
    }
    /* As POSIX has it: a pointer to an object becomes one to a function through its bytes. */
    void *const read = dlsym(library, "aiImportFile"), *const error = dlsym(library,
                                                                          "aiGetErrorString");
    memcpy(&assimp->read, &read, sizeof read);
    memcpy(&assimp->error, &error, sizeof error);
    return read && error;
}

bool import_knows_scenes(void)
{
    return true;
}

bool import_can_flatten(char why[IMPORT_WHY_SIZE])
{
    struct assimp assimp;
    if (!load(&assimp)) {
        snprintf(why, IMPORT_WHY_SIZE, "libassimp is not here, and it reads all but .obj and .txt "
                                       "(on Debian: apt install libassimp-dev)");
        return false;
    }
    return true;
}

static bool refuse(struct flattening *f, const char *text)
{
    snprintf(f->why, IMPORT_WHY_SIZE, "%s", text);
    return false;
}

/* ---- Meshes ---------------------------------------------------------------------------------- */

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

static void add_weights(const struct aiMeshMorphKey *moment, float share, float out[TARGET_MAX])
{
    for (uint32_t i = 0; i < moment->mNumValuesAndWeights; i++) {
        if (moment->mValues[i] < TARGET_MAX) {
            out[moment->mValues[i]] += share * (float)moment->mWeights[i];
        }
    }
}

/* Straight between the moments around a key's. */
static void weights_at(const struct flattening *f, const struct aiMeshMorphAnim *channel,
                       uint32_t key, float out[TARGET_MAX])
{
    const double time = standing_time(&f->standing, key);
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

/* How much of each target `mesh` shows under `node` at a key. */
static void target_weights(const struct flattening *f, const struct aiMesh *mesh, const char *node,
                           uint32_t key, float out[TARGET_MAX])
{
    memset(out, 0, TARGET_MAX * sizeof *out);
    if (!f->sampled) {
        if (f->key_target[key] != KEY_BASE && mesh->mNumAnimMeshes > 0) {
            out[f->key_target[key]] = 1.0f;
        }
        return;
    }
    const struct aiMeshMorphAnim *channel = weights_of(f, node);
    if (channel && channel->mNumKeys > 0) {
        weights_at(f, channel, key, out);
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
            p = v3_mad(p, v3_sub(vector(&target[vertex]), base), weights[t]);
        }
    }
    return p;
}

/* Where joints carry each vertex of a skinned mesh; `sums` holds the vertices' weights so far. */
static bool add_skinned(struct flattening *f, const struct aiMesh *mesh, uint32_t key,
                        const float weights[TARGET_MAX], float *sums)
{
    vec3 *out = &f->mesh->positions[key][f->mesh->vertex_count];
    memset(out, 0, mesh->mNumVertices * sizeof *out);
    memset(sums, 0, mesh->mNumVertices * sizeof *sums);
    for (uint32_t i = 0; i < mesh->mNumBones; i++) {
        const struct aiBone *bone = mesh->mBones[i];
        const struct standing_node *joint = standing_find(&f->standing, bone->mName.data);
        if (!joint) {
            return refuse(f, "a joint that is no node");
        }
        const struct place offset = place_of(&bone->mOffsetMatrix);
        const struct place at = place_within(&joint->at[key], &offset);
        for (uint32_t k = 0; k < bone->mNumWeights; k++) {
            const struct aiVertexWeight *w = &bone->mWeights[k];
            if (w->mVertexId >= mesh->mNumVertices) {
                return refuse(f, "a joint of a vertex that is not there");
            }
            const vec3 p = place_apply(&at, shape_at(mesh, weights, w->mVertexId));
            out[w->mVertexId] = v3_mad(out[w->mVertexId], p, w->mWeight);
            sums[w->mVertexId] += w->mWeight;
        }
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        if (!(fabsf(sums[i] - 1.0f) < 0.01f)) {
            return refuse(f, "a skinned vertex whose weights do not sum to 1");
        }
    }
    return true;
}

static bool add_shapes(struct flattening *f, const struct standing_node *node,
                       const struct aiMesh *mesh)
{
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

/* glTF's colours are linear; ours are as a screen shows them. */
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

static bool add_group(struct flattening *f, const struct aiNode *node, const struct aiMesh *mesh)
{
    struct import_mesh *m = f->mesh;
    struct aiString material = { .length = 0 };
    const char *const of = "material";
    if (m->group_count == IMPORT_GROUP_MAX) {
        return refuse(f, "more than 64 meshes");
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
    snprintf(m->group_names[m->group_count++], IMPORT_NAME_SIZE, "%.20s:%.20s:%.18s",
             node->mName.data, mesh->mName.data, material.data[0] ? material.data : of);
    return true;
}

static bool add_vertices(struct flattening *f, const struct standing_node *node,
                         const struct aiMesh *mesh)
{
    struct import_mesh *m = f->mesh;
    if (mesh->mNumVertices > IMPORT_VERTEX_MAX - m->vertex_count) {
        return refuse(f, "more than 65536 vertices");
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const uint32_t at = m->vertex_count + i;
        m->uv[at][0] = m->uv[at][1] = 0.0f;
        if (mesh->mTextureCoords[0]) {
            m->uv[at][0] = mesh->mTextureCoords[0][i].x;
            m->uv[at][1] = 1.0f - mesh->mTextureCoords[0][i].y; /* As the file has it. */
        }
        m->colours[at] = mesh->mColors[0] ? colour_of(&mesh->mColors[0][i]) : 0x808080u;
    }
    m->has_uv |= mesh->mTextureCoords[0] != NULL;
    m->has_colours |= mesh->mColors[0] != NULL;
    return add_shapes(f, node, mesh);
}

static bool add_triangles(struct flattening *f, const struct aiMesh *mesh)
{
    struct import_mesh *m = f->mesh;
    for (uint32_t i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices != 3) {
            continue; /* Points and lines are no surface. */
        }
        if (m->triangle_count == IMPORT_TRIANGLE_MAX) {
            return refuse(f, "more than 131072 triangles");
        }
        for (uint32_t k = 0; k < 3; k++) {
            if (face->mIndices[k] >= mesh->mNumVertices) {
                return refuse(f, "a triangle that names a vertex that is not there");
            }
            m->triangles[m->triangle_count][k] = m->vertex_count + face->mIndices[k];
        }
        m->groups[m->triangle_count++] = (uint8_t)(m->group_count - 1);
    }
    return true;
}

static bool add_mesh(struct flattening *f, const struct standing_node *node,
                     const struct aiMesh *mesh)
{
    for (uint32_t i = 0; i < mesh->mNumAnimMeshes; i++) {
        if (mesh->mAnimMeshes[i]->mNumVertices != mesh->mNumVertices) {
            return refuse(f, "a morph target of another topology than its mesh");
        }
    }
    if (mesh->mNumAnimMeshes > TARGET_MAX) {
        return refuse(f, "more than 64 morph targets");
    }
    if (!f->sampled && mesh->mNumAnimMeshes > 0 && mesh->mNumAnimMeshes != f->target_count) {
        return refuse(f, "meshes with different numbers of morph targets");
    }
    if (!add_group(f, node->node, mesh) || !add_triangles(f, mesh) ||
        !add_vertices(f, node, mesh)) {
        return false;
    }
    f->mesh->vertex_count += mesh->mNumVertices;
    return true;
}

static bool add_meshes(struct flattening *f)
{
    for (uint32_t n = 0; n < f->standing.node_count; n++) {
        const struct standing_node *node = &f->standing.nodes[n];
        for (uint32_t i = 0; i < node->node->mNumMeshes; i++) {
            const uint32_t index = node->node->mMeshes[i];
            if (index < f->scene->mNumMeshes &&
                !add_mesh(f, node, f->scene->mMeshes[index])) {
                return false;
            }
        }
    }
    return true;
}

/* ---- Keys ------------------------------------------------------------------------------------ */

/* The mesh with the fewest targets, by which keys are counted and named; null without targets. */
static const struct aiMesh *plainest(const struct flattening *f)
{
    const struct aiMesh *plain = NULL;
    for (uint32_t i = 0; i < f->scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = f->scene->mMeshes[i];
        if (mesh->mNumAnimMeshes > 0 && (!plain || mesh->mNumAnimMeshes < plain->mNumAnimMeshes)) {
            plain = mesh;
        }
    }
    return plain;
}

/* Are the shapes more than what each target alone is: joints, moving nodes, parts of their own? */
static bool needs_sampling(const struct flattening *f)
{
    bool more = standing_moves(f->scene);
    for (uint32_t i = 0; i < f->scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = f->scene->mMeshes[i];
        more = more || mesh->mNumBones > 0 ||
               (mesh->mNumAnimMeshes > 0 && mesh->mNumAnimMeshes != f->target_count);
    }
    return more && f->scene->mNumAnimations > 0 &&
           f->scene->mAnimations[0]->mNumMorphMeshChannels > 0;
}

static bool is_base(const struct aiMesh *mesh, const struct aiAnimMesh *target)
{
    if (!target->mVertices || target->mNumVertices != mesh->mNumVertices) {
        return !target->mVertices;
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const vec3 d = v3_sub(vector(&mesh->mVertices[i]), vector(&target->mVertices[i]));
        if (!(fabsf(d.x) <= SAME && fabsf(d.y) <= SAME && fabsf(d.z) <= SAME)) {
            return false;
        }
    }
    return true;
}

/* Some programs write the base once more, as the first target. */
static bool base_comes_twice(const struct flattening *f)
{
    for (uint32_t i = 0; i < f->scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = f->scene->mMeshes[i];
        if (mesh->mNumAnimMeshes > 0 && !is_base(mesh, mesh->mAnimMeshes[0])) {
            return false;
        }
    }
    return f->target_count > 0;
}

static const struct aiMeshMorphAnim *first_weights(const struct flattening *f)
{
    const struct aiAnimation *animation =
        f->scene->mNumAnimations > 0 ? f->scene->mAnimations[0] : NULL;
    return animation && animation->mNumMorphMeshChannels > 0 ? animation->mMorphMeshChannels[0]
                                                             : NULL;
}

/* A target's weight at a moment; the base has what the others leave. */
static double weight_of(const struct aiMeshMorphKey *moment, uint32_t target)
{
    double sum = 0.0, own = 0.0;
    for (uint32_t i = 0; i < moment->mNumValuesAndWeights; i++) {
        sum += moment->mWeights[i];
        own += moment->mValues[i] == target ? moment->mWeights[i] : 0.0;
    }
    /* Rounding may leave the base a little less than nothing. */
    return target != KEY_BASE ? own : sum > 1.0 && sum < 1.0 + 1e-5 ? 0.0 : 1.0 - sum;
}

/* When a shape is seen: the middle of its weight over time. */
static double season_of(const struct aiMeshMorphAnim *channel, uint32_t target)
{
    double sum = 0.0, when = 0.0;
    for (uint32_t i = 0; i < channel->mNumKeys; i++) {
        const double before = i > 0 ? channel->mKeys[i].mTime - channel->mKeys[i - 1].mTime : 0.0;
        const double after = i + 1 < channel->mNumKeys
                                 ? channel->mKeys[i + 1].mTime - channel->mKeys[i].mTime
                                 : 0.0;
        const double weight = weight_of(&channel->mKeys[i], target) * (before + after);
        sum += weight;
        when += weight * channel->mKeys[i].mTime;
    }
    return sum > 0.0 ? when / sum : 0.0;
}

/* By when they are seen; without an animation the base is the youngest. */
static void order_keys(struct flattening *f)
{
    const struct aiMeshMorphAnim *channel = first_weights(f);
    double season[MORPH_KEY_MAX];
    for (uint32_t i = 0; channel && i < f->mesh->key_count; i++) {
        const uint8_t target = f->key_target[i];
        const double when = season_of(channel, target);
        uint32_t at = i;
        for (; at > 0 && season[at - 1] > when; at--) {
            season[at] = season[at - 1];
            f->key_target[at] = f->key_target[at - 1];
        }
        season[at] = when;
        f->key_target[at] = target;
    }
}

static void name_key(struct flattening *f, const struct aiMesh *plain, uint32_t key,
                     uint32_t target)
{
    const bool named = plain && target < plain->mNumAnimMeshes;
    snprintf(f->mesh->key_names[key], IMPORT_NAME_SIZE, "%.40s",
             named ? plain->mAnimMeshes[target]->mName.data : f->mesh->is_ours ? "last" : "base");
}

/* The target that is shown most at a key's moment, or the base. */
static uint32_t most_shown(const struct flattening *f, uint32_t key)
{
    const struct aiMeshMorphAnim *channel = first_weights(f);
    float weights[TARGET_MAX] = { 0 }, base = 1.0f;
    uint32_t most = KEY_BASE;
    weights_at(f, channel, key, weights);
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

static bool choose_keys(struct flattening *f)
{
    const struct aiMesh *plain = plainest(f);
    f->target_count = plain ? plain->mNumAnimMeshes : 0;
    f->sampled = needs_sampling(f);
    const bool twice = !f->sampled && base_comes_twice(f);
    const uint32_t count = f->target_count + (twice ? 0u : 1u);
    if (count > MORPH_KEY_MAX) {
        return refuse(f, "more than 7 morph targets");
    }
    f->mesh->key_count = f->standing.key_count = count;
    for (uint32_t key = 0; key < count; key++) {
        f->key_target[key] = twice ? (uint8_t)key : key == 0 ? KEY_BASE : (uint8_t)(key - 1);
    }
    const struct aiMeshMorphAnim *channel = first_weights(f);
    if (channel && channel->mNumKeys > 0) {
        f->standing.begin = channel->mKeys[0].mTime;
        f->standing.end = channel->mKeys[channel->mNumKeys - 1].mTime;
    }
    if (!f->sampled && !twice) {
        order_keys(f);
    }
    for (uint32_t key = 0; key < count; key++) {
        name_key(f, plain, key, f->sampled ? most_shown(f, key) : f->key_target[key]);
    }
    return true;
}

/* The animation of weights becomes the graph, where keys are the targets themselves. */
static bool read_weights(struct flattening *f)
{
    struct import_mesh *m = f->mesh;
    const struct aiMeshMorphAnim *channel = first_weights(f);
    if (!channel || f->sampled || f->target_count == 0) {
        return true;
    }
    if (channel->mNumKeys > IMPORT_TIME_MAX) {
        return refuse(f, "an animation of more than 4096 moments");
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

static bool made_by_us(const struct aiScene *scene)
{
    const struct aiMetadata *data = scene->mMetaData;
    for (uint32_t i = 0; data && i < data->mNumProperties; i++) {
        if (strcmp(data->mKeys[i].data, "SourceAsset_Generator") == 0 &&
            data->mValues[i].mType == AI_AISTRING) {
            const struct aiString *name = data->mValues[i].mData;
            return strncmp(name->data, "kingyo", 6) == 0 || strncmp(name->data, "Kingyo", 6) == 0;
        }
    }
    return false;
}

static const struct aiScene *read_scene(struct flattening *f, const char *path)
{
    struct assimp assimp;
    if (!load(&assimp)) {
        refuse(f, "libassimp is gone");
        return NULL;
    }
    const struct aiScene *scene = assimp.read(path, aiProcess_Triangulate);
    if (scene && scene->mRootNode && scene->mNumMeshes > 0) {
        return scene;
    }
    snprintf(f->why, IMPORT_WHY_SIZE, "%.110s", scene ? "no mesh" : assimp.error());
    for (char *c = f->why; *c; c++) {
        *c = *c >= ' ' && *c < 127 ? *c : ' '; /* It quotes the file. */
    }
    return NULL;
}

bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE])
{
    static struct flattening f;
    memset(&f, 0, sizeof f);
    f.mesh = mesh;
    f.why = why;
    f.scene = read_scene(&f, path);
    if (!f.scene) {
        return false;
    }
    mesh->is_ours = made_by_us(f.scene);
    if (!choose_keys(&f) || !read_weights(&f)) {
        return false;
    }
    if (!standing_fill(&f.standing, f.scene)) {
        return refuse(&f, "more than 4096 nodes");
    }
    memcpy(mesh->scales, f.standing.scales, sizeof mesh->scales);
    return add_meshes(&f) && (mesh->triangle_count > 0 || refuse(&f, "no triangles"));
}

#else /* Built without assimp. */

bool import_knows_scenes(void)
{
    return false;
}

bool import_can_flatten(char why[IMPORT_WHY_SIZE])
{
    snprintf(why, IMPORT_WHY_SIZE, "this kingyoctl was built without assimp, which reads all but "
                                   ".obj and .txt (on Debian: apt install libassimp-dev, build)");
    return false;
}

bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE])
{
    (void)path;
    (void)mesh;
    return !import_can_flatten(why) && false;
}

#endif
