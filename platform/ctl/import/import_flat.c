/* import_flat.c -- opens a scene with the library assimp, and reads the metadata of the file. */
#include "platform/ctl/import/import.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#ifdef HAS_ASSIMP

#include <assimp/cimport.h>
#include <assimp/metadata.h>
#include <assimp/postprocess.h>
#include <dlfcn.h>

#include "platform/ctl/import/import_flat.h"

/* Names of the library file, tried in this order. The first name is the version whose headers this
 * program was built with. */
static const char *const libraries[] = { "libassimp.so.5", "libassimp.so" };

struct assimp {
    const struct aiScene *(*read)(const char *path, unsigned int flags);
    const char *(*error)(void);
    void (*release)(const struct aiScene *scene);
    void (*attach)(const struct aiLogStream *log);
    void (*detach)(void);
};

/* Loads a function from the library. The pointer is copied as bytes, because C does not allow the
 * conversion of an object pointer to a function pointer. POSIX guarantees that the two have the
 * same representation. */
static bool import_flat_load_symbol(void *library, const char *name, void *function)
{
    void *const symbol = dlsym(library, name);
    memcpy(function, &symbol, sizeof symbol);
    return symbol != NULL;
}

static bool load_assimp(struct assimp *assimp)
{
    void *library = NULL;
    for (size_t i = 0; !library && i < sizeof libraries / sizeof libraries[0]; i++) {
        library = dlopen(libraries[i], RTLD_NOW | RTLD_LOCAL);
    }
    if (!library) {
        return false;
    }
    return import_flat_load_symbol(library, "aiImportFile", &assimp->read) &&
           import_flat_load_symbol(library, "aiGetErrorString", &assimp->error) &&
           import_flat_load_symbol(library, "aiReleaseImport", &assimp->release) &&
           import_flat_load_symbol(library, "aiAttachLogStream", &assimp->attach) &&
           import_flat_load_symbol(library, "aiDetachAllLogStreams", &assimp->detach);
}

bool import_flat_is_available(void)
{
    return true;
}

bool import_can_flatten(char why[IMPORT_WHY_SIZE])
{
    struct assimp assimp;
    if (!load_assimp(&assimp)) {
        snprintf(why, IMPORT_WHY_SIZE,
                 "libassimp is not here, and it reads all but .obj and .txt "
                 "(on Debian: apt install libassimp-dev)");
        return false;
    }
    return true;
}

bool import_flat_error(struct flattening *f, const char *text)
{
    snprintf(f->why, IMPORT_WHY_SIZE, "%s", text);
    return false;
}

/* ---- Metadata of key shapes in files that kingyoctl wrote ------------------------------------ */

static const struct aiMetadataEntry *entry_of(const struct aiMetadata *data, const char *key)
{
    for (uint32_t i = 0; data && i < data->mNumProperties; i++) {
        if (strcmp(data->mKeys[i].data, key) == 0) {
            return &data->mValues[i];
        }
    }
    return NULL;
}

/* Returns a number of the metadata, or 0 if the key is absent. The importer stores a real number
 * without a fraction as an integer, so both types are accepted. */
static float number_of(const struct aiMetadata *data, const char *key)
{
    const struct aiMetadataEntry *entry = entry_of(data, key);
    return !entry                      ? 0.0f
           : entry->mType == AI_DOUBLE ? (float)*(const double *)entry->mData
           : entry->mType == AI_FLOAT  ? *(const float *)entry->mData
           : entry->mType == AI_UINT64 ? (float)*(const uint64_t *)entry->mData
           : entry->mType == AI_INT32  ? (float)*(const int32_t *)entry->mData
                                       : 0.0f;
}

/* Returns the metadata entry `key` of the first node with this key, or null if no node has the
 * key. */
static const struct aiMetadataEntry *find_extra(const struct flattening *f, const char *key)
{
    const struct aiMetadataEntry *entry = NULL;
    for (uint32_t i = 0; !entry && i < f->standing.node_count; i++) {
        entry = entry_of(f->standing.nodes[i].node->mMetaData, key);
    }
    return entry;
}

/* Returns a metadata number as an integer, clamped to [0, max]. Returns 0 if the key is absent. */
static uint32_t whole_of(const struct aiMetadata *data, const char *key, float max)
{
    return (uint32_t)fminf(fmaxf(number_of(data, key), 0.0f), max);
}

static void read_life(struct flattening *f)
{
    struct import_mesh *m = f->mesh;
    const struct aiMetadataEntry *keys = find_extra(f, "keys");
    const struct aiMetadata *list = keys && keys->mType == AI_AIMETADATA ? keys->mData : NULL;
    if (!list || list->mNumProperties != m->key_count) {
        return;
    }
    m->has_coats = true;
    for (uint32_t key = 0; key < m->key_count; key++) {
        const struct aiMetadata *life =
            list->mValues[key].mType == AI_AIMETADATA ? list->mValues[key].mData : NULL;
        const struct aiMetadataEntry *name = entry_of(life, "name");
        if (name && name->mType == AI_AISTRING) {
            const struct aiString *text = name->mData;
            snprintf(m->key_names[key], IMPORT_NAME_SIZE, "%.40s", text->data);
        }
        m->ages_days[key] = number_of(life, "age_days");
        m->lengths_m[key] = number_of(life, "length_m");
        m->has_coats = m->has_coats && entry_of(life, "back");
        struct species_coat *coat = &m->coats[key];
        const float colour = 16777215.0f; /* Largest valid colour, 0xffffff (white). */
        *coat = (struct species_coat){ .back = whole_of(life, "back", colour),
                                       .flank = whole_of(life, "flank", colour),
                                       .belly = whole_of(life, "belly", colour),
                                       .fin = whole_of(life, "fin", colour),
                                       .iris = whole_of(life, "iris", colour),
                                       .clear = (uint8_t)whole_of(life, "clear", 255.0f),
                                       .shine = (uint8_t)whole_of(life, "shine", 255.0f) };
    }
    m->has_life = true;
    static const char *const names[] = { "TL", "SL", "FL", "DW" };
    const struct aiMetadataEntry *entry = find_extra(f, "measure");
    m->measure = MEASURE_TOTAL;
    for (uint8_t i = 0; entry && entry->mType == AI_AISTRING && i < 4; i++) {
        if (strcmp(((const struct aiString *)entry->mData)->data, names[i]) == 0) {
            m->measure = i;
        }
    }
}

static bool refuse_scene(struct flattening *f, const char *text)
{
    snprintf(f->why, IMPORT_WHY_SIZE, "%.110s", text);
    for (char *c = f->why; *c; c++) {
        *c = *c >= ' ' && *c < 127 ? *c : ' '; /* The message may quote the file, so unprintable
                                                  characters are replaced. */
    }
    return false;
}

/* Callback for assimp's log messages. assimp drops faces with invalid vertex indices, and reports
 * the dropped faces only in its log. */
static void listen(const char *line, char *heard)
{
    if (strstr(line, "out-of-range indices")) {
        *heard = 1;
    }
}

static bool flatten(struct flattening *f)
{
    struct import_mesh *mesh = f->mesh;
    if (!f->scene->mRootNode || f->scene->mNumMeshes == 0) {
        return import_flat_error(f, "no mesh");
    }
    const struct aiMetadata *data = f->scene->mMetaData;
    mesh->is_ours = false;
    for (uint32_t i = 0; data && i < data->mNumProperties; i++) {
        if (strcmp(data->mKeys[i].data, "SourceAsset_Generator") == 0 &&
            data->mValues[i].mType == AI_AISTRING) {
            const char *generator = ((const struct aiString *)data->mValues[i].mData)->data;
            mesh->is_ours =
                strncmp(generator, "kingyo", 6) == 0 || strncmp(generator, "Kingyo", 6) == 0;
            break;
        }
    }
    if (!import_keys_choose(f) || !import_keys_read_weights(f)) {
        return false;
    }
    if (!import_nodes_fill(&f->standing, f->scene)) {
        return import_flat_error(f, "more than 4096 nodes");
    }
    memcpy(mesh->scales, f->standing.scales, sizeof mesh->scales);
    read_life(f);
    return import_shapes_add_meshes(f) &&
           (mesh->triangle_count > 0 || import_flat_error(f, "no triangles"));
}

bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE])
{
    static struct flattening f;
    struct assimp assimp;
    memset(&f, 0, sizeof f);
    f.mesh = mesh;
    f.why = why;
    if (!load_assimp(&assimp)) {
        return import_flat_error(&f, "libassimp is gone");
    }
    char dropped = 0;
    const struct aiLogStream log = { listen, &dropped };
    assimp.attach(&log);
    f.scene = assimp.read(path, aiProcess_Triangulate);
    assimp.detach();
    if (!f.scene) {
        return refuse_scene(&f, assimp.error());
    }
    const bool good =
        dropped ? import_flat_error(&f, "a triangle that names a vertex that is not there")
                : flatten(&f);
    assimp.release(f.scene);
    return good;
}

#else /* The following functions replace the import in a build without assimp. */

bool import_flat_is_available(void)
{
    return false;
}

bool import_can_flatten(char why[IMPORT_WHY_SIZE])
{
    snprintf(why, IMPORT_WHY_SIZE,
             "this kingyoctl was built without assimp, which reads all but "
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
