/* report.c -- fuzz target: an arbitrary report descriptor and reports in its format. Every decoded
 * value is compared with a reference decoder that reads bit by bit.
 *
 * Input: two bytes for the size of the descriptor, low byte first, the descriptor, and reports. A
 * report is a byte of size and the bytes of the report. */
#include <stdlib.h>
#include <string.h>

#include "drivers/hid/hid_descriptor.h"
#include "tests/fuzz/trap.h"

/* Number of fields of a report whose values are compared. The largest reports have 65,536 fields,
 * and comparing all of them would take too long. */
#define FIELDS_HELD 512u

static struct hid_descriptor descriptor;

static int64_t bit_by_bit(const struct hid_group *group, uint32_t index, struct hid_report report)
{
    const uint32_t size = group->bit_size < 32u ? group->bit_size : 32u;
    const uint32_t head = 8u * descriptor.has_report_ids;
    const uint32_t first = head + group->bit_offset + index * group->bit_size;
    uint64_t value = 0;
    for (uint32_t i = 0; i < size; i++) {
        const uint32_t bit = first + i;
        HOLD(bit / 8u < report.size);
        value |= (uint64_t)(report.bytes[bit / 8u] >> bit % 8u & 1u) << i;
    }
    const int is_signed = group->logical_min < 0 && (group->flags & HID_VARIABLE);
    const int is_negative = is_signed && value >> (size - 1u);
    return is_negative ? (int64_t)value - (int64_t)(1ull << size) : (int64_t)value;
}

static void hold_field(const struct hid_group *group, uint32_t index, struct hid_report report)
{
    const int64_t value = hid_field_value(&descriptor, group, index, report);
    HOLD(value == bit_by_bit(group, index, report));
    const hid_usage usage = hid_selected(&descriptor, group, value);
    const int is_in = value >= group->logical_min && value <= group->logical_max;
    HOLD(is_in || usage == 0);
}

static void hold_report(struct hid_report report)
{
    const int id = hid_report_id(&descriptor, report);
    HOLD(id >= -1 && id <= 255);
    if (!hid_report_is_whole(&descriptor, report)) {
        return;
    }
    HOLD(report.size * 8u >= descriptor.report_bits[id] + 8u * descriptor.has_report_ids);
    for (uint32_t i = 0; i < descriptor.group_count; i++) {
        const struct hid_group *group = &descriptor.group[i];
        for (uint32_t index = 0; group->report_id == id && index < group->count; index++) {
            if (index < FIELDS_HELD || index + 1u == group->count) {
                hold_field(group, index, report);
            }
        }
    }
}

/* Decodes a copy of the report in a heap block of exactly `size` bytes, so that the sanitizer
 * detects a read beyond the end of the report. */
static void hold_copy(const uint8_t *bytes, size_t size)
{
    uint8_t *copy = malloc(size ? size : 1u);
    HOLD(copy);
    memcpy(copy, bytes, size);
    hold_report((struct hid_report){ copy, size });
    free(copy);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 2u) {
        return 0;
    }
    size_t at = 2u + (size_t)(bytes[0] | bytes[1] << 8);
    at = at < size ? at : size;
    if (hid_descriptor_read(&descriptor, bytes + 2, at - 2u)) {
        return 0;
    }
    while (at < size) {
        const size_t left = size - at - 1u, requested = bytes[at];
        const size_t taken = requested < left ? requested : left;
        hold_copy(bytes + at + 1u, taken);
        at += 1u + taken;
    }
    return 0;
}
