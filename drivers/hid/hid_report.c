/* hid_report.c -- finds usages in a parsed descriptor, and reads the values of fields from
 * reports. */
#include "drivers/hid/hid_bits.h"
#include "drivers/hid/hid_descriptor.h"

uint32_t hid_usage_count(const struct hid_descriptor *descriptor, const struct hid_group *group)
{
    if (group->range_count == 0) {
        return 0;
    }
    const struct hid_range *last = &descriptor->range[group->range_first + group->range_count - 1u];
    return last->place + (last->last - last->first) + 1u;
}

hid_usage hid_usage_at(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       uint32_t index)
{
    uint32_t low = 0, high = group->range_count; /* The usage is in one of the ranges from index
                                                    `low` to index `high` - 1. */
    if (high == 0) {
        return 0;
    }
    while (high - low > 1u) {
        const uint32_t middle = low + (high - low) / 2u;
        if (index < descriptor->range[group->range_first + middle].place) {
            high = middle;
        } else {
            low = middle;
        }
    }
    const struct hid_range *range = &descriptor->range[group->range_first + low];
    const uint32_t within = index - range->place, most = range->last - range->first;
    return range->first + (within < most ? within : most);
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

int64_t hid_field_value(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        uint32_t index, struct hid_report report)
{
    const uint8_t *payload = report.bytes + descriptor->has_report_ids;
    const uint32_t size = group->bit_size < 32u ? group->bit_size : 32u;
    const uint32_t raw = hid_bits_at(payload, group->bit_offset + index * group->bit_size, size);
    const int is_signed = group->logical_min < 0 && (group->flags & HID_VARIABLE);
    return is_signed ? hid_signed_bits(raw, size) : (int64_t)raw;
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
