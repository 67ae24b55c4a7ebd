/* hid_item.c -- parses one item of a HID report descriptor: a prefix byte with the size and the
 * type, and little-endian data. */
#include "drivers/hid/hid_item.h"

/* Prefix of a long item. A size byte, a tag byte and data follow (HID 1.11, section 6.2.2.3). */
#define LONG_ITEM 0xfeu
#define LONG_HEAD_SIZE 3u

int32_t hid_item_signed(uint32_t data, uint8_t size)
{
    return size == 1 ? (int8_t)data : size == 2 ? (int16_t)data : (int32_t)data;
}

static size_t read_long(const uint8_t *bytes, size_t left)
{
    const size_t whole = left > 1 ? LONG_HEAD_SIZE + bytes[1] : SIZE_MAX;
    return whole <= left ? whole : 0;
}

size_t hid_item_read(struct hid_item *item, const uint8_t *bytes, size_t size, size_t offset)
{
    const size_t left = size - offset;
    const uint8_t prefix = bytes[offset];
    *item = (struct hid_item){ .type = HID_ITEM_RESERVED };
    if (prefix == LONG_ITEM) {
        return read_long(bytes + offset, left);
    }
    item->size = (uint8_t)((prefix & 3u) == 3u ? 4u : prefix & 3u);
    item->type = prefix >> 2 & 3u;
    item->tag = prefix >> 4;
    if (left < 1u + item->size) {
        return 0;
    }
    for (uint8_t i = 0; i < item->size; i++) {
        item->data |= (uint32_t)bytes[offset + 1u + i] << (8 * i);
    }
    return 1u + item->size;
}
