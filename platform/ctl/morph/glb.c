/* glb.c -- the writer of binary glTF 2.0 files. The sections of the specification are 3.6 (buffers
 * and accessors) and 4 (the binary container). */
#include "platform/ctl/morph/glb.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/core.h"
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

uint32_t glb_next(struct glb *glb, enum glb_list list)
{
    CORE_ASSERT(list < GLB_LIST_COUNT);
    if (glb->counts[list] > 0) {
        byte_buffer_add(&glb->lists[list], ",\n", 2);
    }
    return glb->counts[list]++;
}

static void pad_to_four_bytes(struct byte_buffer *bytes, char with)
{
    while (bytes->size % 4u != 0 && !bytes->failed) {
        byte_buffer_add(bytes, &with, 1);
    }
}

static uint32_t add_view(struct glb *glb, const void *data, size_t size, enum target target)
{
    const size_t offset = glb->buffer.size;
    const uint32_t view = glb_next(glb, GLB_VIEWS);
    byte_buffer_add(&glb->buffer, data, size);
    pad_to_four_bytes(&glb->buffer, '\0');
    byte_buffer_print(&glb->lists[GLB_VIEWS], "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu",
                      offset, size);
    if (target != NO_TARGET) {
        byte_buffer_print(&glb->lists[GLB_VIEWS], ",\"target\":%d", (int)target);
    }
    byte_buffer_print(&glb->lists[GLB_VIEWS], "}");
    return view;
}

/* Adds the property `name`, a list with the minimum (`sign` -1) or the maximum (`sign` 1) of each
 * component of the values. */
static void add_bound(struct byte_buffer *out, const char *name, float sign, const float *values,
                      uint32_t width, uint32_t count)
{
    byte_buffer_print(out, ",\"%s\":[", name);
    for (uint32_t k = 0; k < width; k++) {
        float bound = values[k];
        for (uint32_t i = 1; i < count; i++) {
            const float value = values[i * width + k];
            bound = sign * value > sign * bound ? value : bound;
        }
        /* 17 digits allow a reader to recover exactly the float in the buffer. */
        byte_buffer_print(out, "%s%.17g", k > 0 ? "," : "", (double)bound);
    }
    byte_buffer_print(out, "]");
}

/* Starts the accessor of a view. The caller adds the closing brace. */
static uint32_t add_accessor(struct glb *glb, uint32_t view, enum component component,
                             uint32_t count, enum glb_type type)
{
    const uint32_t accessor = glb_next(glb, GLB_ACCESSORS);
    byte_buffer_print(&glb->lists[GLB_ACCESSORS],
                      "{\"bufferView\":%u,\"componentType\":%d,\"count\":%u,\"type\":\"%s\"", view,
                      (int)component, count, types[type].name);
    return accessor;
}

uint32_t glb_floats(struct glb *glb, enum glb_use use, enum glb_type type, const float *values,
                    uint32_t count)
{
    CORE_ASSERT(count >= 1);
    CORE_ASSERT(type <= GLB_MAT4);
    const uint32_t width = types[type].width;
    const bool of_vertices = use == GLB_FOR_VERTICES || use == GLB_FOR_PLACES;
    const uint32_t view = add_view(glb, values, (size_t)count * width * sizeof *values,
                                   of_vertices ? ARRAY_BUFFER : NO_TARGET);
    const uint32_t accessor = add_accessor(glb, view, FLOAT, count, type);
    struct byte_buffer *out = &glb->lists[GLB_ACCESSORS];
    if (use == GLB_FOR_PLACES || use == GLB_FOR_TIMES) {
        add_bound(out, "min", -1.0f, values, width, count);
        add_bound(out, "max", 1.0f, values, width, count);
    }
    byte_buffer_print(out, "}");
    return accessor;
}

uint32_t glb_indices(struct glb *glb, const uint16_t *indices, uint32_t count)
{
    CORE_ASSERT(count >= 3 && count % 3 == 0);
    const uint32_t view =
        add_view(glb, indices, (size_t)count * sizeof *indices, ELEMENT_ARRAY_BUFFER);
    const uint32_t accessor = add_accessor(glb, view, UNSIGNED_SHORT, count, GLB_SCALAR);
    byte_buffer_print(&glb->lists[GLB_ACCESSORS], "}");
    return accessor;
}

uint32_t glb_joints(struct glb *glb, const uint8_t (*joints)[4], uint32_t count)
{
    CORE_ASSERT(count >= 1);
    const uint32_t view = add_view(glb, joints, (size_t)count * 4u, ARRAY_BUFFER);
    const uint32_t accessor = add_accessor(glb, view, UNSIGNED_BYTE, count, GLB_VEC4);
    byte_buffer_print(&glb->lists[GLB_ACCESSORS], "}");
    return accessor;
}

/* ---- Output file ----------------------------------------------------------------------------- */

static void add_list(struct byte_buffer *json, const struct glb *glb, const char *name,
                     enum glb_list list)
{
    if (glb->counts[list] > 0) {
        byte_buffer_print(json, ",\n\"%s\":[", name);
        byte_buffer_add(json, glb->lists[list].data, glb->lists[list].size);
        byte_buffer_print(json, "]");
    }
}

int glb_write(struct glb *glb, const char *path, const char *animation, const char *scene)
{
    CORE_ASSERT(path && animation && scene);
    struct byte_buffer json = { 0 };
    byte_buffer_print(&json,
                      "{\"asset\":{\"version\":\"2.0\",\"generator\":\"kingyoctl %s\"},\n"
                      "\"scene\":0,\"scenes\":[{\"nodes\":[%s]}]",
                      KINGYO_VERSION, scene);
    add_list(&json, glb, "nodes", GLB_NODES);
    add_list(&json, glb, "meshes", GLB_MESHES);
    add_list(&json, glb, "skins", GLB_SKINS);
    add_list(&json, glb, "materials", GLB_MATERIALS);
    byte_buffer_print(&json, ",\n\"animations\":[{\"name\":\"%s\"", animation);
    add_list(&json, glb, "channels", GLB_CHANNELS);
    add_list(&json, glb, "samplers", GLB_SAMPLERS);
    byte_buffer_print(&json, "}]");
    add_list(&json, glb, "accessors", GLB_ACCESSORS);
    add_list(&json, glb, "bufferViews", GLB_VIEWS);
    byte_buffer_print(&json, ",\n\"buffers\":[{\"byteLength\":%zu}]}", glb->buffer.size);
    pad_to_four_bytes(&json, ' ');
    bool whole = !json.failed && !glb->buffer.failed;
    for (uint32_t i = 0; i < GLB_LIST_COUNT; i++) {
        whole = whole && !glb->lists[i].failed;
    }
    struct atomic_file out;
    int error = whole ? file_atomic_open(&out, path) : -ENOMEM;
    if (error == 0) {
        const uint32_t json_size = (uint32_t)json.size, size = (uint32_t)glb->buffer.size;
        const uint32_t head[] = { MAGIC, 2, 12 + 8 + json_size + 8 + size, json_size, CHUNK_JSON };
        const uint32_t binary[] = { size, CHUNK_BIN };
        fwrite(head, 1, sizeof head, out.file);
        fwrite(json.data, 1, json.size, out.file);
        fwrite(binary, 1, sizeof binary, out.file);
        fwrite(glb->buffer.data, 1, glb->buffer.size, out.file);
        error = file_atomic_close(&out);
    }
    byte_buffer_free(&json);
    return error;
}

void glb_free(struct glb *glb)
{
    byte_buffer_free(&glb->buffer);
    for (uint32_t i = 0; i < GLB_LIST_COUNT; i++) {
        byte_buffer_free(&glb->lists[i]);
    }
}
