/* hid_item.h -- the items of a HID report descriptor (HID 1.11, section 6.2.2.2).
 *
 * A private part of hid_descriptor.c. Pure: finds where an item ends and does not interpret it. */
#ifndef KINGYO_DRIVERS_HID_HID_ITEM_H
#define KINGYO_DRIVERS_HID_HID_ITEM_H

#include <stddef.h>
#include <stdint.h>

enum hid_item_type {
    HID_ITEM_MAIN = 0,
    HID_ITEM_GLOBAL = 1,
    HID_ITEM_LOCAL = 2,
    HID_ITEM_RESERVED = 3, /* Also used for long items, for which HID 1.11 defines no tags. */
};

struct hid_item {
    uint8_t type; /* enum hid_item_type */
    uint8_t tag;  /* 0 .. 15 */
    uint8_t size; /* Number of data bytes: 0, 1, 2 or 4. */
    uint32_t data;
};

/* Parses the item at `offset` < size. Returns the length of the item in bytes, or 0 if the item
 * extends past the end. */
size_t hid_item_read(struct hid_item *item, const uint8_t *bytes, size_t size, size_t offset);

/* Returns the data of an item as two's complement of `size` bytes. */
int32_t hid_item_signed(uint32_t data, uint8_t size);

#endif
