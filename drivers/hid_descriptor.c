/* hid_descriptor.c -- one pass over the items: globals and locals pile up, Input items cash them
 * in. */
#include "drivers/hid_descriptor.h"

#include <string.h>

enum item_type { TYPE_MAIN = 0, TYPE_GLOBAL = 1, TYPE_LOCAL = 2 };

enum main_tag { MAIN_INPUT = 8, MAIN_COLLECTION = 10, MAIN_END_COLLECTION = 12 };

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

enum local_tag { LOCAL_USAGE = 0, LOCAL_USAGE_MIN = 1, LOCAL_USAGE_MAX = 2, LOCAL_DELIMITER = 10 };

#define LONG_ITEM 0xfeu
#define COLLECTION_APPLICATION 1u

struct item {
    size_t offset;
    uint8_t type, tag;
    uint8_t size; /* Of its data: 0, 1, 2 or 4. */
    uint32_t data;
};

/* Limits keep their raw data: a maximum is signed only if its minimum is negative, which is not
 * known before the Input item. */
struct limit {
    uint32_t data;
    uint8_t size;
};

struct globals {
    uint16_t usage_page;
    struct limit logical_min, logical_max, physical_min, physical_max;
    int32_t unit_exponent;
    uint32_t unit, report_size, report_count;
    uint8_t report_id;
};

struct reader {
    struct hid_descriptor *out;
    struct globals now, pushed[HID_PUSH_MAX];
    uint32_t pushed_count;
    hid_usage application[HID_DEPTH_MAX + 1u]; /* In force at each depth of collections. */
    uint32_t depth;
    uint32_t range_first; /* This main item's usages so far are out->range[range_first ..]. */
    hid_usage usage_min;
    uint8_t has_usage_min;
    uint8_t in_delimiter, alternatives; /* Only the first of a delimited set is heard. */
};

static int32_t signed_data(uint32_t data, uint8_t size)
{
    return size == 1 ? (int8_t)data : size == 2 ? (int16_t)data : (int32_t)data;
}

static int64_t limit_min(struct limit limit)
{
    return signed_data(limit.data, limit.size);
}

static int64_t limit_max(struct limit limit, int64_t min)
{
    return min < 0 ? (int64_t)signed_data(limit.data, limit.size) : (int64_t)limit.data;
}

/* ---- Usages --------------------------------------------------------------------------------- */

/* A usage of one or two bytes belongs to the page in force where it is named. */
static hid_usage whole_usage(const struct reader *reader, const struct item *item)
{
    return item->size == 4 ? item->data : (uint32_t)reader->now.usage_page << 16 | item->data;
}

static enum hid_error add_range(struct reader *reader, hid_usage first, hid_usage last)
{
    struct hid_descriptor *out = reader->out;
    if (first > last || first >> 16 != last >> 16) {
        return HID_ERR_USAGE_RANGE;
    }
    if (out->range_count == HID_RANGE_MAX) {
        return HID_ERR_RANGES;
    }
    out->range[out->range_count++] = (struct hid_range){ first, last };
    return HID_OK;
}

static enum hid_error delimit(struct reader *reader, uint32_t opens)
{
    if ((opens != 0) == (reader->in_delimiter != 0)) {
        return HID_ERR_DELIMITER;
    }
    reader->in_delimiter = opens != 0;
    reader->alternatives = 0;
    return HID_OK;
}

static enum hid_error end_usage_range(struct reader *reader, const struct item *item)
{
    const hid_usage last = whole_usage(reader, item);
    /* A maximum of four bytes names the page of both; a lone maximum counts from 0. */
    const hid_usage first = reader->has_usage_min ? reader->usage_min : last & 0xffff0000u;
    reader->has_usage_min = 0;
    return add_range(reader, first, last);
}

static enum hid_error read_local(struct reader *reader, const struct item *item)
{
    if (item->tag == LOCAL_DELIMITER) {
        return delimit(reader, item->data);
    }
    const int names_usage = item->tag == LOCAL_USAGE || item->tag == LOCAL_USAGE_MAX;
    if (reader->in_delimiter && names_usage && reader->alternatives++ > 0) {
        return HID_OK;
    }
    switch (item->tag) {
    case LOCAL_USAGE:
        return add_range(reader, whole_usage(reader, item), whole_usage(reader, item));
    case LOCAL_USAGE_MIN:
        reader->usage_min = whole_usage(reader, item);
        reader->has_usage_min = 1;
        return HID_OK;
    case LOCAL_USAGE_MAX:
        return end_usage_range(reader, item);
    default: /* Designators and strings describe, they do not mean. */
        return HID_OK;
    }
}

/* ---- Globals -------------------------------------------------------------------------------- */

static enum hid_error push(struct reader *reader)
{
    if (reader->pushed_count == HID_PUSH_MAX) {
        return HID_ERR_PUSH;
    }
    reader->pushed[reader->pushed_count++] = reader->now;
    return HID_OK;
}

static enum hid_error pop(struct reader *reader)
{
    if (reader->pushed_count == 0) {
        return HID_ERR_POP;
    }
    reader->now = reader->pushed[--reader->pushed_count];
    return HID_OK;
}

static enum hid_error take_report_id(struct reader *reader, uint32_t id)
{
    if (id == 0 || id > 255u) {
        return HID_ERR_REPORT_ID;
    }
    reader->now.report_id = (uint8_t)id;
    reader->out->has_report_ids = 1;
    return HID_OK;
}

/* The specification's nibble, 8 .. 15 for -8 .. -1; real devices also write whole bytes. */
static int32_t unit_exponent(const struct item *item)
{
    const uint32_t nibble = item->data;
    return nibble <= 15u ? (int32_t)nibble - (nibble > 7u ? 16 : 0)
                         : signed_data(item->data, item->size);
}

static enum hid_error read_global(struct reader *reader, const struct item *item)
{
    struct globals *now = &reader->now;
    const struct limit limit = { item->data, item->size };
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
        return take_report_id(reader, item->data);
    case GLOBAL_REPORT_COUNT:
        now->report_count = item->data;
        break;
    case GLOBAL_PUSH:
        return push(reader);
    case GLOBAL_POP:
        return pop(reader);
    default: /* Reserved: skipped, as section 6.2.2.7 leaves room for more. */
        break;
    }
    return HID_OK;
}

/* ---- Main items ----------------------------------------------------------------------------- */

static enum hid_error open_collection(struct reader *reader, uint32_t kind)
{
    const struct hid_descriptor *out = reader->out;
    if (reader->depth == HID_DEPTH_MAX) {
        return HID_ERR_DEPTH;
    }
    const hid_usage named =
        out->range_count > reader->range_first ? out->range[reader->range_first].first : 0;
    const hid_usage around = reader->application[reader->depth];
    reader->depth++;
    reader->application[reader->depth] = kind == COLLECTION_APPLICATION ? named : around;
    return HID_OK;
}

static enum hid_error close_collection(struct reader *reader)
{
    if (reader->depth == 0) {
        return HID_ERR_NO_COLLECTION;
    }
    reader->depth--;
    return HID_OK;
}

static struct hid_group group_of(const struct reader *reader, uint32_t flags)
{
    const struct globals *now = &reader->now;
    struct hid_group group = {
        .application = reader->application[reader->depth],
        .report_id = now->report_id,
        .bit_offset = reader->out->report_bits[now->report_id],
        .bit_size = now->report_size,
        .count = now->report_count,
        .flags = flags,
        .logical_min = limit_min(now->logical_min),
        .physical_min = limit_min(now->physical_min),
        .unit_exponent = now->unit_exponent,
        .unit = now->unit,
        .range_first = (uint16_t)reader->range_first,
        .range_count = (uint16_t)(reader->out->range_count - reader->range_first),
    };
    group.logical_max = limit_max(now->logical_max, group.logical_min);
    group.physical_max = limit_max(now->physical_max, group.physical_min);
    return group;
}

static enum hid_error add_input(struct reader *reader, uint32_t flags)
{
    struct hid_descriptor *out = reader->out;
    const struct globals *now = &reader->now;
    const uint32_t used = out->report_bits[now->report_id];
    const uint64_t bits = (uint64_t)now->report_size * now->report_count;
    if (bits > HID_REPORT_BITS_MAX - used) {
        return HID_ERR_REPORT_SIZE;
    }
    const struct hid_group group = group_of(reader, flags);
    out->report_bits[now->report_id] = used + (uint32_t)bits;
    if (bits == 0 || group.range_count == 0) {
        return HID_OK; /* Nothing, or padding. */
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

static enum hid_error do_main(struct reader *reader, const struct item *item)
{
    switch (item->tag) {
    case MAIN_INPUT:
        return reader->has_usage_min ? HID_ERR_USAGE_RANGE : add_input(reader, item->data);
    case MAIN_COLLECTION:
        return open_collection(reader, item->data);
    case MAIN_END_COLLECTION:
        return close_collection(reader);
    default: /* Output, Feature and what is reserved. */
        return HID_OK;
    }
}

/* Locals end with their main item, whichever it is. Usages that no group keeps are given back. */
static void forget_locals(struct reader *reader)
{
    struct hid_descriptor *out = reader->out;
    const struct hid_group *last = out->group_count ? &out->group[out->group_count - 1u] : NULL;
    out->range_count = last ? (uint32_t)last->range_first + last->range_count : 0;
    reader->range_first = out->range_count;
    reader->has_usage_min = 0;
    reader->in_delimiter = 0;
}

static enum hid_error read_main(struct reader *reader, const struct item *item)
{
    const enum hid_error error = do_main(reader, item);
    if (error == HID_OK) {
        forget_locals(reader);
    }
    return error;
}

/* ---- Items ---------------------------------------------------------------------------------- */

/* Returns the bytes that the item takes, or 0 if it is cut off. A long item reads as reserved. */
static size_t next_item(struct item *item, const uint8_t *bytes, size_t size, size_t offset)
{
    const size_t left = size - offset;
    const uint8_t prefix = bytes[offset];
    *item = (struct item){ .offset = offset, .type = 3 };
    if (prefix == LONG_ITEM) {
        const size_t whole = left > 1 ? 3u + bytes[offset + 1u] : SIZE_MAX;
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

static enum hid_error read_item(struct reader *reader, const struct item *item)
{
    switch (item->type) {
    case TYPE_MAIN:
        return read_main(reader, item);
    case TYPE_GLOBAL:
        return read_global(reader, item);
    case TYPE_LOCAL:
        return read_local(reader, item);
    default: /* Long and reserved items are skipped. */
        return HID_OK;
    }
}

static enum hid_error fail(struct hid_descriptor *out, enum hid_error error, size_t offset)
{
    out->error = error;
    out->error_offset = offset;
    return error;
}

enum hid_error hid_descriptor_read(struct hid_descriptor *out, const uint8_t *bytes, size_t size)
{
    struct reader reader = { .out = out };
    memset(out, 0, sizeof *out);
    if (size > HID_DESCRIPTOR_SIZE_MAX) {
        return fail(out, HID_ERR_TOO_LONG, HID_DESCRIPTOR_SIZE_MAX);
    }
    for (size_t offset = 0; offset < size;) {
        struct item item;
        const size_t taken = next_item(&item, bytes, size, offset);
        const enum hid_error error = taken ? read_item(&reader, &item) : HID_ERR_CUT_OFF;
        if (error) {
            return fail(out, error, offset);
        }
        offset += taken;
    }
    return reader.depth > 0 ? fail(out, HID_ERR_OPEN_COLLECTION, size) : HID_OK;
}

const char *hid_error_text(enum hid_error error)
{
    static const char *const texts[HID_ERR_COUNT] = {
        [HID_OK] = "fine",
        [HID_ERR_TOO_LONG] = "longer than 65535 bytes",
        [HID_ERR_CUT_OFF] = "ends within an item",
        [HID_ERR_OPEN_COLLECTION] = "ends within a collection",
        [HID_ERR_NO_COLLECTION] = "End Collection without a collection",
        [HID_ERR_DEPTH] = "more than 32 collections within each other",
        [HID_ERR_PUSH] = "more than 8 pushes without a pop",
        [HID_ERR_POP] = "a pop without a push",
        [HID_ERR_REPORT_ID] = "a report id that is not 1 .. 255",
        [HID_ERR_FIELD_SIZE] = "a field of more than 256 bits",
        [HID_ERR_REPORT_SIZE] = "a report of more than 65536 bits",
        [HID_ERR_GROUPS] = "more than 512 Input items",
        [HID_ERR_RANGES] = "more than 2048 usages",
        [HID_ERR_FIELDS] = "more than 16384 fields",
        [HID_ERR_USAGE_RANGE] =
            "a usage range that ends before it begins, on another page or never",
        [HID_ERR_DELIMITER] = "delimiters that are nested or were never opened",
    };
    return (unsigned)error < HID_ERR_COUNT ? texts[error] : "unknown error";
}

/* ---- What was read -------------------------------------------------------------------------- */

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
