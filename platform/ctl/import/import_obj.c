/* import_obj.c -- a strict parser of Wavefront OBJ files, which reads vertices, texture
 * coordinates, faces and group names.
 *
 * Normals are skipped because they are computed from the positions. Materials, smoothing groups,
 * lines and points are skipped because they do not change the shape.
 *
 * The library assimp reads OBJ files too, but it keeps neither the number nor the order of the
 * vertices: a file with five vertices becomes a mesh of four or six. The key shapes of a fish
 * correspond by the vertex numbers of their files, so this parser is needed. */
#include "platform/ctl/import/import.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/os/file.h"

#define LINE_SIZE 4096 /* Longest line in characters. A face with 300 corners fits on one line. */
#define CORNER_MAX 256

struct obj {
    struct import_mesh *mesh;
    uint32_t key;
    const char *path;
    char *why;
    uint32_t line;
    uint32_t vertex_count, uv_count, triangle_count;
    uint32_t group;
    float uv[IMPORT_VERTEX_MAX][2]; /* Texture coordinates in the order of the `vt` lines. */
};

__attribute__((format(printf, 2, 3))) static bool import_obj_error(struct obj *o,
                                                                   const char *format, ...)
{
    char text[IMPORT_WHY_SIZE / 2];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    printable(text);
    snprintf(o->why, IMPORT_WHY_SIZE, "%.80s:%u: %s", o->path, o->line, text);
    return false;
}

/* Parses up to `count` numbers in `text`. Returns the number of parsed numbers, or -1 after
 * import_obj_error(). */
static int parse_obj_numbers(struct obj *o, const char *text, float *out, int count)
{
    for (int i = 0; i < count; i++) {
        char *end = NULL;
        const float value = strtof(text, &end);
        if (end == text) {
            return i;
        }
        if (!(fabsf(value) <= IMPORT_REACH_MAX)) {
            const char *word = text + strspn(text, " \t");
            const size_t length = strcspn(word, " \t\r\n");
            import_obj_error(o, "'%.*s' is not a number from %g to %g",
                             (int)(length < 20 ? length : 20), word, -(double)IMPORT_REACH_MAX,
                             (double)IMPORT_REACH_MAX);
            return -1;
        }
        out[i] = value;
        text = end;
    }
    return count;
}

/* Returns true if the mesh has space for one more element than `count`. A file of a later key shape
 * has space for `first_count` elements, as many as the file of the first key shape has. */
static bool has_space(struct obj *o, const char *elements, uint32_t count, uint32_t max,
                      uint32_t first_count)
{
    const uint32_t limit = o->key == 0 ? max : first_count;
    return count < limit || import_obj_error(o, "more than %u %s%s", limit, elements,
                                             o->key == 0 ? "" : ", which the first shape has");
}

static bool read_vertex(struct obj *o, const char *text)
{
    CORE_ASSERT(o->vertex_count <= IMPORT_VERTEX_MAX);
    float x[6];
    const int count = parse_obj_numbers(o, text, x, 6);
    if (count < 3) {
        return count < 0 ? false : import_obj_error(o, "a vertex needs three numbers");
    }
    if (!has_space(o, "vertices", o->vertex_count, IMPORT_VERTEX_MAX, o->mesh->vertex_count)) {
        return false;
    }
    o->mesh->positions[o->key][o->vertex_count] = v3(x[0], x[1], x[2]);
    if (o->key == 0) {
        uint32_t colour = count == 6 ? 0 : 0x808080u;
        for (int i = 3; i < 6 && count == 6; i++) {
            colour = colour << 8 | (uint32_t)(fminf(fmaxf(x[i], 0.0f), 1.0f) * 255.0f + 0.5f);
        }
        o->mesh->colours[o->vertex_count] = colour;
        o->mesh->has_colours |= count == 6;
    }
    o->vertex_count++;
    return true;
}

/* Converts an index of an OBJ file to an index counted from 0. OBJ counts from 1, and a negative
 * index counts backward from the newest element. Returns false if there is no such element. */
static bool index_of(long number, uint32_t count, uint32_t *out)
{
    const long index = number > 0 ? number - 1 : (long)count + number;
    *out = (uint32_t)index;
    return number != 0 && index >= 0 && index < (long)count;
}

static bool read_face(struct obj *o, char *text)
{
    uint32_t corner[CORNER_MAX], count = 0;
    char *rest = NULL;
    for (char *word = strtok_r(text, " \t\r\n", &rest); word;
         word = strtok_r(NULL, " \t\r\n", &rest)) {
        if (count == CORNER_MAX) {
            return import_obj_error(o, "a face of more than %d corners", CORNER_MAX);
        }
        /* A corner of a face has one of the forms "v", "v/vt", "v//vn" and "v/vt/vn", where v, vt
         * and vn are indices of a position, a texture coordinate and a normal. */
        char *end = NULL;
        uint32_t uv;
        errno = 0;
        const long vertex = strtol(word, &end, 10);
        if (end == word || errno != 0 || !index_of(vertex, o->vertex_count, &corner[count])) {
            return import_obj_error(o, "corner '%.30s' refers to no vertex above this line", word);
        }
        if (end[0] == '/' && end[1] != '/') {
            if (!index_of(strtol(end + 1, NULL, 10), o->uv_count, &uv)) {
                return import_obj_error(
                    o, "corner '%.30s' refers to no texture coordinate above this line", word);
            }
            if (o->key == 0) {
                memcpy(o->mesh->uv[corner[count]], o->uv[uv], sizeof o->uv[uv]);
                o->mesh->has_uv = true;
            }
        }
        count++;
    }
    if (count < 3) {
        return import_obj_error(o, "a face needs three corners");
    }
    for (uint32_t i = 2; i < count; i++) {
        struct import_mesh *m = o->mesh;
        const uint32_t edge[3] = { corner[0], corner[i - 1], corner[i] };
        if (!has_space(o, "triangles", o->triangle_count, IMPORT_TRIANGLE_MAX, m->triangle_count)) {
            return false;
        }
        if (o->key == 0) {
            memcpy(m->triangles[o->triangle_count], edge, sizeof edge);
            m->groups[o->triangle_count] = (uint8_t)o->group;
        } else if (memcmp(m->triangles[o->triangle_count], edge, sizeof edge) != 0) {
            return import_obj_error(o, "this face has other vertices than in the first shape");
        }
        o->triangle_count++;
    }
    return true;
}

/* Selects the group that `text` names for the following faces, and adds the group if it is new.
 * Only the groups of key shape 0 are used, because the files of other key shapes may have other
 * group names. */
static bool read_group(struct obj *o, char *text)
{
    struct import_mesh *m = o->mesh;
    char name[IMPORT_NAME_SIZE];
    if (o->key > 0) {
        return true;
    }
    text[strcspn(text, "\r\n")] = '\0';
    snprintf(name, sizeof name, "%s", text + strspn(text, " \t"));
    for (o->group = 0; o->group < m->group_count; o->group++) {
        if (strcmp(name, m->group_names[o->group]) == 0) {
            return true;
        }
    }
    if (m->group_count == IMPORT_GROUP_MAX) {
        return import_obj_error(o, "more than %u groups", IMPORT_GROUP_MAX);
    }
    memcpy(m->group_names[m->group_count++], name, sizeof name);
    return true;
}

static bool import_obj_read_line(struct obj *o, char *text)
{
    char *word = text + strspn(text, " \t");
    if (strncmp(word, "v ", 2) == 0 || strncmp(word, "v\t", 2) == 0) {
        return read_vertex(o, word + 2);
    }
    if (strncmp(word, "f ", 2) == 0) {
        return read_face(o, word + 2);
    }
    if (strncmp(word, "g ", 2) == 0 || strncmp(word, "o ", 2) == 0) {
        return read_group(o, word + 2);
    }
    if (strncmp(word, "vt ", 3) != 0) {
        return true;
    }
    if (o->uv_count == IMPORT_VERTEX_MAX) {
        return import_obj_error(o, "more than %u texture coordinates", IMPORT_VERTEX_MAX);
    }
    const int count = parse_obj_numbers(o, word + 3, o->uv[o->uv_count], 2);
    o->uv_count++;
    return count == 2 ||
           (count >= 0 && import_obj_error(o, "a texture coordinate needs two numbers"));
}

static bool read_all(struct obj *o, FILE *file)
{
    static char text[LINE_SIZE];
    enum file_line got;
    while ((got = file_read_line(file, text, sizeof text)) != FILE_LINE_END) {
        o->line++;
        if (got == FILE_LINE_BAD) {
            return import_obj_error(
                o, "the line is longer than %d characters or contains a zero byte", LINE_SIZE - 1);
        }
        if (!import_obj_read_line(o, text)) {
            return false;
        }
    }
    struct import_mesh *m = o->mesh;
    if (ferror(file)) {
        return import_obj_error(o, "cannot be read to its end");
    }
    if (o->vertex_count == 0 || o->triangle_count == 0) {
        return import_obj_error(o, "no %s", o->vertex_count == 0 ? "vertices" : "faces");
    }
    if (o->key == 0) {
        m->vertex_count = o->vertex_count;
        m->triangle_count = o->triangle_count;
    } else if (o->vertex_count != m->vertex_count || o->triangle_count != m->triangle_count) {
        return import_obj_error(
            o, "%u vertices and %u triangles, and the first shape has %u and %u", o->vertex_count,
            o->triangle_count, m->vertex_count, m->triangle_count);
    }
    m->key_count = o->key + 1;
    m->scales[o->key] = 1.0f;
    return true;
}

bool import_error(char why[IMPORT_WHY_SIZE], const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(why, IMPORT_WHY_SIZE, format, values);
    va_end(values);
    return false;
}

enum exit_code import_open(const char *path, uint32_t size_max, FILE **file,
                           char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(path);
    *file = file_open(path, size_max);
    if (*file) {
        return EXIT_OK;
    }
    if (errno == EFBIG) {
        const bool in_kib = size_max < 1u << 20;
        return import_fail(EXIT_BAD_DATA, why, "%.80s: larger than %u %s", path,
                           size_max >> (in_kib ? 10 : 20), in_kib ? "KiB" : "MiB");
    }
    return import_fail(EXIT_IO, why, "%.80s: %s", path, file_error(errno));
}

enum exit_code import_obj(struct import_mesh *mesh, uint32_t key, const char *path,
                          char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(key < MORPH_KEY_MAX);
    static struct obj o;
    FILE *file;
    const enum exit_code opened = import_open(path, IMPORT_FILE_MAX, &file, why);
    if (opened != EXIT_OK) {
        return opened;
    }
    o = (struct obj){ .mesh = mesh, .key = key, .path = path, .why = why };
    if (key == 0) {
        /* The file of key shape 0 defines the data that all key shapes share, so these data are
         * cleared first. */
        mesh->vertex_count = mesh->triangle_count = mesh->time_count = 0;
        memset(mesh->uv, 0, sizeof mesh->uv);
        mesh->has_uv = mesh->has_colours = mesh->is_ours = false;
        mesh->has_life = mesh->has_coats = false;
        /* Faces before the first group line belong to group 0, whose name is empty. */
        mesh->group_count = 1;
        mesh->group_names[0][0] = '\0';
    }
    const bool good = read_all(&o, file);
    const bool broken = ferror(file) != 0;
    fclose(file);
    return good ? EXIT_OK : broken ? EXIT_IO : EXIT_BAD_DATA;
}
