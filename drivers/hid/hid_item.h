/* hid_item.h -- the items of a HID report descriptor (HID 1.11, section 6.2.2.2), and the state
 * that Global items set, with the stack of Push and Pop (section 6.2.2.7).
 *
 * A private part of hid_descriptor.c. Pure: uses no device and no clock. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"

enum hid_item_type {
    HID_ITEM_MAIN = 0,
    HID_ITEM_GLOBAL = 1,
    HID_ITEM_LOCAL = 2,
    /* A reserved item, or a long item, for which HID 1.11 defines no tags. */
    HID_ITEM_RESERVED = 3,
};

struct hid_item {
    uint8_t type; /* Type of the item (enum hid_item_type). */
    uint8_t tag;  /* Tag of the item, 0 to 15. */
    uint8_t size; /* Number of data bytes: 0, 1, 2 or 4. */
    uint32_t data;
};

/* Parses the item at `offset`, which must be less than `size`. Finds the end of the item and does
 * not interpret the data. Returns the length of the item in bytes, or 0 if the item extends past
 * the end of `bytes`. */
size_t hid_item_read(struct hid_item *item, const uint8_t *bytes, size_t size, size_t offset);

/* Raw data of a logical or physical limit. A maximum is signed only if its minimum is negative. The
 * minimum can still change until the Input item. */
struct hid_limit {
    uint32_t data;
    uint8_t size;
};

struct hid_globals {
    uint16_t usage_page;
    struct hid_limit logical_min, logical_max, physical_min, physical_max;
    int32_t unit_exponent;
    uint32_t unit, report_size, report_count;
    uint8_t report_id; /* Id of the current report. 0 means that no report id is declared yet. */
};

struct hid_global_stack {
    struct hid_globals now, pushed[HID_PUSH_MAX];
    uint32_t pushed_count; /* Number of Push items without a Pop item. */
};

/* Applies one Global item. Returns HID_OK, or an error if a Push, Pop or Report ID item is
 * invalid. */
enum hid_error hid_globals_take(struct hid_global_stack *stack, const struct hid_item *item);

/* Returns the value of a limit. A minimum is always signed, and a maximum is signed only if its
 * minimum is negative. */
int64_t hid_limit_value(struct hid_limit limit, bool is_signed);
