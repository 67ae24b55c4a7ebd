/* report_feed.h -- plays the reports of a simulated mouse, touch screen or game pad with faults.
 *
 * A device plays an array of reports (for the touch screen: finger events) that is sorted by time.
 * The faults change the input of the real decoder. The caller owns the state and the reports, which
 * must outlive the device. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "platform/hal.h"

/* Index of a report that does not exist. A fault at this index never occurs. */
#define REPORT_FEED_NEVER UINT32_MAX

/* Position of a device in its reports, and the faults of the device. The caller sets `count` and
 * the faults after the initialization of the device. */
struct report_feed {
    struct hal_clock clock;
    uint32_t count; /* Number of reports. */
    uint32_t next;  /* Index of the next report to play. */
    /* Index of the report before which the device is unplugged. REPORT_FEED_NEVER means never. */
    uint32_t unplug_at;
    uint64_t replug_ns; /* Time from which open() finds the device again. */
    /* Every n-th report arrives twice, where n is this value. 0 means that no report is doubled. */
    uint32_t double_every;
    /* Index of the report that jumps to the top right corner (mouse, touch screen), or in which the
     * sticks jump to a corner (game pad). REPORT_FEED_NEVER means that there is no such report. */
    uint32_t jump_at;
    /* Index of the first report with random bits (including NaN), and index after the last report
     * with random bits. */
    uint32_t random_from, random_to;
    /* Start and end of the time without reports. The reports of this time arrive together at its
     * end. */
    uint64_t silent_from_ns, silent_to_ns;
    bool gone;           /* True while the device is unplugged. */
    uint32_t open_count; /* Number of open() calls. */
};

/* Faults of one report. */
struct report_fault {
    uint32_t index;  /* Index of the report. */
    uint32_t copies; /* Number of times that the report arrives, 1 or 2. */
    bool jumps, is_random;
};

/* Returns a feed without reports and faults. */
struct report_feed report_feed_begin(struct hal_clock clock);

/* Opens the device. Returns 1 if the device was plugged in again, 0 if it was present already, or
 * HAL_ERR_GONE while it is unplugged. */
int report_feed_open(struct report_feed *feed);

/* Takes the next report that is due. `reports` is the array of reports, which are `size` bytes each
 * and start with their time in nanoseconds (uint64_t). Returns 1 and fills `out`, or returns 0 if
 * no report is due. Returns HAL_ERR_BUSY during the time without reports, or HAL_ERR_GONE if the
 * device is unplugged. */
int report_feed_take(struct report_feed *feed, const void *reports, size_t size,
                     struct report_fault *out);

/* Returns 32 random bits that depend only on the arguments. `stream` identifies the kind of
 * device. */
uint32_t report_feed_random(uint32_t stream, uint32_t index, uint32_t what);
/* Returns a float with random bits, which may be infinite or NaN. */
float report_feed_random_float(uint32_t stream, uint32_t index, uint32_t what);

/* Opens the fan of a mouse or of a game pad (hal_fan_ops.open). `self` starts with the struct
 * report_feed of the device. */
int report_feed_fan_open(void *self);
