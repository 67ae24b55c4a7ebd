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

/* Names of the library file. The loader tries the names in this order. The first name is the
 * version whose headers this program was built with. */
static const char *const libraries[] = { "libassimp.so.5", "libassimp.so" };

struct assimp {
    const struct aiScene *(*read)(const char *path, unsigned int flags);
    const char *(*error)(void);
    void (*release)(const struct aiScene *scene);
    void (*attach)(const struct aiLogStream *log);
    void (*detach)(void);
};

/* Loads the library and its functions. Each pointer is copied as bytes, because C does not allow
 * the conversion of an object pointer to a function pointer. POSIX guarantees that the two have the
 * same representation. */
static bool load_assimp(struct assimp *assimp)
{
    const struct {
        const char *name;
        void *function;
    } symbols[] = { { "aiImportFile", &assimp->read },
                    { "aiGetErrorString", &assimp->error },
                    { "aiReleaseImport", &assimp->release },
                    { "aiAttachLogStream", &assimp->attach },
                    { "aiDetachAllLogStreams", &assimp->detach } };
    void *library = NULL;
    for (size_t i = 0; !library && i < sizeof libraries / sizeof libraries[0]; i++) {
        library = dlopen(libraries[i], RTLD_NOW | RTLD_LOCAL);
    }
    bool is_loaded = library != NULL;
    for (size_t i = 0; is_loaded && i < sizeof symbols / sizeof symbols[0]; i++) {
        void *const symbol = dlsym(library, symbols[i].name);
        memcpy(symbols[i].function, &symbol, sizeof symbol);
        is_loaded = symbol != NULL;
    }
    return is_loaded;
}

bool import_can_flatten(char why[IMPORT_WHY_SIZE])
{
    struct assimp assimp;
    return load_assimp(&assimp) ||
           import_error(why, "the library libassimp, which reads all formats except .obj and .txt, "
                             "is missing (on Debian: apt install libassimp-dev)");
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

/* Returns the text of a metadata entry, or null if the entry is null or has no text. */
static const char *text_of(const struct aiMetadataEntry *entry)
{
    return entry && entry->mType == AI_AISTRING ? ((const struct aiString *)entry->mData)->data
                                                : NULL;
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
        const char *name = text_of(entry_of(life, "name"));
        if (name) {
            snprintf(m->key_names[key], IMPORT_NAME_SIZE, "%.40s", name);
        }
        m->ages_days[key] = number_of(life, "age_days");
        m->lengths_m[key] = number_of(life, "length_m");
        m->has_coats = m->has_coats && entry_of(life, "back");
        struct species_coat *coat = &m->coats[key];
        const float colour = 16777215.0f; /* Largest valid colour (0xffffff, white) as a number. */
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
    const char *measure = text_of(find_extra(f, "measure"));
    m->measure = MEASURE_TOTAL;
    for (uint8_t i = 0; measure && i < 4; i++) {
        m->measure = strcmp(measure, names[i]) == 0 ? i : m->measure;
    }
}

/* Callback for assimp's log messages. assimp drops faces with invalid vertex indices, and reports
 * the dropped faces only in its log. */
static void detect_dropped_faces(const char *line, char *is_dropped)
{
    if (strstr(line, "out-of-range indices")) {
        *is_dropped = 1;
    }
}

static bool flatten(struct flattening *f)
{
    struct import_mesh *mesh = f->mesh;
    if (!f->scene->mRootNode || f->scene->mNumMeshes == 0) {
        return import_error(f->why, "no mesh");
    }
    const char *generator = text_of(entry_of(f->scene->mMetaData, "SourceAsset_Generator"));
    mesh->is_ours = generator && strncasecmp(generator, "kingyo", 6) == 0;
    if (!import_keys_choose(f) || !import_keys_read_weights(f)) {
        return false;
    }
    if (!import_nodes_fill(&f->standing, f->scene)) {
        return import_error(f->why, "more than 4096 nodes");
    }
    memcpy(mesh->scales, f->standing.scales, sizeof mesh->scales);
    read_life(f);
    return import_shapes_add_meshes(f) &&
           (mesh->triangle_count > 0 || import_error(f->why, "no triangles"));
}

bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE])
{
    static struct flattening f;
    struct assimp assimp;
    memset(&f, 0, sizeof f);
    f.mesh = mesh;
    f.why = why;
    if (!load_assimp(&assimp)) {
        return import_error(why, "libassimp cannot be loaded");
    }
    char dropped = 0;
    const struct aiLogStream log = { detect_dropped_faces, &dropped };
    assimp.attach(&log);
    f.scene = assimp.read(path, aiProcess_Triangulate);
    assimp.detach();
    if (!f.scene) {
        return import_error(why, "%.110s", assimp.error());
    }
    const bool good =
        dropped ? import_error(why, "a triangle refers to a missing vertex") : flatten(&f);
    assimp.release(f.scene);
    return good;
}

#else /* The following functions replace the import in a build without assimp. */

bool import_can_flatten(char why[IMPORT_WHY_SIZE])
{
    return import_error(why,
                        "this kingyoctl was built without assimp, which reads all formats except "
                        ".obj and .txt (on Debian: apt install libassimp-dev, then build again)");
}

bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE])
{
    (void)path;
    (void)mesh;
    return import_can_flatten(why);
}

#endif
