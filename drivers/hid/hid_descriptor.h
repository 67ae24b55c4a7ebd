/* hid_descriptor.h -- parses a HID report descriptor into the bit fields of its input reports.
 *
 * Follows the Device Class Definition for HID 1.11, section 6.2.2, and the HID Usage Tables. A
 * group is the list of fields that one Input item declares. The parser reads bytes and fills lists
 * in the caller's memory. The time is linear in the size of the descriptor. Each limit below has
 * its own error code. Pure: uses no device and no clock. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/base/panic.h"

/* Maximum size of a report descriptor in bytes. The field wDescriptorLength of the HID descriptor
 * has 16 bits. */
#define HID_DESCRIPTOR_SIZE_MAX 65535u
/* Largest number of Input items. The largest of 72 examined devices has 209. */
#define HID_GROUP_MAX 512u
/* Largest number of usages and usage ranges of all Input items of a descriptor together. */
#define HID_RANGE_MAX 2048u
#define HID_DEPTH_MAX 32u /* Deepest nesting of collections. Real devices nest 4 collections. */
#define HID_PUSH_MAX 8u   /* Largest number of nested Push items. Real devices use 1. */
#define HID_FIELD_BITS_MAX 256u /* Largest Report Size of one field, in bits. */
/* Largest size of one report: 8 KiB. The largest report of a real device has 7,487 bytes. */
#define HID_REPORT_BITS_MAX 65536u
/* Largest number of fields of all Input items together, which a report of 65,536 one-bit fields
 * needs. */
#define HID_FIELD_MAX 65536u

enum hid_flag { /* Bits of an Input item (HID 1.11, section 6.2.2.5). */
                HID_CONSTANT = 1u << 0,
                /* Set for a variable field. Clear for an array, whose elements select usages. */
                HID_VARIABLE = 1u << 1,
                HID_RELATIVE = 1u << 2,
                HID_NULL_STATE = 1u << 6, /* A value outside the logical range means "no value". */
};

/* A usage: the usage page in the upper 16 bits, the usage id in the lower 16 bits. */
typedef uint32_t hid_usage;

struct hid_range {
    hid_usage first, last; /* First and last usage of the range. Both usages belong to the range. */
    /* Number of usages in the earlier ranges of the group, at most 2,047 times 65,536. */
    uint32_t place;
};

/* The fields of one Input item: `count` consecutive fields of `bit_size` bits. */
struct hid_group {
    /* Usage of the nearest enclosing Application collection, or 0 if there is none. */
    hid_usage application;
    /* Id of the report that contains the fields. 0 means that the device uses no report ids. */
    uint8_t report_id;
    /* Bit offset of the first field, counted from the end of the report id. */
    uint32_t bit_offset;
    uint32_t bit_size, count;
    /* All bits of the Input item, including bits that enum hid_flag does not name. */
    uint32_t flags;
    int64_t logical_min, logical_max;
    /* Physical range. If both ends are 0 the range is not declared, and the logical range
     * applies. */
    int64_t physical_min, physical_max;
    int32_t unit_exponent; /* Exponent of the unit as a power of ten. */
    uint32_t unit;
    /* First index and number of the group's usage ranges in hid_descriptor.range. */
    uint16_t range_first, range_count;
};

/* Errors of hid_descriptor_read(), with their descriptions. */
#define HID_ERRORS(X)                                                                              \
    X(HID_OK, "fine")                                                                              \
    X(HID_ERR_TOO_LONG, "longer than 65535 bytes")                                                 \
    X(HID_ERR_CUT_OFF, "ends within an item")                                                      \
    X(HID_ERR_OPEN_COLLECTION, "ends within a collection")                                         \
    X(HID_ERR_NO_COLLECTION, "End Collection without a collection")                                \
    X(HID_ERR_DEPTH, "more than 32 collections within each other")                                 \
    X(HID_ERR_PUSH, "more than 8 pushes without a pop")                                            \
    X(HID_ERR_POP, "a pop without a push")                                                         \
    X(HID_ERR_REPORT_ID, "a report id that is not 1 .. 255")                                       \
    X(HID_ERR_FIELD_SIZE, "a field of more than 256 bits")                                         \
    X(HID_ERR_REPORT_SIZE, "a report of more than 65536 bits")                                     \
    X(HID_ERR_GROUPS, "more than 512 Input items")                                                 \
    X(HID_ERR_RANGES, "more than 2048 usages")                                                     \
    X(HID_ERR_FIELDS, "more than 65536 fields")                                                    \
    X(HID_ERR_USAGE_RANGE, "a usage range that ends before it begins")                             \
    X(HID_ERR_USAGE_PAGES, "a usage range from one page to another")                               \
    X(HID_ERR_USAGE_ALONE, "a usage range that begins and never ends")                             \
    X(HID_ERR_DELIMITER, "delimiters that are nested, or not in pairs")

#define HID_ERROR_NAME(name, text) name,
enum hid_error { HID_ERRORS(HID_ERROR_NAME) HID_ERR_COUNT };

struct hid_descriptor {
    enum hid_error error;
    size_t error_offset; /* Offset of the first byte of the item that caused `error`. */
    bool has_report_ids;
    uint32_t group_count, range_count, field_count;
    /* Number of payload bits of each input report. 0 means that the report is not declared. */
    uint32_t report_bits[256];
    /* Groups in the order of the descriptor. Entries from `group_count` on are undefined. */
    struct hid_group group[HID_GROUP_MAX];
    struct hid_range range[HID_RANGE_MAX];
};

/* Parses a descriptor of `size` bytes. Returns HID_OK or an error, which is also stored in
 * out->error. After an error the lists are incomplete and must not be used. */
enum hid_error hid_descriptor_read(struct hid_descriptor *out, const uint8_t *bytes, size_t size);

/* Returns a description of the error as a phrase without a full stop, in static memory. */
const char *hid_error_text(enum hid_error error);

/* Returns the number of usages of a group. 0 means that the group is padding. */
uint32_t hid_usage_count(const struct hid_descriptor *descriptor, const struct hid_group *group);

/* Returns usage number `index` of a group, found by a binary search of the group's ranges. If the
 * group has fewer usages, the last usage applies to all further fields (HID 1.11, section 6.2.2.8).
 * Returns 0 if the group has no usage. */
hid_usage hid_usage_at(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       uint32_t index);

/* An input report as received from the device. */
struct hid_report {
    /* Content of the report, starting with the report id if the device uses report ids. */
    const uint8_t *bytes;
    size_t size;
};

/* Returns the id of a report, 0 if the device uses no report ids, or -1 if the report is empty. */
int hid_report_id(const struct hid_descriptor *descriptor, struct hid_report report);

/* Returns true if the id of the report is declared and the report is at least as long as
 * declared. */
bool hid_report_is_whole(const struct hid_descriptor *descriptor, struct hid_report report);

/* Returns the value of field `index` (0 to group->count - 1) of a complete report with the group's
 * report id. The value is signed if the logical minimum of a variable field is negative. A field
 * wider than 32 bits returns its low 32 bits. */
int64_t hid_field_value(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        uint32_t index, struct hid_report report);

/* Returns the usage that an array element with the value `value` selects, or 0 if the value selects
 * no usage. */
hid_usage hid_selected(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       int64_t value);

/* ---- Bit fields ------------------------------------------------------------------------------ */

/* Returns the `size` bits (1 to 32) that start at bit `offset` of `bytes`, least significant bit
 * first. Reads only the bytes that contain the field, at most five. */
static inline uint32_t hid_bits_at(const uint8_t *bytes, uint32_t offset, uint32_t size)
{
    CORE_ASSERT(size >= 1 && size <= 32);
    const uint32_t first = offset / 8u, last = (offset + size - 1u) / 8u;
    uint64_t word = 0;
    for (uint32_t i = first; i <= last; i++) {
        word |= (uint64_t)bytes[i] << (8u * (i - first));
    }
    return (uint32_t)(word >> offset % 8u & ((1ull << size) - 1u));
}

/* Returns the `size`-bit number `bits` as two's complement. */
static inline int64_t hid_signed_bits(uint32_t bits, uint32_t size)
{
    CORE_ASSERT(size >= 1 && size <= 32);
    const int64_t half = (int64_t)1 << (size - 1u);
    return bits >= half ? (int64_t)bits - 2 * half : (int64_t)bits;
}
