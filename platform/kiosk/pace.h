/* pace.h -- how many ticks the time since the last frame owes. Pure. */
#ifndef KINGYO_PLATFORM_KIOSK_PACE_H
#define KINGYO_PLATFORM_KIOSK_PACE_H

#include <stdint.h>

/* 0.5 s: a longer stall is dropped, or catching up would stall again. Ticks are cheap where
 * pictures are dear, and hands go on in the time that is dropped: a stroke of a third of a second
 * in less of it would tear the paper. */
#define PACE_TICKS_MAX 60u

struct pace {
    uint64_t last_ns;
    int64_t owed;        /* In 1/120 ns, so that a tick is whole; < 0: run ahead of time. */
    uint64_t dropped;    /* Ticks that were owed and never run. */
    uint8_t started;
};

/* Ticks to run in the frame that begins at `now_ns`. The first frame runs two. A frame about as
 * long as a 60 Hz display's runs exactly two while the sum of such frames stays within 6 ms of
 * the ticks run, so that jitter never shows as judder; else whole ticks run, and what is left of
 * one is kept for the next frame. A clock that stands or goes back owes nothing. */
uint32_t pace_ticks_due(struct pace *pace, uint64_t now_ns);

/* For a display that does not wait for its screen, or for one much faster than 60 Hz. */
struct pace_rest {
    uint64_t mean_ns;    /* Of what a frame takes without the rest; 0: none was seen. */
};

/* How long a frame that took `took_ns`, its waiting for the screen included, should rest so that 60
 * begin in a second; 0 where the screen paces them. */
uint64_t pace_rest_ns(struct pace_rest *rest, uint64_t took_ns);

#endif
