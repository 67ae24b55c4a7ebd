/* timing.c -- counts durations in fine bins, coarse bins and one last bin; see timing.h. */
#include "platform/kiosk/timing.h"

#define FINE_END_NS ((uint64_t)TIMING_BIN_NS * TIMING_BIN_COUNT)
#define LAST (TIMING_BIN_COUNT + TIMING_SLOW_COUNT - 1u)

static uint32_t bin_of(uint64_t duration_ns)
{
    if (duration_ns < FINE_END_NS) {
        return (uint32_t)(duration_ns / TIMING_BIN_NS);
    }
    const uint64_t slow = (duration_ns - FINE_END_NS) / TIMING_SLOW_NS;
    return slow < TIMING_SLOW_COUNT - 1u ? TIMING_BIN_COUNT + (uint32_t)slow : LAST;
}

static uint64_t middle_ns(uint32_t bin)
{
    if (bin < TIMING_BIN_COUNT) {
        return bin * (uint64_t)TIMING_BIN_NS + TIMING_BIN_NS / 2u;
    }
    return FINE_END_NS + (bin - TIMING_BIN_COUNT) * (uint64_t)TIMING_SLOW_NS + TIMING_SLOW_NS / 2u;
}

void timing_add(struct timing *timing, uint64_t duration_ns)
{
    timing->bins[bin_of(duration_ns)]++;
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
    for (uint32_t i = 0; i < LAST && timing->count > 0; i++) {
        seen += timing->bins[i];
        if (seen > 0 && (double)seen >= wanted) {
            const uint64_t middle = middle_ns(i);
            return middle < timing->max_ns ? middle : timing->max_ns;
        }
    }
    return timing->max_ns; /* The last bin has no upper limit except max_ns. */
}
