/* run.h -- the main loop of the poi's board.
 *
 * In each cycle, the loop sends a pose to the host and forwards the host's force feedback to the
 * motor. */
#ifndef KINGYO_BOARD_POI_GADGET_RUN_H
#define KINGYO_BOARD_POI_GADGET_RUN_H

#include "board/poi-gadget/pose_source.h"

enum exit_code {
    EXIT_OK = 0,
    EXIT_NOT_SO = 1,
    EXIT_USAGE = 2,
    EXIT_DATA = 65,
    EXIT_IO = 74,
};

#define RUN_RATE_MIN_HZ 50u
/* Maximum report rate in Hz. A USB high-speed host polls f_hid, Linux's HID gadget, once per
 * millisecond. */
#define RUN_RATE_MAX_HZ 1000u

/* Receiver of the host's force feedback, for example the motor. */
struct feel_sink {
    /* Handles force feedback. `newest` is the newest report, or null if no report has arrived since
     * the last call. `seconds` is the time since the last call. */
    void (*feel)(void *self, const struct poi_force *newest, float seconds);
    void (*stop)(void *self);
    void *self;
};

struct run_options {
    const char *device; /* Path of the device /dev/hidgN, or "-" for standard output. */
    uint32_t rate_hz;   /* Report rate in Hz, RUN_RATE_MIN_HZ .. RUN_RATE_MAX_HZ. */
    float seconds;      /* Duration of the loop in seconds. 0 means no limit. */
};

/* Runs the loop until the source ends, the duration has passed, or a signal arrives. Prints
 * statistics to standard error. Returns EXIT_OK, or EXIT_IO if the device is missing at the
 * start. */
enum exit_code run(const struct run_options *options, struct pose_source source,
                   struct feel_sink sink);

/* Prints the poses of `source` as lines of text (pose_line.h), `rate_hz` lines per second. */
enum exit_code run_watch(const struct run_options *options, struct pose_source source);

#endif
