/* hid_live.h -- the latest value of every field of a live HID device, and a text view for a
 * terminal.
 *
 * The functions are pure: their input is reports and times, and their output is text. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_LIVE_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_LIVE_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"

/* Most rows of the view. Further fields are only counted. Few terminals have more lines. */
#define HID_LIVE_ROWS 192u
#define HID_LIVE_TEXT 65536u

/* A row of the view: one field, or all the buttons or keys of one Input item. */
struct hid_live_row {
    uint16_t group;
    uint16_t field;
    uint8_t is_set; /* 1 if the row shows a set: all one-bit switches of an item, or the elements of
                       an array. The row lists those that are on. */
    uint8_t is_known;
    int64_t value; /* Latest value of the field. */
    int64_t sum;   /* Sum of all values of the field. Shown for relative fields. */
    uint32_t on_count;
    uint32_t on[8]; /* First usages that are on. `on_count` also counts the usages that do not
                       fit. */
};

/* State of a live view. hid_live_begin() fills it. */
struct hid_live {
    const struct hid_descriptor *descriptor;
    char title[128];
    uint32_t row_count, hidden_count;
    uint32_t report_count, refused_count; /* Numbers of complete reports (`report_count`) and of
                                             reports that were too short or had another id
                                             (`refused_count`). */
    uint32_t second_count, per_second;    /* Numbers of reports in the current second so far
                                             (`second_count`) and in the last complete second
                                             (`per_second`). */
    uint64_t second_ns;                   /* Monotonic time at which the current second began, in
                                             ns. */
    struct hid_live_row row[HID_LIVE_ROWS];
};

/* Starts a view with a row for each field that is not constant and has at most 32 bits.
 * `descriptor` must outlive `live`. */
void hid_live_begin(struct hid_live *live, const struct hid_descriptor *descriptor,
                    const char *title);

/* Updates the rows with a report that arrived at `time_ns`. A report that is incomplete is only
 * counted. */
void hid_live_report(struct hid_live *live, struct hid_report report, uint64_t time_ns);

/* Advances the clock of `live` to `time_ns` when no report arrives, so that the report rate drops
 * to 0. */
void hid_live_time(struct hid_live *live, uint64_t time_ns);

/* Writes the view as at most `height` lines of at most `width` columns. Each line ends in "\n".
 * Returns the length of the text. `text` is zero-terminated. */
size_t hid_live_picture(const struct hid_live *live, uint32_t width, uint32_t height,
                        char text[HID_LIVE_TEXT]);

#endif
