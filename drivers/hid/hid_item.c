/* hid_item.c -- parses one item of a HID report descriptor, which is a prefix byte with the size
 * and the type, and little-endian data. Applies the Global items to the state of the parser. */
#include "drivers/hid/hid_item.h"

#include "core/base/panic.h"

/* Prefix of a long item. A size byte, a tag byte and data follow (HID 1.11, section 6.2.2.3). */
#define LONG_ITEM 0xfeu
#define LONG_HEAD_SIZE 3u

enum global_tag {
    GLOBAL_USAGE_PAGE = 0,
    GLOBAL_LOGICAL_MIN = 1,
    GLOBAL_LOGICAL_MAX = 2,
    GLOBAL_PHYSICAL_MIN = 3,
    GLOBAL_PHYSICAL_MAX = 4,
    GLOBAL_UNIT_EXPONENT = 5,
    GLOBAL_UNIT = 6,
    GLOBAL_REPORT_SIZE = 7,
    GLOBAL_REPORT_ID = 8,
    GLOBAL_REPORT_COUNT = 9,
    GLOBAL_PUSH = 10,
    GLOBAL_POP = 11,
};

size_t hid_item_read(struct hid_item *item, const uint8_t *bytes, size_t size, size_t offset)
{
    CORE_ASSERT(offset < size);
    const size_t left = size - offset;
    const uint8_t prefix = bytes[offset];
    *item = (struct hid_item){ .type = HID_ITEM_RESERVED };
    if (prefix == LONG_ITEM) {
        const size_t whole = left > 1 ? LONG_HEAD_SIZE + bytes[offset + 1u] : SIZE_MAX;
        return whole <= left ? whole : 0;
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

/* Returns `data` as two's complement of `size` bytes (0, 1, 2 or 4). */
static int32_t hid_item_signed(uint32_t data, uint8_t size)
{
    CORE_ASSERT(size <= 2 || size == 4);
    return size == 1 ? (int8_t)data : size == 2 ? (int16_t)data : (int32_t)data;
}

int64_t hid_limit_value(struct hid_limit limit, bool is_signed)
{
    return is_signed ? hid_item_signed(limit.data, limit.size) : (int64_t)limit.data;
}

enum hid_error hid_globals_take(struct hid_global_stack *stack, const struct hid_item *item)
{
    struct hid_globals *now = &stack->now;
    struct hid_limit *const limits[] = { &now->logical_min, &now->logical_max, &now->physical_min,
                                         &now->physical_max };
    CORE_ASSERT(item->type == HID_ITEM_GLOBAL);
    CORE_ASSERT(stack->pushed_count <= HID_PUSH_MAX);
    switch (item->tag) {
    case GLOBAL_USAGE_PAGE:
        now->usage_page = (uint16_t)item->data;
        break;
    case GLOBAL_LOGICAL_MIN:
    case GLOBAL_LOGICAL_MAX:
    case GLOBAL_PHYSICAL_MIN:
    case GLOBAL_PHYSICAL_MAX:
        *limits[item->tag - GLOBAL_LOGICAL_MIN] = (struct hid_limit){ item->data, item->size };
        break;
    case GLOBAL_UNIT_EXPONENT:
        /* The HID specification defines the exponent as a number of four bits, in which 8 to 15
         * mean -8 to -1. Some devices write the exponent as a signed byte instead. */
        now->unit_exponent = item->data <= 15u ? (int32_t)item->data - (item->data > 7u ? 16 : 0)
                                               : hid_item_signed(item->data, item->size);
        break;
    case GLOBAL_UNIT:
        now->unit = item->data;
        break;
    case GLOBAL_REPORT_SIZE:
        now->report_size = item->data;
        break;
    case GLOBAL_REPORT_ID:
        if (item->data == 0 || item->data > 255u) {
            return HID_ERR_REPORT_ID;
        }
        now->report_id = (uint8_t)item->data;
        break;
    case GLOBAL_REPORT_COUNT:
        now->report_count = item->data;
        break;
    case GLOBAL_PUSH:
        if (stack->pushed_count == HID_PUSH_MAX) {
            return HID_ERR_PUSH;
        }
        stack->pushed[stack->pushed_count++] = stack->now;
        break;
    case GLOBAL_POP:
        if (stack->pushed_count == 0) {
            return HID_ERR_POP;
        }
        stack->now = stack->pushed[--stack->pushed_count];
        break;
    default: /* Reserved tags are skipped, because HID 1.11 section 6.2.2.7 reserves them for
                extensions. */
        break;
    }
    return HID_OK;
}
