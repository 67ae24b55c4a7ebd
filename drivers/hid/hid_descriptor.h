/* hid_descriptor.h -- parses a HID report descriptor into the bit fields of its input reports.
 *
 * Pure: reads bytes and fills a list of fields in the caller's memory. Follows the Device Class
 * Definition for HID 1.11, section 6.2.2, and the HID Usage Tables. The time is linear in the
 * size of the descriptor. Exceeding any limit below is a specific error. */
#ifndef KINGYO_DRIVERS_HID_HID_DESCRIPTOR_H
#define KINGYO_DRIVERS_HID_HID_DESCRIPTOR_H

#include <stddef.h>
#include <stdint.h>

#define HID_DESCRIPTOR_SIZE_MAX 65535u /* Limit of the 16-bit wDescriptorLength. */
#define HID_GROUP_MAX 512u             /* Input items; the richest of 72 real devices has 209. */
#define HID_RANGE_MAX 2048u            /* Usages and usage ranges of all groups together. */
#define HID_DEPTH_MAX 32u              /* Nested collections; real devices nest 4 deep. */
#define HID_PUSH_MAX 8u                /* Pushed globals; real devices push 1. */
#define HID_FIELD_BITS_MAX 256u        /* Largest Report Size of one field. */
#define HID_REPORT_BITS_MAX 65536u /* 8 KiB in one report; the largest real one has 7,487 bytes. */
#define HID_FIELD_MAX 65536u       /* Fields of all groups; fits one report of single bits. */

enum hid_flag { /* Bits of an Input item, HID 1.11 section 6.2.2.5. */
                HID_CONSTANT = 1u << 0,
                /* Set for a variable; clear for an array, whose elements select usages. */
                HID_VARIABLE = 1u << 1,
                HID_RELATIVE = 1u << 2,
                HID_NULL_STATE = 1u << 6, /* A value outside the logical range means "no value". */
};

/* Usage page << 16 | usage id. */
typedef uint32_t hid_usage;

struct hid_range {
    hid_usage first, last; /* First and last usage, both inclusive; first <= last. */
    uint32_t place; /* Number of usages in its group before this range, at most 2047 * 65536. */
};

/* The fields of one Input item: `count` fields of `bit_size` bits in a row. */
struct hid_group {
    hid_usage application; /* Nearest enclosing Application collection, or 0. */
    uint8_t report_id;     /* 0 if the device uses no report ids. */
    uint32_t bit_offset;   /* Offset of the first field, counted behind the report id. */
    uint32_t bit_size, count;
    uint32_t flags; /* All bits of the item, including those not in enum hid_flag. */
    int64_t logical_min, logical_max;
    /* Both 0 if not declared; the logical range then applies. */
    int64_t physical_min, physical_max;
    int32_t unit_exponent; /* Exponent of the unit as a power of ten. */
    uint32_t unit;
    uint16_t range_first, range_count; /* Usages of the group, in hid_descriptor.range. */
};

enum hid_error {
    HID_OK = 0,
    HID_ERR_TOO_LONG,        /* More than HID_DESCRIPTOR_SIZE_MAX bytes. */
    HID_ERR_CUT_OFF,         /* The data ends within an item. */
    HID_ERR_OPEN_COLLECTION, /* The data ends within a collection. */
    HID_ERR_NO_COLLECTION,   /* End Collection without a collection. */
    HID_ERR_DEPTH,           /* Collections nested deeper than HID_DEPTH_MAX. */
    HID_ERR_PUSH,            /* More than HID_PUSH_MAX Push items without Pop. */
    HID_ERR_POP,             /* Pop without Push. */
    HID_ERR_REPORT_ID,       /* Report ID outside 1 .. 255. */
    HID_ERR_FIELD_SIZE,      /* A field of more than HID_FIELD_BITS_MAX bits. */
    HID_ERR_REPORT_SIZE,     /* A report of more than HID_REPORT_BITS_MAX bits. */
    HID_ERR_GROUPS,          /* More than HID_GROUP_MAX Input items. */
    HID_ERR_RANGES,          /* More than HID_RANGE_MAX usages. */
    HID_ERR_FIELDS,          /* More than HID_FIELD_MAX fields. */
    HID_ERR_USAGE_RANGE,     /* Usage Minimum above Usage Maximum. */
    HID_ERR_USAGE_PAGES,     /* Usage Minimum and Maximum on different pages. */
    HID_ERR_USAGE_ALONE,     /* Usage Minimum without Usage Maximum. */
    HID_ERR_DELIMITER,       /* Delimiters nested, or not closed before the main item. */
    HID_ERR_COUNT,
};

struct hid_descriptor {
    enum hid_error error;
    size_t error_offset; /* Offset of the first byte of the faulty item. */
    uint8_t has_report_ids;
    uint32_t group_count, range_count, field_count;
    uint32_t report_bits[256]; /* Payload bits of each input report; 0 if not declared. */
    struct hid_group group[HID_GROUP_MAX]; /* Entries beyond the counts are undefined. */
    struct hid_range range[HID_RANGE_MAX];
};

/* Parses a descriptor of `size` bytes. Returns HID_OK, or an error, which is also in out->error.
 * After an error the lists are incomplete and must not be used. */
enum hid_error hid_descriptor_read(struct hid_descriptor *out, const uint8_t *bytes, size_t size);

/* Returns the error as a phrase without a full stop, in static memory. */
const char *hid_error_text(enum hid_error error);

/* Returns the number of usages of a group; 0 means padding. */
uint32_t hid_usage_count(const struct hid_descriptor *descriptor, const struct hid_group *group);

/* Returns the usage with number `index` of a group, by a binary search of its ranges. The last
 * usage applies to all further fields (HID 1.11, 6.2.2.8). Returns 0 if the group has no usage. */
hid_usage hid_usage_at(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       uint32_t index);

/* A report as received from the device. */
struct hid_report {
    const uint8_t *bytes; /* Starts with the report id if the device uses report ids. */
    size_t size;
};

/* Returns the id of a report, 0 for devices without report ids, or -1 for an empty report. */
int hid_report_id(const struct hid_descriptor *descriptor, struct hid_report report);

/* Returns 1 if the report has a declared id and is not shorter than declared. */
int hid_report_is_whole(const struct hid_descriptor *descriptor, struct hid_report report);

/* Returns the value of field `index` < group->count from a complete report of the group's id.
 * The value is signed if the logical minimum is negative. Fields wider than 32 bits return their
 * low 32 bits. */
int64_t hid_field_value(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        uint32_t index, struct hid_report report);

/* Returns the usage that an array element of value `value` selects, or 0. */
hid_usage hid_selected(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       int64_t value);

#endif
