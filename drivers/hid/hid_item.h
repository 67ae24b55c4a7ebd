/* hid_item.h -- the items of a HID report descriptor (HID 1.11, section 6.2.2.2).
 *
 * A private part of hid_descriptor.c. The parser finds the end of an item and does not interpret
 * the data. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_HID_HID_ITEM_H
#define KINGYO_DRIVERS_HID_HID_ITEM_H

#include <stddef.h>
#include <stdint.h>

enum hid_item_type {
    HID_ITEM_MAIN = 0,
    HID_ITEM_GLOBAL = 1,
    HID_ITEM_LOCAL = 2,
    HID_ITEM_RESERVED = 3, /* A reserved item, or a long item, for which HID 1.11 defines no
                              tags. */
};

struct hid_item {
    uint8_t type; /* Type of the item (enum hid_item_type). */
    uint8_t tag;  /* Tag of the item, 0 to 15. */
    uint8_t size; /* Number of data bytes: 0, 1, 2 or 4. */
    uint32_t data;
};

/* Parses the item at `offset`, which must be less than `size`. Returns the length of the item in
 * bytes, or 0 if the item extends past the end of `bytes`. */
size_t hid_item_read(struct hid_item *item, const uint8_t *bytes, size_t size, size_t offset);

/* Returns `data` as two's complement of `size` bytes (0, 1, 2 or 4). */
int32_t hid_item_signed(uint32_t data, uint8_t size);

#endif
