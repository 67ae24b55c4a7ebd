/* hid_report.c -- what was read, put to use: usages of groups, values of reports. */
#include "drivers/hid_descriptor.h"

uint32_t hid_usage_count(const struct hid_descriptor *descriptor, const struct hid_group *group)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < group->range_count; i++) {
        const struct hid_range *range = &descriptor->range[group->range_first + i];
        count += range->last - range->first + 1u; /* One page each: at most 2048 * 65536. */
    }
    return count;
}

hid_usage hid_usage_at(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       uint32_t index)
{
    hid_usage last = 0;
    for (uint32_t i = 0; i < group->range_count; i++) {
        const struct hid_range *range = &descriptor->range[group->range_first + i];
        const uint32_t count = range->last - range->first + 1u;
        if (index < count) {
            return range->first + index;
        }
        index -= count;
        last = range->last;
    }
    return last;
}

int hid_report_id(const struct hid_descriptor *descriptor, struct hid_report report)
{
    if (!descriptor->has_report_ids) {
        return 0;
    }
    return report.size > 0 ? report.bytes[0] : -1;
}

int hid_report_is_whole(const struct hid_descriptor *descriptor, struct hid_report report)
{
    const int id = hid_report_id(descriptor, report);
    if (id < 0 || descriptor->report_bits[id] == 0) {
        return 0;
    }
    const size_t payload = (descriptor->report_bits[id] + 7u) / 8u;
    return report.size >= payload + descriptor->has_report_ids;
}

/* Up to 32 bits from any place: at most five bytes. */
static uint32_t bits_at(const uint8_t *bytes, uint32_t offset, uint32_t size)
{
    const uint32_t first = offset / 8u, last = (offset + size - 1u) / 8u;
    uint64_t word = 0;
    for (uint32_t i = first; i <= last; i++) {
        word |= (uint64_t)bytes[i] << (8u * (i - first));
    }
    return (uint32_t)(word >> offset % 8u & ((1ull << size) - 1u));
}

int64_t hid_field_value(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        uint32_t index, struct hid_report report)
{
    const uint8_t *payload = report.bytes + descriptor->has_report_ids;
    const uint32_t size = group->bit_size < 32u ? group->bit_size : 32u;
    const uint32_t raw = bits_at(payload, group->bit_offset + index * group->bit_size, size);
    const int64_t half = (int64_t)1 << (size - 1u);
    const int is_signed = group->logical_min < 0 && (group->flags & HID_VARIABLE);
    return is_signed && raw >= half ? (int64_t)raw - 2 * half : (int64_t)raw;
}

hid_usage hid_selected(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       int64_t value)
{
    const int64_t index = value - group->logical_min;
    const int in_range = value >= group->logical_min && value <= group->logical_max;
    if (!in_range || index >= (int64_t)hid_usage_count(descriptor, group)) {
        return 0;
    }
    return hid_usage_at(descriptor, group, (uint32_t)index);
}
