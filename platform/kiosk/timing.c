/* timing.c -- counting into bins. */
#include "platform/kiosk/timing.h"

void timing_add(struct timing *timing, uint64_t duration_ns)
{
    const uint64_t bin = duration_ns / TIMING_BIN_NS;
    timing->bins[bin < TIMING_BIN_COUNT ? bin : TIMING_BIN_COUNT - 1]++;
    timing->count++;
    timing->sum_ns += duration_ns;
    if (duration_ns > timing->max_ns) {
        timing->max_ns = duration_ns;
    }
}

uint64_t timing_quantile_ns(const struct timing *timing, double share)
{
    const double wanted = share * (double)timing->count;
    uint64_t seen = 0;
    for (uint32_t i = 0; i < TIMING_BIN_COUNT && timing->count > 0; i++) {
        seen += timing->bins[i];
        if (seen > 0 && (double)seen >= wanted) {
            if (i == TIMING_BIN_COUNT - 1) {
                break; /* It has no upper end but this. */
            }
            return i * (uint64_t)TIMING_BIN_NS + TIMING_BIN_NS / 2;
        }
    }
    return timing->max_ns;
}
