/* hid_live.c -- the live view of a HID device. The rows of the view are created once from the
 * descriptor. A report changes only the values of the rows. */
#include "platform/ctl/devices/hid_live.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/ctl/devices/hid_rows.h"

#define SECOND_NS 1000000000u
#define ON_MAX (sizeof((struct hid_live_row *)0)->on / sizeof(uint32_t))
#define TITLE_COLUMNS 22
#define VALUE_COLUMNS 11
#define BAR_MIN 8u

/* ---- Rows of the view ------------------------------------------------------------------------ */

void hid_live_begin(struct hid_live *live, const struct hid_descriptor *descriptor,
                    const char *title)
{
    CORE_ASSERT(descriptor && title);
    *live = (struct hid_live){ .descriptor = descriptor };
    snprintf(live->title, sizeof live->title, "%s", title);
    printable(live->title);
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        const bool is_set = !(group->flags & HID_VARIABLE) || group->bit_size == 1u;
        if (group->flags & HID_CONSTANT || group->bit_size > 32u) {
            continue;
        }
        for (uint32_t field = 0; field < (is_set ? 1u : group->count); field++) {
            if (live->row_count == HID_LIVE_ROWS || field > UINT16_MAX) {
                live->hidden_count++;
                continue;
            }
            live->row[live->row_count++] = (struct hid_live_row){ .group = (uint16_t)i,
                                                                  .field = (uint16_t)field,
                                                                  .is_set = is_set };
        }
    }
}

/* ---- Updates from reports -------------------------------------------------------------------- */

static void take_set(const struct hid_live *live, struct hid_live_row *row,
                     const struct hid_group *group, struct hid_report report)
{
    const struct hid_descriptor *descriptor = live->descriptor;
    row->on_count = 0;
    for (uint32_t i = 0; i < group->count; i++) {
        const int64_t value = hid_field_value(descriptor, group, i, report);
        const hid_usage usage = group->flags & HID_VARIABLE
                                    ? (value ? hid_usage_at(descriptor, group, i) : 0)
                                    : hid_selected(descriptor, group, value);
        if (usage & 0xffffu) { /* Usage 0 of a page means that no control is active, for example no
                                  key of a keyboard. */
            if (row->on_count < ON_MAX) {
                row->on[row->on_count] = usage;
            }
            row->on_count++;
        }
    }
}

void hid_live_time(struct hid_live *live, uint64_t time_ns)
{
    if (time_ns - live->second_ns < SECOND_NS) {
        return;
    }
    const bool was_last = time_ns - live->second_ns < 2ull * SECOND_NS;
    live->per_second = was_last ? live->second_count : 0;
    live->second_count = 0;
    live->second_ns = was_last ? live->second_ns + SECOND_NS : time_ns;
}

void hid_live_report(struct hid_live *live, struct hid_report report, uint64_t time_ns)
{
    hid_live_time(live, time_ns);
    if (!hid_report_is_whole(live->descriptor, report)) {
        live->refused_count++;
        return;
    }
    CORE_ASSERT(live->row_count <= HID_LIVE_ROWS);
    live->report_count++;
    live->second_count++;
    for (uint32_t i = 0; i < live->row_count; i++) {
        struct hid_live_row *row = &live->row[i];
        const struct hid_group *group = &live->descriptor->group[row->group];
        if (group->report_id != hid_report_id(live->descriptor, report)) {
            continue;
        }
        row->is_known = true;
        if (row->is_set) {
            take_set(live, row, group, report);
        } else {
            row->value = hid_field_value(live->descriptor, group, row->field, report);
            row->sum += row->value;
        }
    }
}

/* ---- Text output ----------------------------------------------------------------------------- */

struct page {
    char *text;
    size_t length;
    uint32_t width, line_begin;
};

/* Appends text to the current line and truncates the line at the page width. All text is ASCII
 * except the name of the device. */
__attribute__((format(printf, 2, 3))) static void hid_live_put(struct page *page,
                                                               const char *format, ...)
{
    CORE_ASSERT(page->length < HID_LIVE_TEXT && page->line_begin <= page->length);
    const size_t used = page->length - page->line_begin;
    size_t room = page->width > used ? page->width - used : 0;
    room = page->length + room + 2u < HID_LIVE_TEXT ? room : 0;
    va_list arguments;
    va_start(arguments, format);
    const int wanted = vsnprintf(page->text + page->length, room + 1u, format, arguments);
    va_end(arguments);
    page->length += wanted < 0 ? 0 : (size_t)wanted < room ? (size_t)wanted : room;
}

static void end_line(struct page *page)
{
    if (page->length + 2u < HID_LIVE_TEXT) {
        page->text[page->length++] = '\n';
        page->text[page->length] = '\0';
    }
    page->line_begin = (uint32_t)page->length;
}

/* Draws a bar that shows the position of `value` between the logical minimum and maximum. A
 * value beyond a limit is drawn at the end of the bar, with an angle bracket instead of a square
 * bracket. */
static void put_bar(struct page *page, const struct hid_group *group, int64_t value)
{
    const uint32_t used = (uint32_t)page->length - page->line_begin;
    if (group->logical_max <= group->logical_min || page->width < used + BAR_MIN + 2u) {
        return;
    }
    const uint32_t columns = page->width - used - 2u;
    const int64_t span = group->logical_max - group->logical_min;
    const bool is_low = value < group->logical_min;
    const bool is_high = value > group->logical_max;
    const int64_t into = is_low ? 0 : is_high ? span : value - group->logical_min;
    const uint32_t at = (uint32_t)((double)into / (double)span * (columns - 1u) + 0.5);
    hid_live_put(page, "%c", is_low ? '<' : '[');
    for (uint32_t i = 0; i < columns; i++) {
        hid_live_put(page, "%c", i == at ? '#' : '.');
    }
    hid_live_put(page, "%c", is_high ? '>' : ']');
}

static void put_set(struct page *page, const struct hid_live *live, const struct hid_live_row *row)
{
    const struct hid_group *group = &live->descriptor->group[row->group];
    const uint32_t end = group->flags & HID_VARIABLE ? group->count : UINT32_MAX;
    const hid_usage first = hid_usage_at(live->descriptor, group, 0);
    const hid_usage last = hid_usage_at(live->descriptor, group, end - 1u);
    char name[HID_NAME_SIZE];
    hid_live_put(page, "%s", hid_usage_name(first, name));
    if (last != first) {
        hid_live_put(page, " .. %s", hid_usage_name(last, name));
    }
    hid_live_put(page, ": ");
    for (uint32_t i = 0; i < row->on_count && i < ON_MAX; i++) {
        hid_live_put(page, "%s%s", i > 0 ? ", " : "", hid_usage_name(row->on[i], name));
    }
    if (row->on_count > ON_MAX) {
        hid_live_put(page, " and %u more", row->on_count - (uint32_t)ON_MAX);
    }
}

static void put_field(struct page *page, const struct hid_live *live,
                      const struct hid_live_row *row)
{
    const struct hid_group *group = &live->descriptor->group[row->group];
    char name[HID_NAME_SIZE];
    const hid_usage usage = hid_usage_at(live->descriptor, group, row->field);
    hid_live_put(page, "%-*s", TITLE_COLUMNS, hid_usage_name(usage, name));
    if (!row->is_known) {
        hid_live_put(page, "%*s", VALUE_COLUMNS, "-");
        return;
    }
    hid_live_put(page, "%*" PRId64 "  ", VALUE_COLUMNS, row->value);
    const bool is_out = row->value < group->logical_min || row->value > group->logical_max;
    if (group->flags & HID_RELATIVE) {
        hid_live_put(page, "%*" PRId64 " in all", VALUE_COLUMNS, row->sum);
    } else if (is_out && group->flags & HID_NULL_STATE) {
        hid_live_put(page, "nothing");
    } else {
        put_bar(page, group, row->value);
    }
}

size_t hid_live_picture(const struct hid_live *live, uint32_t width, uint32_t height,
                        char text[HID_LIVE_TEXT])
{
    struct page page = { .text = text, .width = width };
    const uint32_t room = height > 2u ? height - 2u : 0;
    const uint32_t shown = live->row_count < room ? live->row_count : room;
    const uint32_t hidden = live->hidden_count + live->row_count - shown;
    text[0] = '\0';
    hid_live_put(&page, "%s", live->title);
    end_line(&page);
    hid_live_put(&page, "%u report%s, %u in the last second", live->report_count,
                 live->report_count == 1 ? "" : "s", live->per_second);
    if (live->refused_count > 0) {
        hid_live_put(&page, ", %u too short or unknown", live->refused_count);
    }
    if (hidden > 0) {
        hid_live_put(&page, "; %u more rows are below this window", hidden);
    }
    end_line(&page);
    for (uint32_t i = 0; i < shown; i++) {
        const struct hid_live_row *row = &live->row[i];
        if (live->descriptor->has_report_ids) {
            hid_live_put(&page, "%3u ", live->descriptor->group[row->group].report_id);
        }
        (row->is_set ? put_set : put_field)(&page, live, row);
        end_line(&page);
    }
    return page.length;
}
