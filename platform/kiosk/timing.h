/* timing.h -- a histogram of durations in fixed memory, which gives the median and the 99th
 * percentile of a whole day. Pure functions. */
#ifndef KINGYO_PLATFORM_KIOSK_TIMING_H
#define KINGYO_PLATFORM_KIOSK_TIMING_H

#include <stdint.h>

/* Width of a fine bin (0.05 ms), less than the variation of frame times. */
#define TIMING_BIN_NS 50000u
/* Number of fine bins, which reach up to 0.4 s. Coarse bins follow. */
#define TIMING_BIN_COUNT 8000u
/* Width of a coarse bin (20 ms). */
#define TIMING_SLOW_NS 20000000u
/* Number of coarse bins, which reach up to 10 s. Longer durations count in the last bin. */
#define TIMING_SLOW_COUNT 500u

struct timing {
    uint64_t count, sum_ns, max_ns;
    uint32_t bins[TIMING_BIN_COUNT + TIMING_SLOW_COUNT];
};

/* Adds one duration. */
void timing_add(struct timing *timing, uint64_t duration_ns);

/* Returns the duration that a share of all durations does not exceed. `share` is in [0, 1]; 0.5
 * gives the median. The error is at most half a bin. Returns max_ns if the result is in the last
 * bin, and 0 if there are no durations. */
uint64_t timing_quantile_ns(const struct timing *timing, double share);

#endif
