/* live.c -- fuzz target: the live display of a controller's fields, for an arbitrary controller and
 * an arbitrary window size. The display must fit in the window.
 *
 * Input: the same format as that of report.c. The size of a report also selects the size of the
 * window. */
#include <string.h>

#include "platform/ctl/devices/hid_live.h"
#include "tests/fuzz/trap.h"

static struct hid_descriptor descriptor;
static struct hid_live live;

static void hold_picture(uint32_t width, uint32_t height)
{
    static char text[HID_LIVE_TEXT];
    const size_t length = hid_live_picture(&live, width, height, text);
    uint32_t lines = 0;
    HOLD(length == strnlen(text, sizeof text) && length < sizeof text);
    for (const char *line = text; *line; line = strchr(line, '\n') + 1) {
        HOLD(strchr(line, '\n') && (size_t)(strchr(line, '\n') - line) <= width);
        lines++;
    }
    HOLD(lines <= (height > 2u ? height : 2u));
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    uint64_t time_ns = 1000000000u;
    if (size < 2u) {
        return 0;
    }
    size_t at = 2u + (size_t)(bytes[0] | bytes[1] << 8);
    at = at < size ? at : size;
    if (hid_descriptor_read(&descriptor, bytes + 2, at - 2u)) {
        return 0;
    }
    hid_live_begin(&live, &descriptor, "a device");
    HOLD(live.row_count <= HID_LIVE_ROWS);
    while (at < size) {
        const size_t left = size - at - 1u, requested = bytes[at];
        const size_t taken = requested < left ? requested : left;
        time_ns += requested * 20000000u;
        hid_live_report(&live, (struct hid_report){ bytes + at + 1u, taken }, time_ns);
        at += 1u + taken;
        hold_picture((uint32_t)requested, (uint32_t)requested / 2u);
    }
    HOLD(live.per_second <= live.report_count);
    return 0;
}
