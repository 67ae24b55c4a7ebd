/* import_flat.c -- walks assimp's scene: every node's meshes, where the node stands at each key. */
#include "platform/ctl/import_flat.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#if __has_include(<assimp/cimport.h>)

#include <assimp/types.h> /* First: others use its words without including it. */

#include <assimp/anim.h>
#include <assimp/cimport.h>
#include <assimp/metadata.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <dlfcn.h>

#define DEPTH_MAX 64u      /* Of nodes; rigs of hands and faces have twenty. */
#define NODE_MAX 4096u
#define SAME 1e-7f         /* A target that moves nothing by more is the base shape again. */

/* By its soname: the one whose headers this was built with. */
static const char *const libraries[] = { "libassimp.so.5", "libassimp.so" };

struct assimp {
    const struct aiScene *(*read)(const char *path, unsigned int flags);
    const char *(*error)(void);
};

struct flattening {
    struct import_mesh *mesh;
    const struct aiScene *scene;
    char *why;
    bool base_is_a_target; /* The first target is the base itself, which then does not count. */
    uint32_t target_count;
    double begin, end; /* Of the animation. */
    uint32_t node_count;
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

/* ---- Where a node is at a key ---------------------------------------------------------------- */

struct place {
    float m[3][4]; /* Rows; the fourth column is the translation. */
};

static struct place place_of(const struct aiMatrix4x4 *a)
{
    return (struct place){ { { a->a1, a->a2, a->a3, a->a4 },
                             { a->b1, a->b2, a->b3, a->b4 },
                             { a->c1, a->c2, a->c3, a->c4 } } };
}

static struct place within(const struct place *outer, const struct place *inner)
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

static vec3 apply(const struct place *p, vec3 a)
{
    float out[3];
    for (int i = 0; i < 3; i++) {
        out[i] = p->m[i][0] * a.x + p->m[i][1] * a.y + p->m[i][2] * a.z + p->m[i][3];
    }
    return v3(out[0], out[1], out[2]);
}

/* The share of the way from key `*i` to the next at `time`, among `count` rising times. */
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

static void quaternion_at(const struct aiQuatKey *keys, uint32_t count, double time, float q[4])
{
    uint32_t i = 0;
    const float t =
        count < 2 ? 0.0f : between((const char *)keys, sizeof *keys, count, time, &i);
    const struct aiQuaternion *a = &keys[i].mValue, *b = &keys[count < 2 ? i : i + 1].mValue;
    const float dot = a->x * b->x + a->y * b->y + a->z * b->z + a->w * b->w;
    const float s = dot < 0.0f ? -t : t;
    const float mixed[4] = { a->x * (1.0f - t) + b->x * s, a->y * (1.0f - t) + b->y * s,
                             a->z * (1.0f - t) + b->z * s, a->w * (1.0f - t) + b->w * s };
    const float length = sqrtf(mixed[0] * mixed[0] + mixed[1] * mixed[1] + mixed[2] * mixed[2] +
                               mixed[3] * mixed[3]);
    for (int k = 0; k < 4; k++) {
        q[k] = length > 0.0f ? mixed[k] / length : (k == 3 ? 1.0f : 0.0f);
    }
}

static const struct aiNodeAnim *motion_of(const struct flattening *f, const struct aiNode *node)
{
    if (f->scene->mNumAnimations == 0) {
        return NULL;
    }
    const struct aiAnimation *animation = f->scene->mAnimations[0];
    for (uint32_t i = 0; i < animation->mNumChannels; i++) {
        const struct aiNodeAnim *channel = animation->mChannels[i];
        if (strcmp(channel->mNodeName.data, node->mName.data) == 0 &&
            channel->mNumPositionKeys > 0 && channel->mNumRotationKeys > 0 &&
            channel->mNumScalingKeys > 0) {
            return channel;
        }
    }
    return NULL;
}

static double time_of(const struct flattening *f, uint32_t key)
{
    const double last = fmax((double)f->mesh->key_count - 1.0, 1.0);
    return f->begin + (f->end - f->begin) * (double)key / last;
}

/* A node whose scale changes is growing: its size at each key is a length, and no shape. */
static struct place moved(struct flattening *f, const struct aiNodeAnim *motion, uint32_t key)
{
    const double time = time_of(f, key);
    const vec3 at = vector_at(motion->mPositionKeys, motion->mNumPositionKeys, time);
    vec3 scale = vector_at(motion->mScalingKeys, motion->mNumScalingKeys, time);
    float q[4];
    quaternion_at(motion->mRotationKeys, motion->mNumRotationKeys, time, q);
    if (motion->mNumScalingKeys > 1 && fabsf(scale.x - scale.y) <= 1e-5f * fabsf(scale.x) &&
        fabsf(scale.x - scale.z) <= 1e-5f * fabsf(scale.x)) {
        f->mesh->scales[key] = scale.x;
        scale = v3(1.0f, 1.0f, 1.0f);
    }
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    return (struct place){
        { { (1 - 2 * (y * y + z * z)) * scale.x, 2 * (x * y - z * w) * scale.y,
            2 * (x * z + y * w) * scale.z, at.x },
          { 2 * (x * y + z * w) * scale.x, (1 - 2 * (x * x + z * z)) * scale.y,
            2 * (y * z - x * w) * scale.z, at.y },
          { 2 * (x * z - y * w) * scale.x, 2 * (y * z + x * w) * scale.y,
            (1 - 2 * (x * x + y * y)) * scale.z, at.z } }
    };
}

/* ---- Meshes ---------------------------------------------------------------------------------- */

static uint32_t target_of(const struct flattening *f, uint32_t key)
{
    return f->base_is_a_target ? key : key - 1; /* Of key 0 only where the base is a target. */
}

static const struct aiVector3D *shape(const struct flattening *f, const struct aiMesh *mesh,
                                      uint32_t key)
{
    const bool base = mesh->mNumAnimMeshes == 0 || (key == 0 && !f->base_is_a_target);
    const struct aiAnimMesh *target = base ? NULL : mesh->mAnimMeshes[target_of(f, key)];
    return target && target->mVertices ? target->mVertices : mesh->mVertices;
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

static bool add_vertices(struct flattening *f, const struct aiMesh *mesh,
                         const struct place places[MORPH_KEY_MAX])
{
    struct import_mesh *m = f->mesh;
    if (mesh->mNumVertices > IMPORT_VERTEX_MAX - m->vertex_count) {
        return refuse(f, "more than 65536 vertices");
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const uint32_t at = m->vertex_count + i;
        for (uint32_t key = 0; key < m->key_count; key++) {
            const struct aiVector3D *p = &shape(f, mesh, key)[i];
            m->positions[key][at] = apply(&places[key], v3(p->x, p->y, p->z));
        }
        m->uv[at][0] = m->uv[at][1] = 0.0f;
        if (mesh->mTextureCoords[0]) {
            m->uv[at][0] = mesh->mTextureCoords[0][i].x;
            m->uv[at][1] = 1.0f - mesh->mTextureCoords[0][i].y; /* As the file has it. */
        }
        m->colours[at] = mesh->mColors[0] ? colour_of(&mesh->mColors[0][i]) : 0x808080u;
    }
    m->has_uv |= mesh->mTextureCoords[0] != NULL;
    m->has_colours |= mesh->mColors[0] != NULL;
    return true;
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

static bool add_mesh(struct flattening *f, const struct aiNode *node, const struct aiMesh *mesh,
                     const struct place places[MORPH_KEY_MAX])
{
    for (uint32_t i = 0; i < mesh->mNumAnimMeshes; i++) {
        if (mesh->mAnimMeshes[i]->mNumVertices != mesh->mNumVertices) {
            return refuse(f, "a morph target of another topology than its mesh");
        }
    }
    if (mesh->mNumAnimMeshes > 0 && mesh->mNumAnimMeshes != f->target_count) {
        return refuse(f, "meshes with different numbers of morph targets");
    }
    if (!add_group(f, node, mesh) || !add_triangles(f, mesh) || !add_vertices(f, mesh, places)) {
        return false;
    }
    f->mesh->vertex_count += mesh->mNumVertices;
    return true;
}

/* A level of the walk: a node, its next child, and where it stands at each key. */
struct step {
    const struct aiNode *node;
    uint32_t child;
    struct place places[MORPH_KEY_MAX];
};

static void enter(struct flattening *f, const struct aiNode *node, const struct step *parent,
                  struct step *out)
{
    const struct aiNodeAnim *motion = motion_of(f, node);
    out->node = node;
    out->child = 0;
    for (uint32_t key = 0; key < f->mesh->key_count; key++) {
        const struct place own =
            motion ? moved(f, motion, key) : place_of(&node->mTransformation);
        out->places[key] = parent ? within(&parent->places[key], &own) : own;
    }
}

static bool add_meshes_of(struct flattening *f, const struct step *step)
{
    if (++f->node_count > NODE_MAX) {
        return refuse(f, "more than 4096 nodes");
    }
    for (uint32_t i = 0; i < step->node->mNumMeshes; i++) {
        const uint32_t index = step->node->mMeshes[i];
        if (index < f->scene->mNumMeshes &&
            !add_mesh(f, step->node, f->scene->mMeshes[index], step->places)) {
            return false;
        }
    }
    return true;
}

static bool walk(struct flattening *f)
{
    static struct step steps[DEPTH_MAX];
    uint32_t depth = 1;
    enter(f, f->scene->mRootNode, NULL, &steps[0]);
    if (!add_meshes_of(f, &steps[0])) {
        return false;
    }
    while (depth > 0) {
        struct step *step = &steps[depth - 1];
        if (step->child == step->node->mNumChildren) {
            depth--;
            continue;
        }
        if (depth == DEPTH_MAX) {
            return refuse(f, "nodes within nodes more than 64 deep");
        }
        enter(f, step->node->mChildren[step->child++], step, &steps[depth]);
        if (!add_meshes_of(f, &steps[depth++])) {
            return false;
        }
    }
    return true;
}

/* ---- Targets and their weights --------------------------------------------------------------- */

static bool is_base(const struct aiMesh *mesh, const struct aiAnimMesh *target)
{
    if (!target->mVertices || target->mNumVertices != mesh->mNumVertices) {
        return !target->mVertices;
    }
    for (uint32_t i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D *a = &mesh->mVertices[i], *b = &target->mVertices[i];
        if (!(fabsf(a->x - b->x) <= SAME && fabsf(a->y - b->y) <= SAME &&
              fabsf(a->z - b->z) <= SAME)) {
            return false;
        }
    }
    return true;
}

static bool count_keys(struct flattening *f)
{
    const struct aiMesh *first = NULL;
    f->base_is_a_target = true;
    for (uint32_t i = 0; i < f->scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = f->scene->mMeshes[i];
        if (mesh->mNumAnimMeshes > 0) {
            first = first ? first : mesh;
            f->base_is_a_target = f->base_is_a_target && is_base(mesh, mesh->mAnimMeshes[0]);
        }
    }
    f->target_count = first ? first->mNumAnimMeshes : 0;
    f->base_is_a_target = f->base_is_a_target && first;
    const uint32_t count = f->target_count + (f->base_is_a_target ? 0u : 1u);
    if (count > MORPH_KEY_MAX) {
        return refuse(f, "more than 7 morph targets");
    }
    f->mesh->key_count = count;
    for (uint32_t key = 0; key < count; key++) {
        const bool named = first && (key > 0 || f->base_is_a_target);
        snprintf(f->mesh->key_names[key], IMPORT_NAME_SIZE, "%.40s",
                 named ? first->mAnimMeshes[target_of(f, key)]->mName.data : "base");
        f->mesh->scales[key] = 1.0f;
    }
    return true;
}

static void add_moment(struct flattening *f, const struct aiMeshMorphKey *moment)
{
    struct import_mesh *m = f->mesh;
    float *weights = m->weights[m->time_count];
    double rest = 1.0;
    memset(weights, 0, sizeof m->weights[0]);
    for (uint32_t i = 0; i < moment->mNumValuesAndWeights; i++) {
        const uint32_t target = moment->mValues[i];
        if (target < f->target_count) {
            weights[f->base_is_a_target ? target : target + 1] += (float)moment->mWeights[i];
            rest -= moment->mWeights[i];
        }
    }
    /* What no target has is the base's; rounding may leave a little less than nothing. */
    weights[0] += rest > -1e-5 && rest < 0.0 ? 0.0f : (float)rest;
    m->times[m->time_count++] = (float)moment->mTime;
}

/* The first animation's first channel of weights; all meshes of a fish have the same. */
static bool read_weights(struct flattening *f)
{
    const struct aiAnimation *animation =
        f->scene->mNumAnimations > 0 ? f->scene->mAnimations[0] : NULL;
    if (!animation || animation->mNumMorphMeshChannels == 0 || f->target_count == 0) {
        f->end = animation ? animation->mDuration : 0.0;
        return true;
    }
    const struct aiMeshMorphAnim *channel = animation->mMorphMeshChannels[0];
    if (channel->mNumKeys > IMPORT_TIME_MAX) {
        return refuse(f, "an animation of more than 4096 moments");
    }
    for (uint32_t i = 0; i < channel->mNumKeys; i++) {
        add_moment(f, &channel->mKeys[i]);
    }
    if (channel->mNumKeys > 0) {
        f->begin = channel->mKeys[0].mTime;
        f->end = channel->mKeys[channel->mNumKeys - 1].mTime;
    }
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

bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE])
{
    struct flattening f = { .mesh = mesh, .why = why };
    struct assimp assimp;
    if (!load(&assimp)) {
        return refuse(&f, "libassimp is gone");
    }
    f.scene = assimp.read(path, aiProcess_Triangulate);
    if (!f.scene || !f.scene->mRootNode || f.scene->mNumMeshes == 0) {
        snprintf(why, IMPORT_WHY_SIZE, "%.110s", f.scene ? "no mesh" : assimp.error());
        for (char *c = why; *c; c++) {
            *c = *c >= ' ' && *c < 127 ? *c : ' ';
        }
        return false;
    }
    mesh->is_ours = made_by_us(f.scene);
    return count_keys(&f) && read_weights(&f) && walk(&f) &&
           (mesh->triangle_count > 0 || refuse(&f, "no triangles"));
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
