/* hid_live.h -- the newest value of every field of a live device, and a picture of them for a
 * terminal. Pure: reports and times in, text out. */
#ifndef KINGYO_PLATFORM_CTL_HID_LIVE_H
#define KINGYO_PLATFORM_CTL_HID_LIVE_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid_descriptor.h"

#define HID_LIVE_ROWS 192u /* Rows of a terminal that anybody has; the others are counted. */
#define HID_LIVE_TEXT 65536u

/* One row of the picture: a field, or all the buttons or keys of one Input item. */
struct hid_live_row {
    uint16_t group;
    uint16_t field;
    uint8_t is_set; /* Switches of one bit, or the elements of an array: those that are on. */
    uint8_t is_known;
    int64_t value;  /* The newest ... */
    int64_t sum;    /* ... and of a relative field all together. */
    uint32_t on_count;
    uint32_t on[8]; /* Fields or usages that are on; of more only the count is kept. */
};

struct hid_live {
    const struct hid_descriptor *descriptor;
    char title[128];
    uint32_t row_count, hidden_count;
    uint32_t report_count, refused_count;    /* Whole ones; those too short or of another id. */
    uint32_t second_count, per_second;       /* Of this second so far; in the last whole one. */
    uint64_t second_ns;                      /* When this one began, monotonic. */
    struct hid_live_row row[HID_LIVE_ROWS];
};

/* Rows for all that is no constant and at most 32 bits wide. `descriptor` must outlive it. */
void hid_live_begin(struct hid_live *live, const struct hid_descriptor *descriptor,
                    const char *title);

void hid_live_report(struct hid_live *live, struct hid_report report, uint64_t time_ns);

/* Lets the second pass when nothing comes. */
void hid_live_time(struct hid_live *live, uint64_t time_ns);

/* The picture: at most `height` lines of at most `width` columns, each ended by "\n". Returns its
 * length; `text` ends in a zero. */
size_t hid_live_picture(const struct hid_live *live, uint32_t width, uint32_t height,
                        char text[HID_LIVE_TEXT]);

#endif
