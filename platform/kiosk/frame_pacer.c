/* frame_pacer.c -- converts elapsed time to a number of ticks; see frame_pacer.h. */
#include "platform/kiosk/frame_pacer.h"

#include "core/base/panic.h"
#include "platform/hal.h"

#define FRAME_TICKS 2u
#define FRAME_NS (NS_PER_S * FRAME_TICKS / CORE_TICK_HZ)
/* Maximum difference between FRAME_NS and the duration of a frame for which the frame may belong to
 * a 60 Hz display with jitter. Frame rates of 50 .. 76 Hz are within the limit. */
#define LIKE_60_HZ_NS 3500000ull
/* Maximum difference between FRAME_NS and the duration of a frame for which the frame certainly
 * belongs to a 60 Hz display. Frame rates of 55 .. 66 Hz are within the limit. */
#define SURE_60_HZ_NS 1500000ull
/* snap() runs exactly two ticks only if the simulated time differs from the clock by at most this
 * number of nanoseconds. The limit is 6 ms, because the start of a frame and the start of the
 * previous frame may each be 3 ms early or late. */
#define SNAP_NS 6000000ll
/* Correction of the simulated time: each frame of a 60 Hz display removes 1/8 of the difference
 * between the simulated time and the clock. A correction is necessary because no display has
 * exactly 60 Hz. */
#define DRIFT_SHARE 8

/* A mean frame time of at least this length is attributed to vertical synchronization. The display
 * then runs at 62 Hz or less, so no frame limiter is needed. */
#define WAITS_NS 16000000ull
/* Number of frames in the moving average of the frame time. 16 frames are about a quarter of a
 * second. */
#define REST_SHARE 16

static uint64_t absolute_difference(uint64_t a, uint64_t b)
{
    return a > b ? a - b : b - a;
}

/* Returns true if the frame must run exactly two ticks. Two ticks are correct if the
 * frame lasted about 1/60 s and the elapsed time in `owed` is near the time of two ticks. */
static bool snap(struct frame_pacer *pace, uint64_t elapsed_ns)
{
    const int64_t left = pace->owed - (int64_t)(FRAME_TICKS * NS_PER_S);
    const int64_t snap = SNAP_NS * (int64_t)CORE_TICK_HZ;
    if (absolute_difference(elapsed_ns, FRAME_NS) > LIKE_60_HZ_NS || left > snap || left < -snap) {
        return false;
    }
    pace->owed = absolute_difference(elapsed_ns, FRAME_NS) < SURE_60_HZ_NS
                     ? left - left / DRIFT_SHARE
                     : left;
    return true;
}

uint32_t frame_pacer_ticks_due(struct frame_pacer *pace, uint64_t now_ns)
{
    if (!pace->started) {
        pace->started = true;
        pace->last_ns = now_ns;
        return FRAME_TICKS;
    }
    const uint64_t elapsed_ns = now_ns > pace->last_ns ? now_ns - pace->last_ns : 0;
    pace->last_ns = now_ns;
    /* Limits the elapsed time to one hour, so that an invalid clock value cannot overflow
     * `owed`. */
    const uint64_t hour_ns = 3600u * NS_PER_S;
    pace->owed += (int64_t)((elapsed_ns < hour_ns ? elapsed_ns : hour_ns) * CORE_TICK_HZ);
    if (snap(pace, elapsed_ns)) {
        return FRAME_TICKS;
    }
    if (pace->owed < 0) {
        return 0;
    }
    uint64_t ticks = (uint64_t)pace->owed / NS_PER_S;
    pace->owed %= (int64_t)NS_PER_S;
    if (ticks > FRAME_PACER_TICKS_MAX) {
        pace->dropped += ticks - FRAME_PACER_TICKS_MAX;
        ticks = FRAME_PACER_TICKS_MAX;
    }
    return (uint32_t)ticks;
}

uint64_t frame_pacer_sleep_ns(struct frame_pacer_sleep *rest, uint64_t took_ns)
{
    if (rest->mean_ns == 0) {
        rest->mean_ns = FRAME_NS; /* The screen is assumed to have vertical synchronization until
                                     the mean frame time shows otherwise. */
    }
    rest->mean_ns = (rest->mean_ns * (REST_SHARE - 1) + took_ns) / REST_SHARE;
    return rest->mean_ns < WAITS_NS && took_ns < FRAME_NS ? FRAME_NS - took_ns : 0;
}

/* ---- Histogram of durations ---------------------------------------------------------------- */

#define FINE_END_NS ((uint64_t)TIMING_BIN_NS * TIMING_BIN_COUNT)
#define LAST (TIMING_BIN_COUNT + TIMING_SLOW_COUNT - 1u)

void frame_timing_add(struct frame_timing *timing, uint64_t duration_ns)
{
    const bool is_fine = duration_ns < FINE_END_NS;
    const uint64_t slow = is_fine ? 0u : (duration_ns - FINE_END_NS) / TIMING_SLOW_NS;
    const uint32_t bin = is_fine                         ? (uint32_t)(duration_ns / TIMING_BIN_NS)
                         : slow < TIMING_SLOW_COUNT - 1u ? TIMING_BIN_COUNT + (uint32_t)slow
                                                         : LAST;
    CORE_ASSERT(bin <= LAST);
    timing->bins[bin]++;
    timing->count++;
    timing->sum_ns += duration_ns;
    if (duration_ns > timing->max_ns) {
        timing->max_ns = duration_ns;
    }
}

uint64_t frame_timing_quantile_ns(const struct frame_timing *timing, double share)
{
    CORE_ASSERT(share >= 0.0 && share <= 1.0);
    const double wanted = share * (double)timing->count;
    uint64_t seen = 0;
    for (uint32_t i = 0; i < LAST && timing->count > 0; i++) {
        seen += timing->bins[i];
        if (seen > 0 && (double)seen >= wanted) {
            const uint64_t middle = i < TIMING_BIN_COUNT
                                        ? i * (uint64_t)TIMING_BIN_NS + TIMING_BIN_NS / 2u
                                        : FINE_END_NS +
                                              (i - TIMING_BIN_COUNT) * (uint64_t)TIMING_SLOW_NS +
                                              TIMING_SLOW_NS / 2u;
            return middle < timing->max_ns ? middle : timing->max_ns;
        }
    }
    return timing->max_ns; /* The last histogram bin has no upper limit, therefore the maximum
                              duration is returned. */
}
