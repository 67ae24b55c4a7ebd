/* field.h -- tables that list the members of a struct. The state hash, the start state of a
 * recording and the test of the hash read the same table, so no member can be forgotten in one of
 * them.
 *
 * A table lists every member of its struct. The order of the table is the order in which the hash
 * reads the members. Each member is an array of numbers of 1, 2 or 4 bytes, or an array of structs
 * that have a table of their own. A single number is an array with one element. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum field_form {
    FORM_WORDS = 0, /* The hash reads each number as one word. */
    FORM_RAW,       /* The hash reads the bytes of the member (hash_bytes()). */
    /* The hash reads the number and the next member as one word. The number, shifted left by `tag`
     * bits, supplies the high bits of the word, and the next member the low bits. */
    FORM_HIGH,
    FORM_SIGN, /* The member is an int8_t from -1 to 1. The hash reads the number plus 1. */
    /* Recordings of formats older than `since` lack the number. If the number is not 0, the hash
     * reads the number after its `tag`, a constant that identifies the number. If the number is 0,
     * the hash reads nothing, so that the hashes of older recordings stay the same. */
    FORM_LATER,
    FORM_STRUCTS, /* The member is an array of structs, whose members are listed in `table`. */
    FORM_SKIPPED, /* The hash does not read the member. */
    /* The hash reads each number as one word. The table also lists the member in another entry, so
     * a visit of the members in memory order skips this entry. */
    FORM_AGAIN,
};

struct field_table {
    const char *name; /* Name of the struct without the keyword. */
    const struct field *fields;
    uint32_t count; /* Number of entries in `fields`. */
    uint32_t size;  /* Size of the struct in bytes. */
};

struct field {
    const char *name; /* Name of the member in its struct. */
    /* For FORM_STRUCTS: table of the struct of each element. Otherwise null. */
    const struct field_table *table;
    uint32_t offset; /* Offset of the member in its struct, in bytes. */
    uint32_t size;   /* Size of the member in bytes. */
    uint32_t count;  /* Length of the member as an array of numbers. */
    /* Offset in bytes, within the struct, of the uint32_t that holds the number of elements in use.
     * FIELD_ALL_USED means that all elements are in use. */
    uint32_t count_offset;
    /* For FORM_LATER: tag that the hash reads before the first element. Each further element has
     * the next tag, and all tags of a struct differ. For FORM_HIGH: number of bits of the shift. */
    uint16_t tag;
    uint8_t unit;  /* Size of one number in bytes: 1, 2 or 4. */
    uint8_t align; /* Alignment of the member in bytes. */
    uint8_t form;  /* Form of the member (enum field_form). */
    /* For FORM_LATER: first format of recordings that contains the member. Otherwise 0. */
    uint8_t since;
};

#define FIELD_ALL_USED UINT32_MAX

/* ---- Entries of a table ------------------------------------------------------------------------
 *
 * Before a table, a source file defines the macro STRUCT as the name of the struct, without the
 * keyword. In the macros below, `member` names a member, an element of an array member, or a member
 * of a nested struct that has no padding. */

#define FIELD_MEMBER(member) (((struct STRUCT *)0)->member)
/* Size in bytes of each number of a member. A type that is not listed, such as float or vec3,
 * consists of 4-byte numbers. */
#define FIELD_UNIT(value)                                                                          \
    _Generic((value),                                                                              \
        bool: 1,                                                                                   \
        bool *: 1,                                                                                 \
        int8_t: 1,                                                                                 \
        uint8_t: 1,                                                                                \
        uint8_t *: 1,                                                                              \
        char *: 1,                                                                                 \
        uint16_t: 2,                                                                               \
        uint16_t *: 2,                                                                             \
        default: 4)
#define FIELD_ENTRY(member, member_form, first_tag, members, used)                                 \
    FIELD_PART(member, sizeof FIELD_MEMBER(member), member_form, first_tag, members, used, 0)
/* Describes the `bytes` bytes that begin with `member`. These bytes may be a part of `member`, or
 * an array element together with the elements after it. */
#define FIELD_PART(member, bytes, member_form, first_tag, members, used, first_format)             \
    { .name = #member,                                                                             \
      .table = (members),                                                                          \
      .offset = offsetof(struct STRUCT, member),                                                   \
      .size = (bytes),                                                                             \
      .count = (bytes) / FIELD_UNIT(FIELD_MEMBER(member)),                                         \
      .count_offset = (used),                                                                      \
      .tag = (first_tag),                                                                          \
      .unit = FIELD_UNIT(FIELD_MEMBER(member)),                                                    \
      .align = __alignof__(FIELD_MEMBER(member)),                                                  \
      .form = (member_form),                                                                       \
      .since = (first_format) }

#define FIELD(member) FIELD_ENTRY(member, FORM_WORDS, 0, NULL, FIELD_ALL_USED)
#define FIELD_BYTES(member) FIELD_ENTRY(member, FORM_RAW, 0, NULL, FIELD_ALL_USED)
/* Describes the `bytes` bytes that begin with `member`, read as FIELD_BYTES() reads them. */
#define FIELD_BYTES_RANGE(member, bytes)                                                           \
    FIELD_PART(member, bytes, FORM_RAW, 0, NULL, FIELD_ALL_USED, 0)
#define FIELD_HIGH(member, shift) FIELD_ENTRY(member, FORM_HIGH, shift, NULL, FIELD_ALL_USED)
#define FIELD_SIGN(member) FIELD_ENTRY(member, FORM_SIGN, 0, NULL, FIELD_ALL_USED)
/* Describes a member that recordings contain since format 8 (FIELD_LATER) or since format `format`
 * (FIELD_SINCE). */
#define FIELD_LATER(member, tag) FIELD_SINCE(8, member, tag)
#define FIELD_SINCE(format, member, tag)                                                           \
    FIELD_PART(member, sizeof FIELD_MEMBER(member), FORM_LATER, tag, NULL, FIELD_ALL_USED, format)
#define FIELD_AGAIN(member) FIELD_ENTRY(member, FORM_AGAIN, 0, NULL, FIELD_ALL_USED)
#define FIELD_SKIP(member) FIELD_ENTRY(member, FORM_SKIPPED, 0, NULL, FIELD_ALL_USED)
#define FIELD_STRUCT(member, table) FIELD_ENTRY(member, FORM_STRUCTS, 0, table, FIELD_ALL_USED)
/* Describes an array of which only the first elements are in use. The member `used` counts these
 * elements. */
#define FIELD_USED(member, used)                                                                   \
    FIELD_ENTRY(member, FORM_WORDS, 0, NULL, offsetof(struct STRUCT, used))
#define FIELD_STRUCT_USED(member, table, used)                                                     \
    FIELD_ENTRY(member, FORM_STRUCTS, 0, table, offsetof(struct STRUCT, used))
/* Describes `numbers` consecutive elements of an array. `member` is the first of these elements,
 * for example array[3]. */
#define FIELD_RANGE(member, numbers)                                                               \
    FIELD_PART(member, (numbers) * sizeof FIELD_MEMBER(member), FORM_WORDS, 0, NULL,               \
               FIELD_ALL_USED, 0)
#define FIELD_RANGE_SINCE(format, member, numbers, tag)                                            \
    FIELD_PART(member, (numbers) * sizeof FIELD_MEMBER(member), FORM_LATER, tag, NULL,             \
               FIELD_ALL_USED, format)

/* Initializer of the table of struct `type`. The further arguments are the entries. */
#define FIELD_TABLE(type, ...)                                                                     \
    { .name = #type,                                                                               \
      .fields = (const struct field[]){ __VA_ARGS__ },                                             \
      .count = sizeof((const struct field[]){ __VA_ARGS__ }) / sizeof(struct field),               \
      .size = sizeof(struct type) }

/* ---- Visits of all members ------------------------------------------------------------------- */

/* Largest depth of structs within structs. */
#define FIELD_DEPTH_MAX 6u

/* State of a visit, a loop that reaches all members of an object one after another, including the
 * members of nested structs. */
struct field_cursor {
    /* True to visit the members in their order in memory. False to visit the members in the order
     * of the tables. */
    bool in_memory_order;
    /* Number of entries of `level` in use: one for the object, and one for each nested struct that
     * the visit is in. 0 means that the visit has ended. */
    uint32_t depth;
    struct field_level {
        const struct field_table *table;
        const uint8_t *object;
        const struct field *field; /* Current member of `object`. */
        const uint8_t *element;    /* Next element of the current member that the visit will enter,
                                      if the member is an array of structs. */
        /* Number of elements that the visit has not yet entered, beginning with `element`. */
        uint32_t element_count;
    } level[FIELD_DEPTH_MAX];
};

/* Begins a visit of all members of `object`, which `table` describes. Returns a cursor that stands
 * before the first member. */
struct field_cursor field_begin(const struct field_table *table, const void *object,
                                bool in_memory_order);

/* Advances the cursor to the next member that is not a struct. Returns the member's entry in its
 * table and writes the address of the member to `*at`. Returns NULL after the last member. */
const struct field *field_next(struct field_cursor *cursor, const uint8_t **at);

/* Returns `hash` extended by all members of `object`, which `table` describes. */
uint64_t field_hash(uint64_t hash, const struct field_table *table, const void *object);
