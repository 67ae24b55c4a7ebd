/* field.c -- visits the members of a struct in the order of its table or in memory order, and
 * hashes them. */
#include "core/base/field.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"

struct field_cursor field_begin(const struct field_table *table, const void *object,
                                bool in_memory_order)
{
    CORE_ASSERT(table && object);
    return (struct field_cursor){
        .in_memory_order = in_memory_order,
        .depth = 1,
        .level = { { .table = table, .object = object } },
    };
}

/* Returns the member that follows the current member of `level`, in memory or in the table. Returns
 * the first member if there is no current member, and NULL after the last member. */
static const struct field *next_member(const struct field_level *level, bool in_memory_order)
{
    const struct field_table *table = level->table;
    const struct field *next = NULL;
    if (!in_memory_order) {
        next = level->field ? level->field + 1 : table->fields;
        return next < table->fields + table->count ? next : NULL;
    }
    for (uint32_t i = 0; i < table->count; i++) {
        const struct field *field = &table->fields[i];
        if (field->form != FORM_AGAIN && (!level->field || field->offset > level->field->offset) &&
            (!next || field->offset < next->offset)) {
            next = field;
        }
    }
    return next;
}

/* Returns how many elements of a member of `object` are in use. `most` is the number of elements
 * that the member has room for. */
static inline uint32_t used_count(const struct field *field, const uint8_t *object, uint32_t most)
{
    uint32_t used = most;
    if (field->count_offset != FIELD_ALL_USED) {
        MEM_COPY(&used, object + field->count_offset, sizeof used);
        CORE_ASSERT(used <= most);
    }
    return used;
}

const struct field *field_next(struct field_cursor *cursor, const uint8_t **at)
{
    while (cursor->depth > 0) {
        struct field_level *level = &cursor->level[cursor->depth - 1u];
        const struct field *field = level->field;
        if (level->element_count > 0) {
            CORE_ASSERT(cursor->depth < FIELD_DEPTH_MAX);
            level[1] = (struct field_level){ .table = field->table, .object = level->element };
            level->element += field->table->size;
            level->element_count--;
            cursor->depth++;
            continue;
        }
        field = level->field = next_member(level, cursor->in_memory_order);
        if (!field) {
            cursor->depth--;
            continue;
        }
        *at = level->object + field->offset;
        if (!field->table) {
            return field;
        }
        level->element = *at;
        level->element_count = used_count(field, level->object, field->size / field->table->size);
    }
    return NULL;
}

static inline uint32_t number_at(const uint8_t *at, uint32_t size)
{
    uint32_t wide;
    uint16_t middle;
    if (size == 4u) {
        MEM_COPY(&wide, at, sizeof wide);
        return wide;
    }
    if (size == 1u) {
        return *at;
    }
    MEM_COPY(&middle, at, sizeof middle);
    return middle;
}

/* Returns `hash` extended by a member of `object`. The member is not a struct, so it has no
 * table. */
static inline uint64_t hash_member(uint64_t hash, const struct field *field, const uint8_t *object)
{
    const uint8_t *at = object + field->offset;
    const uint32_t unit = field->unit;
    const uint32_t count = used_count(field, object, field->count);
    switch (field->form) {
    case FORM_WORDS:
    case FORM_AGAIN:
        for (uint32_t i = 0; i < count; i++) {
            hash = hash_u32(hash, number_at(at + i * unit, unit));
        }
        break;
    case FORM_RAW:
        hash = hash_bytes(hash, at, field->size);
        break;
    case FORM_HIGH:
        /* XORs the high bits of a word into `hash` without mixing. The call for the next member
         * XORs the low bits and then mixes the whole word. */
        hash ^= (uint64_t)number_at(at, unit) << field->tag;
        break;
    case FORM_SIGN:
        hash = hash_u32(hash, (uint32_t)((int8_t)*at + 1));
        break;
    case FORM_LATER:
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t number = number_at(at + i * unit, unit);
            hash = number != 0 ? hash_u32(hash_u32(hash, field->tag + i), number) : hash;
        }
        break;
    default:
        break;
    }
    return hash;
}

uint64_t field_hash(uint64_t hash, const struct field_table *table, const void *object)
{
    struct field_cursor cursor = field_begin(table, object, false);
    const uint8_t *at = NULL;
    while (field_next(&cursor, &at)) {
        /* Hashes the members up to the next nested struct without calls of field_next(), because
         * such a call takes three times as long as the hash of a member. */
        struct field_level *level = &cursor.level[cursor.depth - 1u];
        const struct field *end = level->table->fields + level->table->count;
        const struct field *field = level->field;
        do {
            hash = hash_member(hash, field, level->object);
            field++;
        } while (field < end && !field->table);
        level->field = field - 1;
    }
    return hash;
}
