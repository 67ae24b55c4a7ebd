/* run.h -- the board's loop: a pose to the host at each beat, to the hand what the host says. */
#ifndef KINGYO_POI_GADGET_RUN_H
#define KINGYO_POI_GADGET_RUN_H

#include "board/poi-gadget/pose_source.h"

enum exit_code {
    EXIT_OK = 0,
    EXIT_NOT_SO = 1,
    EXIT_USAGE = 2,
    EXIT_DATA = 65,
    EXIT_IO = 74,
};

#define RUN_RATE_MIN_HZ 50u
#define RUN_RATE_MAX_HZ 1000u /* High-speed f_hid is asked once a millisecond. */

/* What a board does with what the hand is to feel; `seconds` since the last call. */
struct feel_sink {
    void (*feel)(void *self, const struct poi_force *newest, float seconds); /* Null: no news. */
    void (*stop)(void *self);
    void *self;
};

struct run_options {
    const char *device;   /* /dev/hidgN, or "-". */
    uint32_t rate_hz;     /* RUN_RATE_MIN_HZ .. RUN_RATE_MAX_HZ */
    float seconds;        /* 0: for ever. */
};

/* Runs until the source ends, its time is up or a signal comes, and says on standard error what was
 * sent. EXIT_IO: the device is not there at the start. */
enum exit_code run(const struct run_options *options, struct pose_source source,
                   struct feel_sink sink);

/* Prints the poses as lines (pose_line.h), `rate_hz` of them a second. */
enum exit_code watch(const struct run_options *options, struct pose_source source);

#endif
