/* hid_descriptor.c -- parses a HID report descriptor in one pass, finds usages in the parsed
 * descriptor, and reads the values of fields from reports.
 *
 * Global and Local items set the state of the parser. Each Input item adds a group of fields from
 * that state. */
#include "drivers/hid/hid_descriptor.h"

#include <string.h>

#include "core/base/panic.h"
#include "drivers/hid/hid_item.h"

enum main_tag { MAIN_INPUT = 8, MAIN_COLLECTION = 10, MAIN_END_COLLECTION = 12 };

enum local_tag { LOCAL_USAGE = 0, LOCAL_USAGE_MIN = 1, LOCAL_USAGE_MAX = 2, LOCAL_DELIMITER = 10 };

#define COLLECTION_APPLICATION 1u

struct reader {
    struct hid_descriptor *out;
    struct hid_global_stack globals;
    /* Usage of the Application collection at each nesting depth. */
    hid_usage application[HID_DEPTH_MAX + 1u];
    uint32_t depth;
    uint32_t range_first; /* Index in out->range at which the usages of the current main item
                             start. */
    hid_usage usage_min;
    bool has_usage_min;
    /* True while the parser is between the opening and the closing Delimiter item of a set of
     * alternative usages. */
    bool in_delimiter;
    uint8_t
        /* Number of alternative usages between the Delimiter items. Only the first usage is
         * used. */
        alternatives;
};

/* ---- Usages (Local items) ------------------------------------------------------------------- */

static enum hid_error add_range(struct reader *reader, hid_usage first, hid_usage last)
{
    CORE_ASSERT(reader->range_first <= reader->out->range_count);
    struct hid_descriptor *out = reader->out;
    if (first >> 16 != last >> 16) {
        return HID_ERR_USAGE_PAGES;
    }
    if (first > last) {
        return HID_ERR_USAGE_RANGE;
    }
    if (out->range_count == HID_RANGE_MAX) {
        return HID_ERR_RANGES;
    }
    uint32_t place = 0;
    if (out->range_count > reader->range_first) {
        const struct hid_range *before = &out->range[out->range_count - 1u];
        place = before->place + (before->last - before->first) + 1u;
    }
    out->range[out->range_count++] = (struct hid_range){ first, last, place };
    return HID_OK;
}

static enum hid_error read_local(struct reader *reader, const struct hid_item *item)
{
    CORE_ASSERT(item->type == HID_ITEM_LOCAL);
    if (item->tag == LOCAL_DELIMITER) {
        if ((item->data != 0) == reader->in_delimiter) {
            return HID_ERR_DELIMITER;
        }
        reader->in_delimiter = item->data != 0;
        reader->alternatives = 0;
        return HID_OK;
    }
    const bool names_usage = item->tag == LOCAL_USAGE || item->tag == LOCAL_USAGE_MAX;
    if (reader->in_delimiter && names_usage && reader->alternatives++ > 0) {
        return HID_OK;
    }
    /* A usage of one or two bytes belongs to the usage page that is current at the item. */
    const uint32_t page = reader->globals.now.usage_page;
    const hid_usage usage = item->size == 4 ? item->data : page << 16 | item->data;
    switch (item->tag) {
    case LOCAL_USAGE:
        return add_range(reader, usage, usage);
    case LOCAL_USAGE_MIN:
        reader->usage_min = usage;
        reader->has_usage_min = true;
        return HID_OK;
    case LOCAL_USAGE_MAX: {
        /* A Usage Maximum of four bytes contains the usage page for both the minimum and the
         * maximum. A Usage Maximum without a Usage Minimum means a range from usage id 0. */
        const hid_usage first = reader->has_usage_min ? reader->usage_min : usage & 0xffff0000u;
        reader->has_usage_min = false;
        return add_range(reader, first, usage);
    }
    default: /* Designator and String items do not affect the layout of reports. */
        return HID_OK;
    }
}

/* ---- Main items ----------------------------------------------------------------------------- */

static struct hid_group group_of(const struct reader *reader, uint32_t flags)
{
    CORE_ASSERT(reader->depth <= HID_DEPTH_MAX);
    CORE_ASSERT(reader->range_first <= reader->out->range_count);
    const struct hid_globals *now = &reader->globals.now;
    struct hid_group group = {
        .application = reader->application[reader->depth],
        .report_id = now->report_id,
        .bit_offset = reader->out->report_bits[now->report_id],
        .bit_size = now->report_size,
        .count = now->report_count,
        .flags = flags,
        .logical_min = hid_limit_value(now->logical_min, true),
        .physical_min = hid_limit_value(now->physical_min, true),
        .unit_exponent = now->unit_exponent,
        .unit = now->unit,
        .range_first = (uint16_t)reader->range_first,
        .range_count = (uint16_t)(reader->out->range_count - reader->range_first),
    };
    group.logical_max = hid_limit_value(now->logical_max, group.logical_min < 0);
    group.physical_max = hid_limit_value(now->physical_max, group.physical_min < 0);
    return group;
}

static enum hid_error add_input(struct reader *reader, uint32_t flags)
{
    CORE_ASSERT(reader->out->group_count <= HID_GROUP_MAX);
    CORE_ASSERT(reader->out->field_count <= HID_FIELD_MAX);
    struct hid_descriptor *out = reader->out;
    const struct hid_globals *now = &reader->globals.now;
    const uint32_t used = out->report_bits[now->report_id];
    const uint64_t bits = (uint64_t)now->report_size * now->report_count;
    if (bits > HID_REPORT_BITS_MAX - used) {
        return HID_ERR_REPORT_SIZE;
    }
    const struct hid_group group = group_of(reader, flags);
    out->report_bits[now->report_id] = used + (uint32_t)bits;
    if (bits == 0 || group.range_count == 0) {
        return HID_OK; /* The Input item has no bits, or its bits are padding. */
    }
    if (now->report_size > HID_FIELD_BITS_MAX) {
        return HID_ERR_FIELD_SIZE;
    }
    if (out->group_count == HID_GROUP_MAX) {
        return HID_ERR_GROUPS;
    }
    if (now->report_count > HID_FIELD_MAX - out->field_count) {
        return HID_ERR_FIELDS;
    }
    out->field_count += now->report_count;
    out->group[out->group_count++] = group;
    return HID_OK;
}

static enum hid_error read_main(struct reader *reader, const struct hid_item *item)
{
    CORE_ASSERT(item->type == HID_ITEM_MAIN);
    if (reader->in_delimiter) {
        return HID_ERR_DELIMITER; /* Delimiters must be closed before the main item. */
    }
    switch (item->tag) {
    case MAIN_INPUT:
        return reader->has_usage_min ? HID_ERR_USAGE_ALONE : add_input(reader, item->data);
    case MAIN_COLLECTION: {
        if (reader->depth == HID_DEPTH_MAX) {
            return HID_ERR_DEPTH;
        }
        hid_usage application = reader->application[reader->depth];
        if (item->data == COLLECTION_APPLICATION) {
            application = reader->out->range_count > reader->range_first
                              ? reader->out->range[reader->range_first].first
                              : 0;
        }
        reader->application[++reader->depth] = application;
        return HID_OK;
    }
    case MAIN_END_COLLECTION:
        if (reader->depth == 0) {
            return HID_ERR_NO_COLLECTION;
        }
        reader->depth--;
        return HID_OK;
    default: /* Output, Feature and reserved items are skipped. */
        return HID_OK;
    }
}

/* ---- Parsing of items ----------------------------------------------------------------------- */

static enum hid_error read_item(struct reader *reader, const struct hid_item *item)
{
    CORE_ASSERT(item->size <= sizeof item->data);
    struct hid_descriptor *out = reader->out;
    enum hid_error error = HID_OK;
    switch (item->type) {
    case HID_ITEM_MAIN:
        error = read_main(reader, item);
        if (error == HID_OK) {
            /* A main item ends the Local state. Usages that no group uses are removed. */
            const struct hid_group *last =
                out->group_count ? &out->group[out->group_count - 1u] : NULL;
            out->range_count = last ? (uint32_t)last->range_first + last->range_count : 0;
            reader->range_first = out->range_count;
            reader->has_usage_min = false;
        }
        return error;
    case HID_ITEM_GLOBAL:
        error = hid_globals_take(&reader->globals, item);
        out->has_report_ids |= reader->globals.now.report_id > 0;
        return error;
    case HID_ITEM_LOCAL:
        return read_local(reader, item);
    default: /* Long and reserved items are skipped. */
        return HID_OK;
    }
}

enum hid_error hid_descriptor_read(struct hid_descriptor *out, const uint8_t *bytes, size_t size)
{
    CORE_ASSERT(bytes || size == 0);
    struct reader reader = { .out = out };
    /* The arrays after the member `group`, including `group`, occupy 61 KB. These arrays need no
     * clearing, because entries beyond the counts are not read. */
    memset(out, 0, offsetof(struct hid_descriptor, group));
    if (size > HID_DESCRIPTOR_SIZE_MAX) {
        out->error = HID_ERR_TOO_LONG;
        out->error_offset = HID_DESCRIPTOR_SIZE_MAX;
        return out->error;
    }
    size_t offset = 0;
    while (offset < size) {
        struct hid_item item;
        const size_t taken = hid_item_read(&item, bytes, size, offset);
        out->error = taken ? read_item(&reader, &item) : HID_ERR_CUT_OFF;
        if (out->error) {
            break;
        }
        offset += taken;
    }
    if (out->error == HID_OK && reader.depth > 0) {
        out->error = HID_ERR_OPEN_COLLECTION;
    }
    out->error_offset = out->error ? offset : 0;
    CORE_ASSERT(out->group_count <= HID_GROUP_MAX);
    CORE_ASSERT(out->range_count <= HID_RANGE_MAX);
    CORE_ASSERT(out->field_count <= HID_FIELD_MAX);
    return out->error;
}

const char *hid_error_text(enum hid_error error)
{
#define HID_ERROR_TEXT(name, text) text,
    static const char *const texts[] = { HID_ERRORS(HID_ERROR_TEXT) };
    return (unsigned)error < HID_ERR_COUNT ? texts[error] : "unknown error";
}

/* ---- Usages and values of reports ------------------------------------------------------------ */

uint32_t hid_usage_count(const struct hid_descriptor *descriptor, const struct hid_group *group)
{
    if (group->range_count == 0) {
        return 0;
    }
    CORE_ASSERT((uint32_t)group->range_first + group->range_count <= HID_RANGE_MAX);
    const struct hid_range *last = &descriptor->range[group->range_first + group->range_count - 1u];
    return last->place + (last->last - last->first) + 1u;
}

hid_usage hid_usage_at(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       uint32_t index)
{
    CORE_ASSERT((uint32_t)group->range_first + group->range_count <= HID_RANGE_MAX);
    uint32_t low = 0, high = group->range_count; /* The usage is in one of the ranges with the
                                                    indices `low` to `high` - 1. */
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
    CORE_ASSERT(report.bytes || report.size == 0);
    if (!descriptor->has_report_ids) {
        return 0;
    }
    return report.size > 0 ? report.bytes[0] : -1;
}

bool hid_report_is_whole(const struct hid_descriptor *descriptor, struct hid_report report)
{
    const int id = hid_report_id(descriptor, report);
    CORE_ASSERT(id <= 255);
    if (id < 0 || descriptor->report_bits[id] == 0) {
        return false;
    }
    const size_t payload = (descriptor->report_bits[id] + 7u) / 8u;
    return report.size >= payload + descriptor->has_report_ids;
}

int64_t hid_field_value(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        uint32_t index, struct hid_report report)
{
    CORE_ASSERT(index < group->count);
    const uint8_t *payload = report.bytes + descriptor->has_report_ids;
    const uint32_t size = group->bit_size < 32u ? group->bit_size : 32u;
    const uint32_t raw = hid_bits_at(payload, group->bit_offset + index * group->bit_size, size);
    const bool is_signed = group->logical_min < 0 && (group->flags & HID_VARIABLE);
    return is_signed ? hid_signed_bits(raw, size) : (int64_t)raw;
}

hid_usage hid_selected(const struct hid_descriptor *descriptor, const struct hid_group *group,
                       int64_t value)
{
    CORE_ASSERT(group->range_first <= descriptor->range_count);
    const int64_t index = value - group->logical_min;
    const bool in_range = value >= group->logical_min && value <= group->logical_max;
    if (!in_range || index >= (int64_t)hid_usage_count(descriptor, group)) {
        return 0;
    }
    return hid_usage_at(descriptor, group, (uint32_t)index);
}
