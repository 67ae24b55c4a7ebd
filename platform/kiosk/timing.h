/* timing.h -- a histogram of durations, to fit a day's median and p99 into fixed memory. Pure. */
#ifndef KINGYO_PLATFORM_KIOSK_TIMING_H
#define KINGYO_PLATFORM_KIOSK_TIMING_H

#include <stdint.h>

#define TIMING_BIN_NS 50000u  /* 0.05 ms: finer than any frame time is stable. */
#define TIMING_BIN_COUNT 8000u /* Up to 0.4 s; behind that coarser ones, ... */
#define TIMING_SLOW_NS 20000000u
#define TIMING_SLOW_COUNT 500u /* ... up to 10 s; longer ones count in the last. */

struct timing {
    uint64_t count, sum_ns, max_ns;
    uint32_t bins[TIMING_BIN_COUNT + TIMING_SLOW_COUNT];
};

void timing_add(struct timing *timing, uint64_t duration_ns);

/* The duration that `share` in [0, 1] of all do not exceed, to half a bin; max_ns where
 * it lies in the last bin; 0 when there are none. */
uint64_t timing_quantile_ns(const struct timing *timing, double share);

#endif
