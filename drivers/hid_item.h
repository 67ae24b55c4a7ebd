/* hid_item.h -- the items that a report descriptor is made of: HID 1.11, section 6.2.2.2.
 *
 * A private part of hid_descriptor.c. Pure: it knows where an item ends, not what it means. */
#ifndef KINGYO_DRIVERS_HID_ITEM_H
#define KINGYO_DRIVERS_HID_ITEM_H

#include <stddef.h>
#include <stdint.h>

enum hid_item_type {
    HID_ITEM_MAIN = 0,
    HID_ITEM_GLOBAL = 1,
    HID_ITEM_LOCAL = 2,
    HID_ITEM_RESERVED = 3, /* Long items too: nobody has given one a meaning. */
};

struct hid_item {
    uint8_t type; /* enum hid_item_type */
    uint8_t tag;  /* 0 .. 15 */
    uint8_t size; /* Of its data: 0, 1, 2 or 4 bytes. */
    uint32_t data;
};

/* Reads the item at `offset` < size. Returns the bytes that it takes, or 0 if it is cut off. */
size_t hid_item_read(struct hid_item *item, const uint8_t *bytes, size_t size, size_t offset);

/* Its data as two's complement of as many bytes as it has. */
int32_t hid_item_signed(uint32_t data, uint8_t size);

#endif
