/* frame_pacer.h -- computes how many ticks (1/120 s) the frame loop must run in each frame. Pure
 * functions. */
#ifndef KINGYO_PLATFORM_KIOSK_FRAME_PACER_H
#define KINGYO_PLATFORM_KIOSK_FRAME_PACER_H

#include <stdint.h>

/* Maximum number of ticks per frame (0.5 s). Further ticks are dropped, because running them would
 * delay the next frame again. The maximum is high because a tick takes much less time than a
 * picture. Dropped ticks also affect the game: players continue to move during dropped ticks. A
 * stroke compressed into fewer ticks would be faster and would tear the paper. */
#define FRAME_PACER_TICKS_MAX 60u

struct frame_pacer {
    uint64_t last_ns;
    int64_t owed;     /* Elapsed time that is not simulated yet, in units of 1/120 ns, so that one
                         tick is an integer. A negative value means that the simulation is ahead of
                         the clock. */
    uint64_t dropped; /* Number of ticks that were dropped because a frame needed more than
                         FRAME_PACER_TICKS_MAX. */
    uint8_t started;
};

/* Returns the number of ticks to run in the frame that starts at `now_ns`. The first frame runs two
 * ticks. A frame of about 1/60 s also runs exactly two ticks, because timing jitter would otherwise
 * cause visible judder. This rule applies while the simulated time differs from the clock by at
 * most 6 ms. Each other frame runs all complete ticks of the elapsed time and carries over the
 * rest. If the clock stops or goes back, no time elapses. */
uint32_t frame_pacer_ticks_due(struct frame_pacer *pace, uint64_t now_ns);

/* Frame limiter for a display that has no vertical synchronization or is much faster than 60 Hz. */
struct frame_pacer_sleep {
    uint64_t mean_ns; /* Moving average of the frame duration without the limiter's delay. 0 means
                         no frame yet. */
};

/* Returns the delay in nanoseconds after a frame, so that 60 frames per second are drawn. `took_ns`
 * is the duration of the frame, including vertical synchronization. Returns 0 if the screen's
 * vertical synchronization already limits the frame rate. */
uint64_t frame_pacer_sleep_ns(struct frame_pacer_sleep *rest, uint64_t took_ns);

#endif
