/* hid_descriptor.h -- reads a HID report descriptor: which bits of which report mean what.
 *
 * Pure: bytes in, a list of input fields out; no memory but the caller's, no device. Follows the
 * Device Class Definition for HID 1.11, section 6.2.2, and the HID Usage Tables for what a usage
 * is. Time is linear in the descriptor, and every limit below is a clear error when passed. */
#ifndef KINGYO_DRIVERS_HID_DESCRIPTOR_H
#define KINGYO_DRIVERS_HID_DESCRIPTOR_H

#include <stddef.h>
#include <stdint.h>

#define HID_DESCRIPTOR_SIZE_MAX 65535u /* wDescriptorLength is 16 bits. */
#define HID_GROUP_MAX 512u             /* Input items; the richest of 72 real devices has 209. */
#define HID_RANGE_MAX 2048u            /* Usages and usage ranges of all of them together. */
#define HID_DEPTH_MAX 32u              /* Nested collections; real devices nest 4 deep. */
#define HID_PUSH_MAX 8u                /* Pushed globals; real devices push 1. */
#define HID_FIELD_BITS_MAX 256u        /* Report Size of one field. */
#define HID_REPORT_BITS_MAX 65536u /* Of one report: 8 KiB; the largest real one has 7,487 bytes. */
#define HID_FIELD_MAX 65536u /* Of all groups together: one such report, a bit each. */

enum hid_flag { /* Of an Input item, HID 1.11 section 6.2.2.5. */
                HID_CONSTANT = 1u << 0,
                HID_VARIABLE = 1u << 1, /* Else an array: each element names one of the usages. */
                HID_RELATIVE = 1u << 2,
                HID_NULL_STATE = 1u << 6, /* A value out of the logical range says "nothing". */
};

/* Usage page << 16 | usage id. */
typedef uint32_t hid_usage;

struct hid_range {
    hid_usage first, last; /* Inclusive; first <= last. */
    uint32_t place;        /* How many usages its group has before it: at most 2047 * 65536. */
};

/* What one Input item declared: `count` fields of `bit_size` bits, one after the other. */
struct hid_group {
    hid_usage application; /* Of the nearest Application collection around it; 0: none. */
    uint8_t report_id;     /* 0: the device uses none. */
    uint32_t bit_offset;   /* Of the first field, from the first bit behind the report id. */
    uint32_t bit_size, count;
    uint32_t flags; /* enum hid_flag and the bits that it leaves out. */
    int64_t logical_min, logical_max;
    int64_t physical_min, physical_max; /* 0, 0: not declared, as the logical ones. */
    int32_t unit_exponent;              /* Power of ten. */
    uint32_t unit;
    uint16_t range_first, range_count; /* Its usages, in hid_descriptor.range. */
};

enum hid_error {
    HID_OK = 0,
    HID_ERR_TOO_LONG,        /* More than HID_DESCRIPTOR_SIZE_MAX bytes. */
    HID_ERR_CUT_OFF,         /* It ends within an item. */
    HID_ERR_OPEN_COLLECTION, /* It ends within a collection. */
    HID_ERR_NO_COLLECTION,   /* End Collection without a collection. */
    HID_ERR_DEPTH,           /* More than HID_DEPTH_MAX collections within each other. */
    HID_ERR_PUSH,            /* More than HID_PUSH_MAX pushes without a pop. */
    HID_ERR_POP,             /* A pop without a push. */
    HID_ERR_REPORT_ID,       /* Not 1 .. 255. */
    HID_ERR_FIELD_SIZE,      /* A field of more than HID_FIELD_BITS_MAX bits. */
    HID_ERR_REPORT_SIZE,     /* A report of more than HID_REPORT_BITS_MAX bits. */
    HID_ERR_GROUPS,          /* More than HID_GROUP_MAX Input items. */
    HID_ERR_RANGES,          /* More than HID_RANGE_MAX usages. */
    HID_ERR_FIELDS,          /* More than HID_FIELD_MAX fields. */
    HID_ERR_USAGE_RANGE,     /* Usage Minimum above Usage Maximum ... */
    HID_ERR_USAGE_PAGES,     /* ... or on another page than it ... */
    HID_ERR_USAGE_ALONE,     /* ... or without one. */
    HID_ERR_DELIMITER,       /* Delimiters nested, or not in pairs before the main item. */
    HID_ERR_COUNT,
};

struct hid_descriptor {
    enum hid_error error;
    size_t error_offset; /* Of the item's first byte. */
    uint8_t has_report_ids;
    uint32_t group_count, range_count, field_count;
    uint32_t report_bits[256]; /* Of the payload of each input report; 0: there is none. */
    struct hid_group group[HID_GROUP_MAX]; /* Beyond their counts both lists hold anything. */
    struct hid_range range[HID_RANGE_MAX];
};

/* Fills `out`, wholly on HID_OK; on an error its lists are what came before, and not to be used. */
enum hid_error hid_descriptor_read(struct hid_descriptor *out, const uint8_t *bytes, size_t size);

/* One sentence without a full stop; static. */
const char *hid_error_text(enum hid_error error);

/* How many usages a group has; 0: padding. */
uint32_t hid_usage_count(const struct hid_descriptor *descriptor, const struct hid_group *group);

/* Its usage number `index`, in the logarithm of its ranges. A list that is too short repeats its
 * last (HID 1.11, 6.2.2.8); 0 when it has none. */
hid_usage hid_usage_at(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       uint32_t index);

/* A report as it came from the wire. */
struct hid_report {
    const uint8_t *bytes; /* With the report id first, if the device uses them. */
    size_t size;
};

/* The report's id, or 0 for devices without; -1 for an empty report. */
int hid_report_id(const struct hid_descriptor *descriptor, struct hid_report report);

/* Whether it is as long as declared, and an input report of this device at all. */
int hid_report_is_whole(const struct hid_descriptor *descriptor, struct hid_report report);

/* The value of field `index` < group->count in a whole report of the group's id: signed if the
 * logical minimum is negative. Fields wider than 32 bits give their low 32. */
int64_t hid_field_value(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        uint32_t index, struct hid_report report);

/* The usage that an array's element selects, or 0. */
hid_usage hid_selected(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       int64_t value);

#endif
