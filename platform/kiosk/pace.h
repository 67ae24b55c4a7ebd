/* pace.h -- how many ticks the time since the last frame owes. Pure. */
#ifndef KINGYO_PLATFORM_KIOSK_PACE_H
#define KINGYO_PLATFORM_KIOSK_PACE_H

#include <stdint.h>

#define PACE_TICKS_MAX 24u /* 0.2 s: a longer stall is dropped, or catching up would stall again. */

struct pace {
    uint64_t last_ns;
    uint64_t owed;       /* In 1/120 ns, so that a tick is a whole number of them. */
    uint64_t dropped;    /* Ticks that were owed and never run. */
    uint8_t started;
};

/* Ticks to run in the frame that begins at `now_ns`. The first frame runs two. A frame that is
 * within 1.5 ms of a 60 Hz display's runs exactly two, so that its jitter never shows as judder;
 * else what is left of a tick is kept for the next frame. A clock that stands or goes back owes
 * nothing. */
uint32_t pace_ticks_due(struct pace *pace, uint64_t now_ns);

#endif
