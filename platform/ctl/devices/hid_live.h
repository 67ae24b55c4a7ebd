/* hid_live.h -- stores the latest value of every field of a live HID device, and draws a text view
 * of the values for a terminal.
 *
 * The functions are pure. Their inputs are reports and times, and their output is text. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"

/* Maximum number of rows of the view. Fields beyond the limit are counted in `hidden_count`. Few
 * terminals have more lines. */
#define HID_LIVE_ROWS 192u
#define HID_LIVE_TEXT 65536u

/* A row of the view. The row shows one field, or all buttons or keys of one Input item. */
struct hid_live_row {
    uint16_t group;
    uint16_t field;
    /* True if the row lists the active usages of a set: the one-bit switches of an Input item, or
     * the elements of an array. False if the row shows one value. */
    bool is_set;
    bool is_known; /* True after a report that contains the fields of the row was received. */
    int64_t value; /* Latest value of the field. */
    /* Sum of all values that the field has reported. The view shows the sum for relative fields. */
    int64_t sum;
    uint32_t on_count;
    /* Usages that are active, at most eight. `on_count` also counts the active usages that do not
     * fit. */
    uint32_t on[8];
};

/* State of a live view. hid_live_begin() initializes the state. */
struct hid_live {
    const struct hid_descriptor *descriptor;
    char title[128];
    uint32_t row_count, hidden_count;
    /* `report_count` is the number of complete reports. `refused_count` is the number of reports
     * that were too short or had another report id. */
    uint32_t report_count, refused_count;
    /* `second_count` is the number of reports so far in the current second. `per_second` is the
     * number of reports in the last complete second. */
    uint32_t second_count, per_second;
    /* Monotonic time at which the current second began, in ns. */
    uint64_t second_ns;
    struct hid_live_row row[HID_LIVE_ROWS];
};

/* Initializes a view with one row for each field that is not constant and has at most 32 bits.
 * `descriptor` must outlive `live`. */
void hid_live_begin(struct hid_live *live, const struct hid_descriptor *descriptor,
                    const char *title);

/* Updates the rows with a report that arrived at `time_ns`. An incomplete report only increments
 * `refused_count`. */
void hid_live_report(struct hid_live *live, struct hid_report report, uint64_t time_ns);

/* Advances the clock of `live` to `time_ns`. The caller calls this function while no report
 * arrives, so that the displayed report rate drops to 0. */
void hid_live_time(struct hid_live *live, uint64_t time_ns);

/* Writes the view to `text` as at most `height` lines of at most `width` columns. Each line ends in
 * "\n", and `text` is zero-terminated. Returns the length of the text in bytes. */
size_t hid_live_picture(const struct hid_live *live, uint32_t width, uint32_t height,
                        char text[HID_LIVE_TEXT]);
