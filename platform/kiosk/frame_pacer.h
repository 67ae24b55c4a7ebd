/* frame_pacer.h -- frame pacer: computes how many ticks are due since the last frame. Pure. */
#ifndef KINGYO_PLATFORM_KIOSK_FRAME_PACER_H
#define KINGYO_PLATFORM_KIOSK_FRAME_PACER_H

#include <stdint.h>

/* Limit of 0.5 s: ticks due beyond this are dropped, because catching up would cause another delay.
 * The limit is long because ticks are cheap compared with pictures. Players continue to move during
 * dropped ticks, and a stroke compressed into fewer ticks would tear the paper. */
#define FRAME_PACER_TICKS_MAX 60u

struct frame_pacer {
    uint64_t last_ns;
    int64_t owed;     /* Due time in units of 1/120 ns, so that one tick is an integer; < 0:
                         ahead of time. */
    uint64_t dropped; /* Ticks that were due and never ran. */
    uint8_t started;
};

/* Returns the ticks to run in the frame that begins at `now_ns`. The first frame runs two. A frame
 * of about the length of a 60 Hz display's also runs exactly two, so that jitter causes no judder.
 * This applies as long as the sum of such frames stays within 6 ms of the ticks run. Other frames
 * run the whole ticks that are due, and the rest is carried over. A clock that stops or goes back
 * makes no ticks due. */
uint32_t frame_pacer_ticks_due(struct frame_pacer *pace, uint64_t now_ns);

/* Frame limiter for a display without vertical sync, or much faster than 60 Hz. */
struct frame_pacer_sleep {
    uint64_t mean_ns; /* Mean duration of a frame without the delay; 0: none yet. */
};

/* Returns the delay after a frame that took `took_ns`, including vertical sync, so that 60 frames a
 * second are drawn. Returns 0 if the screen paces the loop. */
uint64_t frame_pacer_sleep_ns(struct frame_pacer_sleep *rest, uint64_t took_ns);

#endif
