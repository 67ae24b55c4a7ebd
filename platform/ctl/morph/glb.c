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

#define MAGIC 0x46546c67u /* The characters "glTF" as a little-endian number. */
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

static bool stream_open(struct glb_stream *stream)
{
    *stream = (struct glb_stream){ 0 };
    stream->file = open_memstream(&stream->data, &stream->size);
    return stream->file != NULL;
}

uint32_t glb_next(struct glb *glb, enum glb_list list)
{
    CORE_ASSERT(list < GLB_LIST_COUNT);
    if (glb->counts[list] > 0) {
        fputs(",\n", glb->lists[list].file);
    }
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
static void add_bound(FILE *out, const char *name, float sign, const float *values, uint32_t width,
                      uint32_t count)
{
    fprintf(out, ",\"%s\":[", name);
    for (uint32_t k = 0; k < width; k++) {
        float bound = values[k];
        for (uint32_t i = 1; i < count; i++) {
            const float value = values[i * width + k];
            bound = sign * value > sign * bound ? value : bound;
        }
        /* 17 digits allow a reader to recover exactly the float in the buffer. */
        fprintf(out, "%s%.17g", k > 0 ? "," : "", (double)bound);
    }
    fprintf(out, "]");
}

uint32_t glb_array(struct glb *glb, enum glb_use use, enum glb_type type, const void *data,
                   uint32_t count)
{
    CORE_ASSERT(count >= 1 && type <= GLB_MAT4 && use <= GLB_FOR_JOINTS);
    const uint32_t width = types[type].width;
    const size_t size = (size_t)count * width * uses[use].component_size;
    const long offset = ftell(glb->lists[GLB_BUFFER].file);
    FILE *views = glb->lists[GLB_VIEWS].file, *out = glb->lists[GLB_ACCESSORS].file;
    fwrite(data, 1, size, glb->lists[GLB_BUFFER].file);
    pad_to_four_bytes(glb->lists[GLB_BUFFER].file, '\0');
    const uint32_t view = glb_next(glb, GLB_VIEWS), accessor = glb_next(glb, GLB_ACCESSORS);
    fprintf(views, "{\"buffer\":0,\"byteOffset\":%ld,\"byteLength\":%zu", offset, size);
    if (uses[use].target != NO_TARGET) {
        fprintf(views, ",\"target\":%d", (int)uses[use].target);
    }
    fprintf(views, "}");
    fprintf(out, "{\"bufferView\":%u,\"componentType\":%d,\"count\":%u,\"type\":\"%s\"", view,
            (int)uses[use].component, count, types[type].name);
    if (uses[use].is_bounded) {
        add_bound(out, "min", -1.0f, data, width, count);
        add_bound(out, "max", 1.0f, data, width, count);
    }
    fprintf(out, "}");
    return accessor;
}

/* ---- Output file ----------------------------------------------------------------------------- */

static void add_list(FILE *json, const struct glb *glb, const char *name, enum glb_list list)
{
    if (glb->counts[list] > 0) {
        fprintf(json, ",\n\"%s\":[", name);
        fwrite(glb->lists[list].data, 1, glb->lists[list].size, json);
        fputs("]", json);
    }
}

/* Completes `data` and `size` of a stream. Returns false if a write to the stream failed. */
static bool stream_flush(struct glb_stream *stream)
{
    return fflush(stream->file) == 0 && !ferror(stream->file);
}

static void stream_free(struct glb_stream *stream)
{
    if (stream->file) {
        fclose(stream->file);
    }
    free(stream->data);
}

/* Writes the file to `path`. `animation` is the name of the animation that contains all samplers
 * and channels. `scene` is a JSON list of the node numbers in the scene, for example "0,3". Returns
 * 0 or a negative errno. -ENOMEM means that an earlier memory allocation failed and `glb` is
 * incomplete. */
static int write_file(struct glb *glb, const char *path, const char *animation, const char *scene)
{
    CORE_ASSERT(path && animation && scene);
    struct glb_stream json;
    struct atomic_file file;
    bool is_whole = stream_open(&json);
    for (uint32_t i = 0; is_whole && i < GLB_LIST_COUNT; i++) {
        is_whole = stream_flush(&glb->lists[i]);
    }
    if (is_whole) {
        FILE *out = json.file;
        fprintf(out,
                "{\"asset\":{\"version\":\"2.0\",\"generator\":\"kingyoctl %s\"},\n"
                "\"scene\":0,\"scenes\":[{\"nodes\":[%s]}]",
                KINGYO_VERSION, scene);
        add_list(out, glb, "nodes", GLB_NODES);
        add_list(out, glb, "meshes", GLB_MESHES);
        add_list(out, glb, "skins", GLB_SKINS);
        add_list(out, glb, "materials", GLB_MATERIALS);
        fprintf(out, ",\n\"animations\":[{\"name\":\"%s\"", animation);
        add_list(out, glb, "channels", GLB_CHANNELS);
        add_list(out, glb, "samplers", GLB_SAMPLERS);
        fputs("}]", out);
        add_list(out, glb, "accessors", GLB_ACCESSORS);
        add_list(out, glb, "bufferViews", GLB_VIEWS);
        fprintf(out, ",\n\"buffers\":[{\"byteLength\":%zu}]}", glb->lists[GLB_BUFFER].size);
        pad_to_four_bytes(out, ' ');
        is_whole = stream_flush(&json);
    }
    int error = is_whole ? file_atomic_open(&file, path) : -ENOMEM;
    if (error == 0) {
        const uint32_t json_size = (uint32_t)json.size,
                       size = (uint32_t)glb->lists[GLB_BUFFER].size;
        const uint32_t head[] = { MAGIC, 2, 12 + 8 + json_size + 8 + size, json_size, CHUNK_JSON };
        const uint32_t binary[] = { size, CHUNK_BIN };
        fwrite(head, 1, sizeof head, file.file);
        fwrite(json.data, 1, json.size, file.file);
        fwrite(binary, 1, sizeof binary, file.file);
        fwrite(glb->lists[GLB_BUFFER].data, 1, glb->lists[GLB_BUFFER].size, file.file);
        error = file_atomic_close(&file);
    }
    stream_free(&json);
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

#define NAME_SIZE 2048u /* Size in bytes of a list of PIECE_MAX node numbers, with a margin. */

/* File that is being written. The variable is static because it is too large for a stack. */
static struct morph_glb fish;

/* Prints metadata of the species: its keys with their progress, age, length and colours. */
static void print_life(FILE *out)
{
    const struct species_card *card = &fish.pick->fish->card;
    fprintf(out,
            "\"extras\":{\"species\":\"%s\",\"measure\":\"%s\",\"template\":\"%s\","
            "\"thesis\":%s,\"seconds\":%g,\"keys\":[",
            card->id, caption_measure(card), morph_template_name(fish.pick->template_id),
            fish.pick->thesis ? "true" : "false", (double)GLB_SECONDS);
    for (uint32_t i = 0; i < card->key_count; i++) {
        fprintf(out, "%s{\"name\":\"%s\",\"progress\":%.6g,", i > 0 ? "," : "", card->key_names[i],
                (double)i / (card->key_count - 1u));
        fprintf(out, "\"age_days\":%.6g,\"length_m\":%.6g,", (double)card->key_age_days[i],
                (double)card->key_length_m[i]);
        /* Colours are 0xRRGGBB numbers. The spots and stripes of the skin are not printed. */
        const struct species_coat *coat = &fish.pick->fish->coats[i];
        fprintf(out, "\"back\":%u,\"flank\":%u,\"belly\":%u,\"fin\":%u,\"iris\":%u,", coat->back,
                coat->flank, coat->belly, coat->fin, coat->iris);
        fprintf(out, "\"clear\":%u,\"shine\":%u}", coat->clear, coat->shine);
    }
    fprintf(out, "]}");
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
    FILE *out = fish.file.lists[GLB_SKINS].file;
    inverse_bind(&here, matrices[0]);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        inverse_bind(&fish.adult.anchor[i], matrices[1u + i]);
    }
    glb_next(&fish.file, GLB_SKINS);
    fprintf(
        out,
        "{\"name\":\"skin\",\"skeleton\":%u,\"inverseBindMatrices\":%u,"
        "\"joints\":[%u",
        GLB_ROOT_NODE,
        glb_array(&fish.file, GLB_FOR_DATA, GLB_MAT4, matrices[0], 1u + fish.mesh->anchor_count),
        GLB_ROOT_NODE);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        fprintf(out, ",%u", GLB_PIECE_NODE + fish.cut.piece_count + i);
    }
    fprintf(out, "]}");
}

static void add_nodes(char scene[NAME_SIZE])
{
    const uint32_t piece_count = fish.cut.piece_count;
    CORE_ASSERT(piece_count <= PIECE_MAX);
    uint32_t meshes[PIECE_MAX];
    size_t used = (size_t)snprintf(scene, NAME_SIZE, "%u", GLB_ROOT_NODE);
    bool skinned = false;
    for (uint32_t i = 0; i < piece_count; i++) {
        meshes[i] = morph_glb_add_mesh(&fish, i);
    }
    FILE *out = fish.file.lists[GLB_NODES].file;
    const double size = (double)life_length_m(&fish.pick->fish->card, 1.0f);
    glb_next(&fish.file, GLB_NODES);
    fprintf(out, "{\"name\":\"%s\",\"rotation\":[0,1,0,0],\"scale\":[%.9g,%.9g,%.9g],",
            fish.pick->fish->card.id, size, size, size);
    const char *comma = "\"children\":[";
    for (uint32_t i = 0; i < piece_count + fish.mesh->anchor_count; i++) {
        if (i >= piece_count || !fish.skinned[i]) {
            fprintf(out, "%s%u", comma, GLB_PIECE_NODE + i);
            comma = ",";
        }
    }
    fprintf(out, "],");
    print_life(out);
    fprintf(out, "}");
    for (uint32_t i = 0; i < piece_count; i++) {
        char name[PIECE_NAME_SIZE];
        morph_piece_name(&fish.cut.pieces[i], name);
        glb_next(&fish.file, GLB_NODES);
        fprintf(fish.file.lists[GLB_NODES].file, "{\"name\":\"%s\",\"mesh\":%u%s}", name, meshes[i],
                fish.skinned[i] ? ",\"skin\":0" : "");
        if (fish.skinned[i]) {
            /* glTF ignores the node of a skinned mesh and moves the mesh only by its joints. The
             * node is therefore a root node beside the fish's node. */
            used += (size_t)snprintf(scene + used, NAME_SIZE - used, ",%u", GLB_PIECE_NODE + i);
            skinned = true;
        }
    }
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        const struct anchor_pose *at = &fish.adult.anchor[i];
        glb_next(&fish.file, GLB_NODES);
        fprintf(fish.file.lists[GLB_NODES].file,
                "{\"name\":\"anchor_%u\",\"translation\":[%.9g,%.9g,%.9g],"
                "\"rotation\":[%.9g,%.9g,%.9g,%.9g]}",
                i, (double)at->position.x, (double)at->position.y, (double)at->position.z,
                (double)at->turn.x, (double)at->turn.y, (double)at->turn.z, (double)at->turn.w);
    }
    if (skinned) {
        add_skin();
    }
}

enum exit_code morph_glb_write(const struct morph_options *pick, const char *path)
{
    CORE_ASSERT(pick->fish && path);
    char scene[NAME_SIZE];
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
        add_nodes(scene);
        error = morph_glb_animate(&fish) ? write_file(&fish.file, path, "growth", scene) : -ENOMEM;
    }
    for (uint32_t i = 0; i < GLB_LIST_COUNT; i++) {
        stream_free(&fish.file.lists[i]);
    }
    return morph_written("export", path, error);
}
