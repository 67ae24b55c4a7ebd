/* late.h -- what people paid while the stall had no store, told to the one that came late.
 *
 * A stall that began without its store goes on from it by beginning anew, and what lies only in its
 * memory would be gone with it: coins, the credits they bought, those that SERVICE gave. So the
 * store is told all of it first, and what it was told is subtracted: a coin that falls while the
 * card is busy is told next, and nothing twice. */
#ifndef KINGYO_PLATFORM_KIOSK_LATE_H
#define KINGYO_PLATFORM_KIOSK_LATE_H

#include "core/core.h"
#include "platform/hal.h"

/* Zero: nothing was told yet. */
struct late {
    struct audits told;       /* On disk, of what this stall's own books say, ... */
    struct purse told_purse;  /* ... and of its purse. */
    struct audits asked;      /* What that will be when the store has written what it was given. */
    struct purse asked_purse;
    uint8_t is_asked;
};

/* Once a frame, while such a store is there and nobody plays: tells it what is left to tell. 1 when
 * it has everything on disk, and the stall may begin anew in this very frame. */
int late_is_told(struct late *late, const struct hal_storage *storage, const struct core *core);

#endif
