/* frame_pacer.h -- computes how many ticks are due since the last frame. Pure functions. */
#ifndef KINGYO_PLATFORM_KIOSK_FRAME_PACER_H
#define KINGYO_PLATFORM_KIOSK_FRAME_PACER_H

#include <stdint.h>

/* Maximum number of ticks per frame (0.5 s). Ticks beyond this maximum are dropped, because running
 * them would delay the next frame again. The maximum is high because ticks are cheap compared with
 * pictures. Players continue to move during dropped ticks. A stroke compressed into fewer ticks
 * would be faster and would tear the paper. */
#define FRAME_PACER_TICKS_MAX 60u

struct frame_pacer {
    uint64_t last_ns;
    int64_t owed;     /* Time that is due, in units of 1/120 ns, so that one tick is an integer. A
                         negative value means that more ticks were run than were due. */
    uint64_t dropped; /* Ticks that were due but were dropped. */
    uint8_t started;
};

/* Returns the number of ticks to run in the frame that starts at `now_ns`. The first frame runs two
 * ticks. A frame of about 1/60 s also runs exactly two ticks, so that timing jitter causes no
 * visible judder, while the sum of these frames is within 6 ms of the simulated time. Other frames
 * run all whole ticks that are due, and the rest is carried over. If the clock stops or goes back,
 * no ticks are due. */
uint32_t frame_pacer_ticks_due(struct frame_pacer *pace, uint64_t now_ns);

/* Frame limiter for a display that has no vertical synchronization or is much faster than 60 Hz. */
struct frame_pacer_sleep {
    uint64_t mean_ns; /* Mean duration of a frame without the limiter's delay. 0 means no frame
                         yet. */
};

/* Returns the delay in nanoseconds after a frame, so that 60 frames per second are drawn. `took_ns`
 * is the duration of the frame, including vertical synchronization. Returns 0 if the screen paces
 * the loop. */
uint64_t frame_pacer_sleep_ns(struct frame_pacer_sleep *rest, uint64_t took_ns);

#endif
