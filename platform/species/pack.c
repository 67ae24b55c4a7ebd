/* pack.c -- serializes and parses a species file. The walk functions visit the fields of a species
 * in one order, both for reading and for writing. */
#include "platform/species/pack.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

#define HEAD_SIZE 20u

static const uint8_t magic[8] = { 'K', 'F', 'I', 'S', 'H', '\r', '\n', 0x1a };

/* If a field is added to one of these structures, the walk functions must visit the field, and
 * PACK_VERSION must increase. */
_Static_assert(sizeof(struct species_card) == 2348 && sizeof(struct species_coat) == 280 &&
                   sizeof(struct species_mark) == 32 && sizeof(struct species_vertex) == 16 &&
                   sizeof(struct species_anchor) == 68,
               "all that a pack holds is walked");

/* Byte buffer with the current position and the direction: writing or reading fields. */
struct tape {
    uint8_t *bytes;
    size_t size, at; /* Size of the buffer, and current position in the buffer, in bytes. After
                        reading, a position beyond `size` means that the input was too short.
                        Missing bytes are read as zeros. */
    bool writing;
    const char *too_many; /* Name of the first count that exceeded its maximum. Null means none. */
};

static void word8(struct tape *t, uint8_t *x)
{
    if (t->at < t->size) {
        if (t->writing) {
            t->bytes[t->at] = *x;
        } else {
            *x = t->bytes[t->at];
        }
    } else if (!t->writing) {
        *x = 0;
    }
    t->at++;
}

static void word16(struct tape *t, uint16_t *x)
{
    uint8_t low = (uint8_t)(*x & 255u), high = (uint8_t)(*x >> 8);
    word8(t, &low);
    word8(t, &high);
    *x = (uint16_t)(low | high << 8);
}

static void word32(struct tape *t, uint32_t *x)
{
    uint16_t low = (uint16_t)(*x & 0xffffu), high = (uint16_t)(*x >> 16);
    word16(t, &low);
    word16(t, &high);
    *x = low | (uint32_t)high << 16;
}

static void signed16(struct tape *t, int16_t *x)
{
    uint16_t bits;
    memcpy(&bits, x, sizeof bits);
    word16(t, &bits);
    memcpy(x, &bits, sizeof bits);
}

static void transfer_float(struct tape *t, float *x)
{
    uint32_t bits;
    memcpy(&bits, x, sizeof bits);
    word32(t, &bits);
    memcpy(x, &bits, sizeof bits);
}

static void transfer_name(struct tape *t, char x[SPECIES_NAME_SIZE])
{
    for (uint32_t i = 0; i < SPECIES_NAME_SIZE; i++) {
        uint8_t byte = (uint8_t)x[i];
        word8(t, &byte);
        x[i] = (char)byte;
    }
}

/* Returns `count`, which was read from the file, or 0 if `count` exceeds the size of its table.
 * Records the name `what` of the first count that was too large. */
static uint32_t limit_table_count(struct tape *t, uint32_t count, uint32_t count_max,
                                  const char *what)
{
    if (count > count_max && !t->too_many) {
        t->too_many = what;
    }
    return count > count_max ? 0 : count;
}

static void count8(struct tape *t, uint8_t *x, uint32_t count_max, const char *what)
{
    word8(t, x);
    *x = (uint8_t)limit_table_count(t, *x, count_max, what);
}

static void count32(struct tape *t, uint32_t *x, uint32_t count_max, const char *what)
{
    word32(t, x);
    *x = limit_table_count(t, *x, count_max, what);
}

static void walk_card(struct tape *t, struct species_card *card)
{
    transfer_name(t, card->id);
    count8(t, &card->key_count, MORPH_KEY_MAX, "keys");
    word8(t, &card->measure);
    word8(t, &card->motion);
    word8(t, &card->form);
    for (uint32_t i = 0; i < 3; i++) {
        word8(t, &card->thesis_key[i]);
    }
    word8(t, &card->thesis_template);
    for (uint32_t key = 0; key < card->key_count; key++) {
        transfer_name(t, card->key_names[key]);
        transfer_float(t, &card->key_age_days[key]);
        transfer_float(t, &card->key_length_m[key]);
    }
    transfer_float(t, &card->growth.length_inf_m);
    transfer_float(t, &card->growth.k_per_year);
    transfer_float(t, &card->growth.t0_year);
    transfer_float(t, &card->growth.fade_year);
    count32(t, &card->growth.point_count, GROWTH_POINT_MAX, "growth points");
    for (uint32_t i = 0; i < card->growth.point_count; i++) {
        transfer_float(t, &card->growth.points[i].age_days);
        transfer_float(t, &card->growth.points[i].length_m);
    }
    count8(t, &card->scale_knot_count, GRAPH_KNOT_MAX, "scale knots");
    for (uint32_t i = 0; i < card->scale_knot_count; i++) {
        transfer_float(t, &card->scale_knots[i].progress);
        transfer_float(t, &card->scale_knots[i].length_m);
    }
    count8(t, &card->curve_count, MORPH_CURVE_MAX, "curves");
    for (uint32_t i = 0; i < card->curve_count; i++) {
        transfer_name(t, card->curve_names[i]);
        struct graph *graph = &card->curves[i];
        count8(t, &graph->knot_count, GRAPH_KNOT_MAX, "knots");
        word8(t, &graph->line);
        word8(t, &graph->solved);
        for (uint32_t k = 0; k < graph->knot_count; k++) {
            transfer_float(t, &graph->knots[k].progress);
            for (uint32_t key = 0; key < card->key_count; key++) {
                transfer_float(t, &graph->knots[k].weight[key]);
            }
        }
    }
}

static void walk_mesh(struct tape *t, struct species_mesh *mesh, struct mesh_tables *tables,
                      uint32_t key_count)
{
    count32(t, &mesh->vertex_count, MESH_VERTEX_MAX, "vertices");
    count32(t, &mesh->index_count, MESH_INDEX_MAX, "indices");
    count32(t, &mesh->anchor_count, ANCHOR_MAX, "anchors");
    word16(t, &mesh->grid_first);
    word16(t, &mesh->grid_rings);
    word16(t, &mesh->grid_spokes);
    transfer_float(t, &mesh->reach);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        struct species_vertex *vertex = &tables->vertices[i];
        transfer_float(t, &vertex->u);
        transfer_float(t, &vertex->v);
        word8(t, &vertex->part);
        word8(t, &vertex->side);
        word8(t, &vertex->flex);
        word8(t, &vertex->anchor);
        for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
            word8(t, &vertex->mask[curve]);
        }
    }
    for (uint32_t key = 0; key < key_count; key++) {
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            struct species_point *point = &tables->points[key][i];
            signed16(t, &point->x);
            signed16(t, &point->y);
            signed16(t, &point->z);
            signed16(t, &point->normal);
        }
    }
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        struct species_anchor *anchor = &tables->anchors[i];
        word8(t, &anchor->curve);
        word8(t, &anchor->turns);
        for (uint32_t key = 0; key < key_count; key++) {
            transfer_float(t, &anchor->u[key]);
            transfer_float(t, &anchor->v[key]);
        }
    }
    for (uint32_t i = 0; i < mesh->index_count; i++) {
        word16(t, &tables->indices[i]);
    }
}

static void walk_species(struct tape *t, struct species_slot *slot)
{
    struct species *s = &slot->species;
    walk_card(t, &s->card);
    for (uint32_t key = 0; key < s->card.key_count; key++) {
        uint32_t *const colours[] = { &s->coats[key].back, &s->coats[key].flank,
                                      &s->coats[key].belly, &s->coats[key].fin,
                                      &s->coats[key].iris };
        for (uint32_t i = 0; i < sizeof colours / sizeof colours[0]; i++) {
            word32(t, colours[i]);
        }
        word8(t, &s->coats[key].clear);
        word8(t, &s->coats[key].shine);
        count8(t, &s->coats[key].mark_count, MARK_MAX, "marks");
        for (uint32_t i = 0; i < s->coats[key].mark_count; i++) {
            struct species_mark *mark = &s->coats[key].marks[i];
            word8(t, &mark->kind);
            word8(t, &mark->part);
            word8(t, &mark->count);
            word8(t, &mark->seed);
            word32(t, &mark->colour);
            float *const numbers[] = { &mark->from,  &mark->to,  &mark->width,
                                       &mark->slant, &mark->low, &mark->high };
            for (uint32_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
                transfer_float(t, numbers[k]);
            }
        }
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

static uint32_t little32(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

__attribute__((format(printf, 2, 3))) static enum pack_result
refuse_pack(char why[VALIDATE_WHY_SIZE], const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(why, VALIDATE_WHY_SIZE, format, values);
    va_end(values);
    return PACK_BAD;
}

static enum pack_result check_head(const uint8_t *bytes, size_t size, char why[VALIDATE_WHY_SIZE])
{
    if (size < HEAD_SIZE || memcmp(bytes, magic, sizeof magic) != 0) {
        return refuse_pack(why, "magic: this is no packed species");
    }
    const uint32_t version = little32(bytes + 8), body = little32(bytes + 12);
    if (version != PACK_VERSION) {
        return refuse_pack(why, "version: %u, and this program reads %u", version, PACK_VERSION);
    }
    if (body != size - HEAD_SIZE) {
        return refuse_pack(why, "size: %u bytes are announced, %zu follow", body, size - HEAD_SIZE);
    }
    if (crc32(bytes + HEAD_SIZE, body) != little32(bytes + 16)) {
        return refuse_pack(why, "crc: the bytes are not those that were written");
    }
    return PACK_OK;
}

static void point_at_tables(struct species_slot *slot)
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
        return refuse_pack(why, "size: more than %u bytes", PACK_SIZE_MAX);
    }
    if (check_head(bytes, size, why) != PACK_OK) {
        return PACK_BAD;
    }
    /* The cast removes the const qualifier of `bytes`. This is safe because reading does not modify
     * `bytes`. */
    struct tape tape = { .bytes = (uint8_t *)(uintptr_t)bytes, .size = size, .at = HEAD_SIZE };
    memset(slot, 0, sizeof *slot);
    walk_species(&tape, slot);
    if (tape.too_many) {
        return refuse_pack(why, "%s: more than a species may have", tape.too_many);
    }
    if (tape.at != size) {
        return refuse_pack(why, "size: the tables end %s the file does",
                           tape.at > size ? "after" : "before");
    }
    point_at_tables(slot);
    return species_validate(&slot->species, why) ? PACK_OK : PACK_BAD;
}

size_t pack_encode(struct species_slot *slot, uint8_t bytes[PACK_SIZE_MAX])
{
    struct tape head = { .bytes = bytes, .size = HEAD_SIZE, .at = sizeof magic, .writing = true };
    struct tape tape = { .bytes = bytes, .size = PACK_SIZE_MAX, .at = HEAD_SIZE, .writing = true };
    walk_species(&tape, slot);
    CORE_ASSERT(!tape.too_many && tape.at <= PACK_SIZE_MAX);
    uint32_t version = PACK_VERSION, size = (uint32_t)(tape.at - HEAD_SIZE);
    uint32_t crc = crc32(bytes + HEAD_SIZE, size);
    memcpy(bytes, magic, sizeof magic);
    word32(&head, &version);
    word32(&head, &size);
    word32(&head, &crc);
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
    point_at_tables(slot);
}

void pack_text(const struct species_text *text, struct species_slot *slot)
{
    static struct loft loft;
    species_compile(text, &slot->species);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        species_loft(text, &species_detail[lod], &loft);
        species_pack(&loft, text->key_count, &slot->tables[lod], &slot->species.lod[lod]);
    }
}
