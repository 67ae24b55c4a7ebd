/* descriptor.c -- fuzz target: arbitrary bytes as a report descriptor. The parser must either
 * reject the bytes, or return a consistent list of fields. */
#include <string.h>

#include "drivers/hid/hid_descriptor.h"
#include "tests/fuzz/trap.h"

/* Results of parsing the same bytes twice. The two buffers have different old contents, but the
 * results must be equal, so that no data of a previous descriptor remains in a result. */
static struct hid_descriptor first, again;

static void hold_usages(const struct hid_group *group)
{
    HOLD(group->range_count > 0 && group->range_first + group->range_count <= first.range_count);
    for (uint32_t i = 0; i < group->range_count; i++) {
        const struct hid_range *range = &first.range[group->range_first + i];
        HOLD(range->first <= range->last && range->first >> 16 == range->last >> 16);
    }
    const uint32_t count = hid_usage_count(&first, group);
    const hid_usage last = hid_usage_at(&first, group, count - 1u);
    HOLD(count > 0 && last == first.range[group->range_first + group->range_count - 1u].last);
    HOLD(hid_usage_at(&first, group, count) == last);
    HOLD(hid_usage_at(&first, group, UINT32_MAX) == last);
}

static void hold_group(const struct hid_group *group, uint32_t end_bit[256])
{
    const uint32_t id = group->report_id;
    HOLD(group->count > 0 && group->bit_size > 0 && group->bit_size <= HID_FIELD_BITS_MAX);
    /* The fields must be in ascending order and must not overlap. */
    HOLD(group->bit_offset >= end_bit[id]);
    end_bit[id] = group->bit_offset + group->count * group->bit_size;
    HOLD(end_bit[id] <= first.report_bits[id] && first.report_bits[id] <= HID_REPORT_BITS_MAX);
    HOLD(id == 0 || first.has_report_ids);
    hold_usages(group);
}

static void hold_list(void)
{
    uint32_t end_bit[256] = { 0 }, field_count = 0;
    for (uint32_t i = 0; i < first.group_count; i++) {
        hold_group(&first.group[i], end_bit);
        field_count += first.group[i].count;
    }
    HOLD(field_count == first.field_count && field_count <= HID_FIELD_MAX);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const enum hid_error error = hid_descriptor_read(&first, bytes, size);
    HOLD(error == first.error && (unsigned)error < HID_ERR_COUNT);
    HOLD(first.group_count <= HID_GROUP_MAX && first.range_count <= HID_RANGE_MAX);
    if (error) {
        HOLD(first.error_offset <= size && strlen(hid_error_text(error)) > 0);
        return 0;
    }
    hold_list();
    HOLD(hid_descriptor_read(&again, bytes, size) == HID_OK);
    HOLD(again.group_count == first.group_count && again.range_count == first.range_count);
    HOLD(memcmp(again.range, first.range, first.range_count * sizeof first.range[0]) == 0);
    HOLD(memcmp(again.report_bits, first.report_bits, sizeof first.report_bits) == 0);
    return 0;
}
