/* pack.c -- serializes, parses, reads and writes species files (NAME.kfish), and converts a species
 * text to a species. The functions walk_*() visit the fields of a species in one order, both for
 * reading and for writing. */
#include "platform/species/pack.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/os/file.h"
#include "platform/species/shape.h"

#define HEAD_SIZE 20u

static const uint8_t magic[8] = { 'K', 'F', 'I', 'S', 'H', '\r', '\n', 0x1a };

/* If a field is added to one of these structures, the functions walk_*() must visit the field, and
 * PACK_VERSION must increase. */
_Static_assert(sizeof(struct species_card) == 2348 && sizeof(struct species_coat) == 280 &&
                   sizeof(struct species_mark) == 32 && sizeof(struct species_vertex) == 16 &&
                   sizeof(struct species_anchor) == 68,
               "all that a pack holds is walked");
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "a pack has the byte order of memory");

/* Byte buffer to which fields are written, or from which fields are read. */
struct tape {
    uint8_t *bytes;
    size_t size, at; /* Size of the buffer, and current position in the buffer, in bytes. After
                        reading, a position beyond `size` means that the input was too short.
                        Missing bytes are read as zeros. */
    bool writing;
    /* Name of the first table whose count of entries exceeded its maximum. Null means that no count
     * did. */
    const char *too_many;
};

/* Copies `size` bytes between `data` and the current position of the buffer. `writing` of the tape
 * selects the direction. Bytes beyond the end of the buffer are not written, and are read
 * as zeros. */
static void transfer(struct tape *t, void *data, size_t size)
{
    const size_t from = t->at < t->size ? t->at : t->size;
    const size_t count = size < t->size - from ? size : t->size - from;
    if (t->writing) {
        memcpy(t->bytes + from, data, count);
    } else {
        memcpy(data, t->bytes + from, count);
        memset((uint8_t *)data + count, 0, size - count);
    }
    t->at += size;
}

/* Copies a count of table entries between `data` and the buffer, and returns the count. If the
 * count exceeds `count_max`, the size of its table, returns 0, and sets t->too_many to the name
 * `what` of the count unless it is already set. `width` is the size of the count in bytes, 1 or
 * 4. */
static uint32_t transfer_count(struct tape *t, void *data, size_t width, uint32_t count_max,
                               const char *what)
{
    uint32_t count = 0;
    transfer(t, data, width);
    memcpy(&count, data, width);
    if (count <= count_max) {
        return count;
    }
    t->too_many = t->too_many ? t->too_many : what;
    return 0;
}

static void count8(struct tape *t, uint8_t *x, uint32_t count_max, const char *what)
{
    *x = (uint8_t)transfer_count(t, x, sizeof *x, count_max, what);
}

static void count32(struct tape *t, uint32_t *x, uint32_t count_max, const char *what)
{
    *x = transfer_count(t, x, sizeof *x, count_max, what);
}

static void walk_card(struct tape *t, struct species_card *card)
{
    transfer(t, card->id, sizeof card->id);
    count8(t, &card->key_count, MORPH_KEY_MAX, "keys");
    /* Copy the seven consecutive one-byte fields from `measure` to `thesis_template`. */
    transfer(t, (uint8_t *)card + offsetof(struct species_card, measure), 7);
    for (uint32_t key = 0; key < card->key_count; key++) {
        transfer(t, card->key_names[key], sizeof card->key_names[key]);
        transfer(t, &card->key_age_days[key], sizeof card->key_age_days[key]);
        transfer(t, &card->key_length_m[key], sizeof card->key_length_m[key]);
    }
    struct growth *growth = &card->growth;
    transfer(t, growth, offsetof(struct growth, point_count));
    count32(t, &growth->point_count, GROWTH_POINT_MAX, "growth points");
    transfer(t, growth->points, growth->point_count * sizeof growth->points[0]);
    count8(t, &card->scale_knot_count, GRAPH_KNOT_MAX, "scale knots");
    transfer(t, card->scale_knots, card->scale_knot_count * sizeof card->scale_knots[0]);
    count8(t, &card->curve_count, MORPH_CURVE_MAX, "curves");
    for (uint32_t i = 0; i < card->curve_count; i++) {
        struct graph *graph = &card->curves[i];
        transfer(t, card->curve_names[i], sizeof card->curve_names[i]);
        count8(t, &graph->knot_count, GRAPH_KNOT_MAX, "knots");
        transfer(t, &graph->line, sizeof graph->line);
        transfer(t, &graph->solved, sizeof graph->solved);
        for (uint32_t k = 0; k < graph->knot_count; k++) {
            transfer(t, &graph->knots[k], sizeof(float) * (1u + card->key_count));
        }
    }
}

static void walk_mesh(struct tape *t, struct species_mesh *mesh, struct mesh_tables *tables,
                      uint32_t key_count)
{
    count32(t, &mesh->vertex_count, MESH_VERTEX_MAX, "vertices");
    count32(t, &mesh->index_count, MESH_INDEX_MAX, "indices");
    count32(t, &mesh->anchor_count, ANCHOR_MAX, "anchors");
    transfer(t, &mesh->grid_first, sizeof mesh->grid_first);
    transfer(t, &mesh->grid_rings, sizeof mesh->grid_rings);
    transfer(t, &mesh->grid_spokes, sizeof mesh->grid_spokes);
    transfer(t, &mesh->reach, sizeof mesh->reach);
    transfer(t, tables->vertices, mesh->vertex_count * sizeof tables->vertices[0]);
    for (uint32_t key = 0; key < key_count; key++) {
        transfer(t, tables->points[key], mesh->vertex_count * sizeof tables->points[key][0]);
    }
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        struct species_anchor *anchor = &tables->anchors[i];
        transfer(t, &anchor->curve, sizeof anchor->curve);
        transfer(t, &anchor->turns, sizeof anchor->turns);
        for (uint32_t key = 0; key < key_count; key++) {
            transfer(t, &anchor->u[key], sizeof anchor->u[key]);
            transfer(t, &anchor->v[key], sizeof anchor->v[key]);
        }
    }
    transfer(t, tables->indices, mesh->index_count * sizeof tables->indices[0]);
}

static void walk_species(struct tape *t, struct species_slot *slot)
{
    struct species *s = &slot->species;
    walk_card(t, &s->card);
    for (uint32_t key = 0; key < s->card.key_count; key++) {
        struct species_coat *coat = &s->coats[key];
        transfer(t, coat, offsetof(struct species_coat, mark_count));
        count8(t, &coat->mark_count, MARK_MAX, "marks");
        transfer(t, coat->marks, coat->mark_count * sizeof coat->marks[0]);
    }
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        walk_mesh(t, &s->lod[lod], &slot->tables[lod], s->card.key_count);
    }
}

/* Returns the CRC-32 of IEEE 802.3, computed four bits at a time. Computing the CRC-32 of 256 KiB
 * takes one millisecond. */
static uint32_t crc32(const uint8_t *bytes, size_t size)
{
    static const uint32_t table[16] = {
        0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4,
        0x4db26158, 0x5005713c, 0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
        0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c,
    };
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ table[crc & 15u];
        crc = crc >> 4 ^ table[crc & 15u];
    }
    return ~crc;
}

static bool check_head(const uint8_t *bytes, size_t size, char why[VALIDATE_WHY_SIZE])
{
    uint32_t head[3]; /* The three values are the version, the size and the CRC-32. */
    if (size < HEAD_SIZE || memcmp(bytes, magic, sizeof magic) != 0) {
        return validate_refuse(why, "magic: the file is not a packed species");
    }
    memcpy(head, bytes + sizeof magic, sizeof head);
    if (head[0] != PACK_VERSION) {
        return validate_refuse(why, "version: %u, but this program reads version %u", head[0],
                               PACK_VERSION);
    }
    if (head[1] != size - HEAD_SIZE) {
        return validate_refuse(why, "size: the header gives %u bytes, but %zu bytes follow",
                               head[1], size - HEAD_SIZE);
    }
    return crc32(bytes + HEAD_SIZE, head[1]) == head[2] ||
           validate_refuse(why, "crc: the checksum is wrong, so the file is damaged");
}

void pack_point(struct species_slot *slot)
{
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        struct species_mesh *mesh = &slot->species.lod[lod];
        mesh->vertices = slot->tables[lod].vertices;
        mesh->anchors = slot->tables[lod].anchors;
        mesh->indices = slot->tables[lod].indices;
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            const bool used = key < slot->species.card.key_count;
            mesh->points[key] = used ? slot->tables[lod].points[key] : NULL;
        }
    }
}

enum pack_result pack_decode(const uint8_t *bytes, size_t size, struct species_slot *slot,
                             char why[VALIDATE_WHY_SIZE])
{
    if (size > PACK_SIZE_MAX) {
        return validate_fail(PACK_BAD, why, "size: more than %u bytes", PACK_SIZE_MAX);
    }
    if (!check_head(bytes, size, why)) {
        return PACK_BAD;
    }
    /* The cast removes the const qualifier of `bytes`. This is safe because reading does not modify
     * `bytes`. */
    struct tape tape = { .bytes = (uint8_t *)(uintptr_t)bytes, .size = size, .at = HEAD_SIZE };
    memset(slot, 0, sizeof *slot);
    walk_species(&tape, slot);
    if (tape.too_many) {
        return validate_fail(PACK_BAD, why, "%s: more than a species may have", tape.too_many);
    }
    if (tape.at != size) {
        return validate_fail(PACK_BAD, why, "size: the tables end %s the end of the file",
                             tape.at > size ? "after" : "before");
    }
    pack_point(slot);
    return species_validate(&slot->species, why) ? PACK_OK : PACK_BAD;
}

size_t pack_encode(struct species_slot *slot, uint8_t bytes[PACK_SIZE_MAX])
{
    struct tape tape = { .bytes = bytes, .size = PACK_SIZE_MAX, .at = HEAD_SIZE, .writing = true };
    walk_species(&tape, slot);
    CORE_ASSERT(!tape.too_many && tape.at <= PACK_SIZE_MAX);
    const uint32_t size = (uint32_t)(tape.at - HEAD_SIZE);
    const uint32_t head[3] = { PACK_VERSION, size, crc32(bytes + HEAD_SIZE, size) };
    memcpy(bytes, magic, sizeof magic);
    memcpy(bytes + sizeof magic, head, sizeof head);
    return tape.at;
}

void pack_copy(const struct species *species, struct species_slot *slot)
{
    slot->species = *species;
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &species->lod[lod];
        struct mesh_tables *to = &slot->tables[lod];
        CORE_ASSERT(mesh->vertex_count <= MESH_VERTEX_MAX && mesh->index_count <= MESH_INDEX_MAX);
        CORE_ASSERT(mesh->anchor_count <= ANCHOR_MAX);
        memcpy(to->vertices, mesh->vertices, mesh->vertex_count * sizeof *mesh->vertices);
        if (mesh->anchor_count > 0) {
            memcpy(to->anchors, mesh->anchors, mesh->anchor_count * sizeof *mesh->anchors);
        }
        memcpy(to->indices, mesh->indices, mesh->index_count * sizeof *mesh->indices);
        for (uint32_t key = 0; key < species->card.key_count; key++) {
            memcpy(to->points[key], mesh->points[key],
                   mesh->vertex_count * sizeof *mesh->points[key]);
        }
    }
    pack_point(slot);
}

/* ---- Species from a text --------------------------------------------------------------------- */

void species_pack(const struct loft *loft, uint32_t key_count, struct mesh_tables *tables,
                  struct species_mesh *mesh)
{
    CORE_ASSERT(key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(loft->vertex_count <= MESH_VERTEX_MAX);
    memcpy(tables->vertices, loft->vertices, sizeof loft->vertices);
    memcpy(tables->anchors, loft->anchors, sizeof loft->anchors);
    memcpy(tables->indices, loft->indices, sizeof loft->indices);
    *mesh = (struct species_mesh){ .vertex_count = loft->vertex_count,
                                   .index_count = loft->index_count,
                                   .anchor_count = loft->anchor_count,
                                   .grid_first = (uint16_t)loft->grid_first,
                                   .grid_rings = (uint16_t)loft->grid_rings,
                                   .grid_spokes = (uint16_t)loft->grid_spokes,
                                   .reach = loft->reach,
                                   .vertices = tables->vertices,
                                   .anchors = tables->anchors,
                                   .indices = tables->indices };
    for (uint32_t key = 0; key < key_count; key++) {
        for (uint32_t i = 0; i < loft->vertex_count; i++) {
            const vec3 p = loft->positions[key][i];
            CORE_ASSERT(fmaxf(fmaxf(fabsf(p.x), fabsf(p.y)), fabsf(p.z)) <= loft->reach);
            tables->points[key][i] = (struct species_point){
                .x = morph_count(p.x, loft->reach),
                .y = morph_count(p.y, loft->reach),
                .z = morph_count(p.z, loft->reach),
                .normal = morph_fold_normal(loft->normals[key][i]),
            };
        }
        mesh->points[key] = tables->points[key];
    }
}

void pack_text(const struct species_text *text, struct species_slot *slot)
{
    static struct loft loft;
    const uint32_t key_count = text->card.key_count;
    slot->species = (struct species){ .card = text->card };
    for (uint32_t key = 0; key < key_count; key++) {
        struct species_coat *coat = &slot->species.coats[key];
        *coat = text->keys[key].coat;
        /* In the species text, the positions of a mark are coordinates x of the drawing. The paint
         * functions expect body coordinates u, so the loop converts the positions. */
        for (uint32_t i = 0; i < coat->mark_count; i++) {
            struct species_mark *mark = &coat->marks[i];
            if (mark->part == PART_BODY) {
                mark->from = (float)shape_body_u(&text->keys[key], (double)mark->from);
                mark->to = (float)shape_body_u(&text->keys[key], (double)mark->to);
            }
        }
    }
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        species_loft(text, &species_detail[lod], &loft);
        species_pack(&loft, key_count, &slot->tables[lod], &slot->species.lod[lod]);
    }
}

/* ---- Reading and writing of files ------------------------------------------------------------ */

/* Reads a species file from its descriptor `handle` and closes the descriptor. If `handle` is -1,
 * errno has the reason, and the result is PACK_IO. */
static enum pack_result read_descriptor(int handle, struct species_slot *slot,
                                        char why[VALIDATE_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX + 1u]; /* The buffer is one byte larger than the maximum
                                                 file size, so that a file that is too large is
                                                 detected. */
    size_t size = 0;
    ssize_t got = handle < 0 ? -1 : 1;
    while (got > 0 && size < sizeof bytes) {
        got = read(handle, bytes + size, sizeof bytes - size);
        size += got > 0 ? (size_t)got : 0u;
    }
    const int error = got < 0 ? errno : size > PACK_SIZE_MAX ? EFBIG : 0;
    if (handle >= 0) {
        close(handle);
    }
    if (error != 0) {
        return validate_fail(error == EFBIG ? PACK_BAD : PACK_IO, why, "%s", file_error(error));
    }
    return pack_decode(bytes, size, slot, why);
}

enum pack_result pack_read(const char *path, struct species_slot *slot, char why[VALIDATE_WHY_SIZE])
{
    return read_descriptor(file_user_handle(path, O_RDONLY, 0), slot, why);
}

enum pack_result pack_read_data(const char *path, struct species_slot *slot,
                                char why[VALIDATE_WHY_SIZE])
{
    return read_descriptor(file_handle(path, O_RDONLY, 0), slot, why);
}

enum pack_result pack_write(const char *path, struct species_slot *slot,
                            char why[VALIDATE_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    struct atomic_file out;
    const size_t size = pack_encode(slot, bytes);
    int error = file_atomic_open_durable(&out, path);
    if (error == 0) {
        fwrite(bytes, 1, size, out.file); /* file_atomic_close() also reports an earlier error of
                                             fwrite(). */
        error = file_atomic_close(&out);
    }
    if (error != 0) {
        return validate_fail(PACK_IO, why, "%s", strerror(-error));
    }
    return PACK_OK;
}
