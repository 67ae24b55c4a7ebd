/* frame_pacer.h -- computes how many ticks (1/120 s) the frame loop must run in each frame, and
 * counts the durations of frames in a histogram. Pure functions. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Maximum number of ticks per frame (0.5 s). Further ticks are dropped, because running them would
 * delay the next frame again. The maximum is high because a tick takes much less time than a
 * picture. The maximum is also high because dropped ticks affect the game. Players continue to move
 * during the dropped time, and the next ticks contain this motion too. The poi would then move
 * faster than the player did, and would tear the paper. */
#define FRAME_PACER_TICKS_MAX 60u

struct frame_pacer {
    uint64_t last_ns;
    /* Elapsed time that is not simulated yet, in units of 1/120 ns, so that one tick is an integer.
     * A negative value means that the simulation is ahead of the clock. */
    int64_t owed;
    /* Number of ticks that were dropped because a frame needed more than FRAME_PACER_TICKS_MAX. */
    uint64_t dropped;
    bool started; /* True after the first frame. */
};

/* Returns the number of ticks to run in the frame that starts at `now_ns`. The first frame runs two
 * ticks. A frame of about 1/60 s also runs exactly two ticks, because timing jitter would otherwise
 * cause visible judder. The rule of two ticks applies while the simulated time differs from the
 * clock by at most 6 ms. Any other frame runs all complete ticks of the elapsed time and keeps the
 * rest of the time for the next frame. If the clock stops or goes back, no time elapses. */
uint32_t frame_pacer_ticks_due(struct frame_pacer *pace, uint64_t now_ns);

/* Frame limiter for a display that has no vertical synchronization or is much faster than 60 Hz. */
struct frame_pacer_sleep {
    /* Moving average of the frame duration without the limiter's delay. 0 means no frame yet. */
    uint64_t mean_ns;
};

/* Returns the delay in nanoseconds after a frame, so that 60 frames per second are drawn. `took_ns`
 * is the duration of the frame, including vertical synchronization. Returns 0 if the screen's
 * vertical synchronization already limits the frame rate. */
uint64_t frame_pacer_sleep_ns(struct frame_pacer_sleep *rest, uint64_t took_ns);

/* ---- Histogram of durations ---------------------------------------------------------------- */

/* A histogram of durations in fixed memory, which gives the median and the 99th percentile of a
 * whole day. Pure functions. */

/* Width of a fine histogram bin (0.05 ms), which is less than the variation of frame times. */
#define TIMING_BIN_NS 50000u
/* Number of fine histogram bins. The fine bins cover durations up to 0.4 s, and the coarse bins
 * cover longer durations. */
#define TIMING_BIN_COUNT 8000u
/* Width of a coarse histogram bin (20 ms). */
#define TIMING_SLOW_NS 20000000u
/* Number of coarse histogram bins, which cover durations up to 10 s. Longer durations are counted
 * in the last bin. */
#define TIMING_SLOW_COUNT 500u

struct frame_timing {
    uint64_t count, sum_ns, max_ns;
    uint32_t bins[TIMING_BIN_COUNT + TIMING_SLOW_COUNT];
};

/* Adds one duration to the histogram. */
void frame_timing_add(struct frame_timing *timing, uint64_t duration_ns);

/* Returns the quantile of all durations for the fraction `share` in [0, 1]: at least this fraction
 * of the durations is not longer than the result. 0.5 gives the median. The error is at most half
 * the width of a histogram bin. Returns max_ns if the result is in the last bin, and 0 if no
 * duration was added. */
uint64_t frame_timing_quantile_ns(const struct frame_timing *timing, double share);
