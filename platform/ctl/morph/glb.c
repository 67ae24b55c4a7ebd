/* glb.c -- writes binary glTF 2.0 files: the general parts of a file, and the life of a fish. The
 * sections of the specification are 3.6 (buffers and accessors) and 4 (the binary container). */
#include "platform/ctl/morph/glb.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "platform/ctl/lib/caption.h"
#include "platform/os/file.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "glTF is little-endian; so is memory");

/* Magic number of a binary glTF file: the characters "glTF" in little-endian order. */
#define MAGIC 0x46546c67u
#define CHUNK_JSON 0x4e4f534au
#define CHUNK_BIN 0x004e4942u

enum component { UNSIGNED_BYTE = 5121, UNSIGNED_SHORT = 5123, FLOAT = 5126 };
enum target { NO_TARGET = 0, ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963 };

static const struct {
    const char *name;
    uint32_t width;
} types[] = {
    [GLB_SCALAR] = { "SCALAR", 1 }, [GLB_VEC2] = { "VEC2", 2 },  [GLB_VEC3] = { "VEC3", 3 },
    [GLB_VEC4] = { "VEC4", 4 },     [GLB_MAT4] = { "MAT4", 16 },
};

static const struct {
    enum component component;
    uint32_t component_size;
    enum target target;
    bool is_bounded;
} uses[] = {
    [GLB_FOR_VERTICES] = { FLOAT, 4, ARRAY_BUFFER, false },
    [GLB_FOR_PLACES] = { FLOAT, 4, ARRAY_BUFFER, true },
    [GLB_FOR_TIMES] = { FLOAT, 4, NO_TARGET, true },
    [GLB_FOR_DATA] = { FLOAT, 4, NO_TARGET, false },
    [GLB_FOR_TRIANGLES] = { UNSIGNED_SHORT, 2, ELEMENT_ARRAY_BUFFER, false },
    [GLB_FOR_JOINTS] = { UNSIGNED_BYTE, 1, ARRAY_BUFFER, false },
};

static bool stream_open(struct json *stream)
{
    *stream = (struct json){ 0 };
    stream->file = open_memstream(&stream->buffer, &stream->size);
    return stream->file != NULL;
}

uint32_t glb_next(struct glb *glb, enum glb_list list)
{
    CORE_ASSERT(list < GLB_LIST_COUNT);
    json_line(&glb->lists[list], 0);
    return glb->counts[list]++;
}

static void pad_to_four_bytes(FILE *file, char with)
{
    while (ftell(file) % 4 != 0 && !ferror(file)) {
        fputc(with, file);
    }
}

/* Adds the property `name`, a list with the minimum (`sign` -1) or the maximum (`sign` 1) of each
 * component of the values. */
static void add_bound(struct json *out, const char *name, float sign, const float *values,
                      uint32_t width, uint32_t count)
{
    json_open(out, name, '[');
    for (uint32_t k = 0; k < width; k++) {
        float bound = values[k];
        for (uint32_t i = 1; i < count; i++) {
            const float value = values[i * width + k];
            bound = sign * value > sign * bound ? value : bound;
        }
        /* With 17 digits, a reader gets exactly the float that is in the buffer. */
        json_value(out, NULL, "%.17g", (double)bound);
    }
    json_close(out, ']');
}

uint32_t glb_array(struct glb *glb, enum glb_use use, enum glb_type type, const void *data,
                   uint32_t count)
{
    CORE_ASSERT(count >= 1 && type <= GLB_MAT4 && use <= GLB_FOR_JOINTS);
    const uint32_t width = types[type].width;
    const size_t size = (size_t)count * width * uses[use].component_size;
    FILE *buffer = glb->lists[GLB_BUFFER].file;
    const long offset = ftell(buffer);
    struct json *views = &glb->lists[GLB_VIEWS], *out = &glb->lists[GLB_ACCESSORS];
    fwrite(data, 1, size, buffer);
    pad_to_four_bytes(buffer, '\0');
    const uint32_t view = glb_next(glb, GLB_VIEWS), accessor = glb_next(glb, GLB_ACCESSORS);
    json_print(views, "{buffer: %u, byteOffset: %zu, byteLength: %zu", 0u, (size_t)offset, size);
    if (uses[use].target != NO_TARGET) {
        json_value(views, "target", "%d", (int)uses[use].target);
    }
    json_close(views, '}');
    json_print(out, "{bufferView: %u, componentType: %d, count: %u, type: %s", view,
               (int)uses[use].component, count, types[type].name);
    if (uses[use].is_bounded) {
        add_bound(out, "min", -1.0f, data, width, count);
        add_bound(out, "max", 1.0f, data, width, count);
    }
    json_close(out, '}');
    return accessor;
}

/* ---- Output file ----------------------------------------------------------------------------- */

static void add_list(struct json *out, const struct glb *glb, const char *name, enum glb_list list)
{
    if (glb->lists[list].size > 0) {
        json_line(out, 0);
        json_open(out, name, '[');
        fwrite(glb->lists[list].buffer, 1, glb->lists[list].size, out->file);
        json_close(out, ']');
    }
}

/* Completes `buffer` and `size` of a stream. Returns false if a write to the stream failed. */
static bool stream_flush(struct json *stream)
{
    return fflush(stream->file) == 0 && !ferror(stream->file);
}

static void stream_free(struct json *stream)
{
    if (stream->file) {
        fclose(stream->file);
    }
    free(stream->buffer);
}

/* Writes the file to `path`. The animation "growth" contains all samplers and channels. Returns 0
 * or a negative errno. -ENOMEM means that an earlier memory allocation failed and `glb` is
 * incomplete. */
static int write_file(struct glb *glb, const char *path)
{
    CORE_ASSERT(path);
    struct json document;
    struct atomic_file file;
    bool is_whole = stream_open(&document);
    for (uint32_t i = 0; is_whole && i < GLB_LIST_COUNT; i++) {
        is_whole = stream_flush(&glb->lists[i]);
    }
    if (is_whole) {
        struct json *out = &document;
        json_print(out, "{asset: {version: %s, generator: %s},\nscene: %u, scenes: [{", "2.0",
                   "kingyoctl " KINGYO_VERSION, 0u);
        add_list(out, glb, "nodes", GLB_SCENE);
        json_print(out, "}]");
        add_list(out, glb, "nodes", GLB_NODES);
        add_list(out, glb, "meshes", GLB_MESHES);
        add_list(out, glb, "skins", GLB_SKINS);
        add_list(out, glb, "materials", GLB_MATERIALS);
        json_print(out, "\nanimations: [{name: %s", "growth");
        add_list(out, glb, "channels", GLB_CHANNELS);
        add_list(out, glb, "samplers", GLB_SAMPLERS);
        json_print(out, "}]");
        add_list(out, glb, "accessors", GLB_ACCESSORS);
        add_list(out, glb, "bufferViews", GLB_VIEWS);
        json_print(out, "\nbuffers: [{byteLength: %zu}]}", glb->lists[GLB_BUFFER].size);
        pad_to_four_bytes(out->file, ' ');
        is_whole = stream_flush(&document);
    }
    int error = is_whole ? file_atomic_open(&file, path) : -ENOMEM;
    if (error == 0) {
        const uint32_t json_size = (uint32_t)document.size,
                       size = (uint32_t)glb->lists[GLB_BUFFER].size;
        const uint32_t head[] = { MAGIC, 2, 12 + 8 + json_size + 8 + size, json_size, CHUNK_JSON };
        const uint32_t binary[] = { size, CHUNK_BIN };
        fwrite(head, 1, sizeof head, file.file);
        fwrite(document.buffer, 1, document.size, file.file);
        fwrite(binary, 1, sizeof binary, file.file);
        fwrite(glb->lists[GLB_BUFFER].buffer, 1, glb->lists[GLB_BUFFER].size, file.file);
        error = file_atomic_close(&file);
    }
    stream_free(&document);
    return error;
}

/* ---- Life of a fish -------------------------------------------------------------------------- */

/* This section writes the whole life of a fish with nodes, a skin and an animation.
 *
 * The scene has one node for the fish, whose animated scale gives the size of the fish. The fish
 * faces +z, as glTF requires. Each piece of the fish has a node with a mesh below the fish's node.
 *
 * A part that is anchored to the body's surface is skinned in the sense of glTF. Each anchor is a
 * joint, and each vertex depends on one joint only. glTF first blends the morph targets and then
 * applies the joints, as morph_shape() does, so the result is exact. Nodes could not replace the
 * joints, because neighbouring rays of a fin have different anchors but share triangles.
 *
 * The animation "growth" has GLB_SECONDS seconds from progress 0 to 1. It contains the weights of
 * the deformation graph, the size and the joints. If the graph is solved, the weights are those of
 * the solved shapes, which stay in [0, 1]. */

/* Fish whose file is being written. The variable is static because it is too large for a stack. */
static struct morph_glb fish;

/* Adds the node of the fish, with metadata of the species: its keys with their progress, age,
 * length and colours. Must be called after all meshes were added. */
static void add_fish_node(struct json *out)
{
    const struct species_card *card = &fish.pick->fish->card;
    const double size = (double)life_length_m(card, 1.0f);
    glb_next(&fish.file, GLB_NODES);
    json_print(out, "{name: %s, rotation: [%u, %u, %u, %u], scale: [%.9g, %.9g, %.9g], children: [",
               card->id, 0u, 1u, 0u, 0u, size, size, size);
    for (uint32_t i = 0; i < fish.cut.piece_count + fish.mesh->anchor_count; i++) {
        if (i >= fish.cut.piece_count || !fish.skinned[i]) {
            json_value(out, NULL, "%u", GLB_PIECE_NODE + i);
        }
    }
    json_print(out, "], extras: {species: %s, measure: %s, template: %s, thesis: %hhd,", card->id,
               caption_measure(card), morph_template_name(fish.pick->template_id),
               fish.pick->thesis);
    json_print(out, "seconds: %.6g, keys: [", (double)GLB_SECONDS);
    for (uint32_t i = 0; i < card->key_count; i++) {
        json_print(out, "{name: %s, progress: %.6g, age_days: %.6g, length_m: %.6g,",
                   card->key_names[i], (double)i / (card->key_count - 1u),
                   (double)card->key_age_days[i], (double)card->key_length_m[i]);
        /* Colours are 0xRRGGBB numbers. The spots and stripes of the skin are not printed. */
        const struct species_coat *coat = &fish.pick->fish->coats[i];
        json_print(out, "back: %u, flank: %u, belly: %u, fin: %u, iris: %u, clear: %u, shine: %u}",
                   coat->back, coat->flank, coat->belly, coat->fin, coat->iris, coat->clear,
                   coat->shine);
    }
    json_print(out, "]}}");
}

/* Computes the inverse of an anchor's pose at progress 1, as a column-major 4 x 4 matrix for
 * glTF. */
static void inverse_bind(const struct anchor_pose *at, float out[16])
{
    const vec3 columns[4] = { v3(1.0f, 0.0f, 0.0f), v3(0.0f, 1.0f, 0.0f), v3(0.0f, 0.0f, 1.0f),
                              v3_scale(at->position, -1.0f) };
    memset(out, 0, 16 * sizeof *out);
    for (uint32_t column = 0; column < 4; column++) {
        const vec3 to = pose_rotate_inverse(at->turn, columns[column]);
        memcpy(&out[4 * column], &to, sizeof to);
    }
    out[15] = 1.0f;
}

static void add_skin(void)
{
    static float matrices[1u + ANCHOR_MAX][16];
    const struct anchor_pose here = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };
    struct json *out = &fish.file.lists[GLB_SKINS];
    inverse_bind(&here, matrices[0]);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        inverse_bind(&fish.adult.anchor[i], matrices[1u + i]);
    }
    glb_next(&fish.file, GLB_SKINS);
    json_print(
        out, "{name: %s, skeleton: %u, inverseBindMatrices: %u, joints: [%u", "skin", GLB_ROOT_NODE,
        glb_array(&fish.file, GLB_FOR_DATA, GLB_MAT4, matrices[0], 1u + fish.mesh->anchor_count),
        GLB_ROOT_NODE);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        json_value(out, NULL, "%u", GLB_PIECE_NODE + fish.cut.piece_count + i);
    }
    json_print(out, "]}");
}

static void add_nodes(void)
{
    struct json *out = &fish.file.lists[GLB_NODES], *scene = &fish.file.lists[GLB_SCENE];
    const uint32_t piece_count = fish.cut.piece_count;
    CORE_ASSERT(piece_count <= PIECE_MAX);
    uint32_t meshes[PIECE_MAX];
    char name[PIECE_NAME_SIZE];
    bool skinned = false;
    for (uint32_t i = 0; i < piece_count; i++) {
        meshes[i] = morph_glb_add_mesh(&fish, i);
    }
    json_value(scene, NULL, "%u", GLB_ROOT_NODE);
    add_fish_node(out);
    for (uint32_t i = 0; i < piece_count; i++) {
        morph_piece_name(&fish.cut.pieces[i], name);
        glb_next(&fish.file, GLB_NODES);
        json_print(out, "{name: %s, mesh: %u", name, meshes[i]);
        if (fish.skinned[i]) {
            /* glTF ignores the node of a skinned mesh and moves the mesh only by its joints. The
             * node is therefore a root node beside the fish's node. */
            json_value(scene, NULL, "%u", GLB_PIECE_NODE + i);
            json_value(out, "skin", "0");
            skinned = true;
        }
        json_close(out, '}');
    }
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        const struct anchor_pose *at = &fish.adult.anchor[i];
        glb_next(&fish.file, GLB_NODES);
        snprintf(name, sizeof name, "anchor_%u", i);
        json_print(
            out, "{name: %s, translation: [%.9g, %.9g, %.9g], rotation: [%.9g, %.9g, %.9g, %.9g]}",
            name, (double)at->position.x, (double)at->position.y, (double)at->position.z,
            (double)at->turn.x, (double)at->turn.y, (double)at->turn.z, (double)at->turn.w);
    }
    if (skinned) {
        add_skin();
    }
}

enum exit_code morph_glb_write(const struct morph_options *pick, const char *path)
{
    CORE_ASSERT(pick->fish && path);
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    memset(&fish, 0, sizeof fish);
    fish.pick = pick;
    fish.mesh = &pick->fish->lod[0];
    morph_pose(&pick->rig, fish.mesh, 1.0f, &fish.adult);
    morph_shape(fish.mesh, pick->rig.key_count, &fish.adult, positions, normals);
    morph_mesh_cut(fish.mesh, positions, normals, &fish.cut);
    for (uint32_t key = 0; key < pick->rig.key_count; key++) {
        float alone[MORPH_KEY_MAX] = { 0 };
        alone[key] = 1.0f;
        morph_mesh_paint(pick->fish, alone, &fish.cut, fish.paints[key]);
    }
    int error = -ENOMEM;
    bool is_open = true;
    for (uint32_t i = 0; is_open && i < GLB_LIST_COUNT; i++) {
        is_open = stream_open(&fish.file.lists[i]);
    }
    if (is_open) {
        add_nodes();
        error = morph_glb_animate(&fish) ? write_file(&fish.file, path) : -ENOMEM;
    }
    for (uint32_t i = 0; i < GLB_LIST_COUNT; i++) {
        stream_free(&fish.file.lists[i]);
    }
    return morph_written("export", path, error);
}
