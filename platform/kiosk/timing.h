/* timing.h -- a histogram of durations in fixed memory, for the median and p99 of a whole day.
 * Pure. */
#ifndef KINGYO_PLATFORM_KIOSK_TIMING_H
#define KINGYO_PLATFORM_KIOSK_TIMING_H

#include <stdint.h>

#define TIMING_BIN_NS 50000u   /* Bin width of 0.05 ms, less than the variation of frame times. */
#define TIMING_BIN_COUNT 8000u /* Fine bins, up to 0.4 s; coarse bins follow. */
#define TIMING_SLOW_NS 20000000u
/* Coarse bins, up to 10 s; longer durations count in the last one. */
#define TIMING_SLOW_COUNT 500u

struct timing {
    uint64_t count, sum_ns, max_ns;
    uint32_t bins[TIMING_BIN_COUNT + TIMING_SLOW_COUNT];
};

/* Adds one duration. */
void timing_add(struct timing *timing, uint64_t duration_ns);

/* Returns the duration that the share `share` in [0, 1] of all durations does not exceed, to half a
 * bin. Returns max_ns if it is in the last bin, and 0 if there are no durations. */
uint64_t timing_quantile_ns(const struct timing *timing, double share);

#endif
