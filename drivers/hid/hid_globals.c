/* hid_globals.c -- parses the Global items of a HID report descriptor. */
#include "drivers/hid/hid_globals.h"

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

int64_t hid_limit_min(struct hid_limit limit)
{
    return hid_item_signed(limit.data, limit.size);
}

int64_t hid_limit_max(struct hid_limit limit, int64_t min)
{
    return min < 0 ? hid_limit_min(limit) : (int64_t)limit.data;
}

static enum hid_error hid_globals_push(struct hid_global_stack *stack)
{
    if (stack->pushed_count == HID_PUSH_MAX) {
        return HID_ERR_PUSH;
    }
    stack->pushed[stack->pushed_count++] = stack->now;
    return HID_OK;
}

static enum hid_error pop(struct hid_global_stack *stack)
{
    if (stack->pushed_count == 0) {
        return HID_ERR_POP;
    }
    stack->now = stack->pushed[--stack->pushed_count];
    return HID_OK;
}

static enum hid_error take_report_id(struct hid_globals *now, uint32_t id)
{
    if (id == 0 || id > 255u) {
        return HID_ERR_REPORT_ID;
    }
    now->report_id = (uint8_t)id;
    return HID_OK;
}

/* Returns the exponent of a Unit Exponent item. The specification defines a value of four bits,
 * where 8 to 15 mean -8 to -1. Some devices write the exponent as a signed byte instead. */
static int32_t unit_exponent(const struct hid_item *item)
{
    const uint32_t nibble = item->data;
    return nibble <= 15u ? (int32_t)nibble - (nibble > 7u ? 16 : 0)
                         : hid_item_signed(item->data, item->size);
}

enum hid_error hid_globals_take(struct hid_global_stack *stack, const struct hid_item *item)
{
    struct hid_globals *now = &stack->now;
    const struct hid_limit limit = { item->data, item->size };
    switch (item->tag) {
    case GLOBAL_USAGE_PAGE:
        now->usage_page = (uint16_t)item->data;
        break;
    case GLOBAL_LOGICAL_MIN:
        now->logical_min = limit;
        break;
    case GLOBAL_LOGICAL_MAX:
        now->logical_max = limit;
        break;
    case GLOBAL_PHYSICAL_MIN:
        now->physical_min = limit;
        break;
    case GLOBAL_PHYSICAL_MAX:
        now->physical_max = limit;
        break;
    case GLOBAL_UNIT_EXPONENT:
        now->unit_exponent = unit_exponent(item);
        break;
    case GLOBAL_UNIT:
        now->unit = item->data;
        break;
    case GLOBAL_REPORT_SIZE:
        now->report_size = item->data;
        break;
    case GLOBAL_REPORT_ID:
        return take_report_id(now, item->data);
    case GLOBAL_REPORT_COUNT:
        now->report_count = item->data;
        break;
    case GLOBAL_PUSH:
        return hid_globals_push(stack);
    case GLOBAL_POP:
        return pop(stack);
    default: /* Reserved tags are skipped, because HID 1.11 section 6.2.2.7 reserves them for
                extensions. */
        break;
    }
    return HID_OK;
}
