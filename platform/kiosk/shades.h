/* shades.h -- the fans and hands over the water, as the frame loop sees them.
 *
 * A device says once a frame where its fan is; each tick of the frame gets its own place on the way
 * there, since a shadow that stood still for a tick and leapt in the next would be a fast one. */
#ifndef KINGYO_PLATFORM_KIOSK_SHADES_H
#define KINGYO_PLATFORM_KIOSK_SHADES_H

#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"

struct shade_hand {
    struct shade_input from, to; /* Where the last tick left it; where the device says it is. */
    uint64_t retry_ns;           /* When a lost one is looked for again. */
    uint8_t link;                /* enum poi_link, but never BOT. */
};

/* Looks for the device. Returns whether that was a fault. */
uint32_t shade_hand_open(struct shade_hand *hand, const struct hal_shade *device, uint64_t now_ns);

/* Takes the newest reading; a lost device is looked for once a second, and holds nothing meanwhile.
 * A reading with a number that is none, or beyond 1,000 m, is refused. Returns how many faults it
 * met. */
uint32_t shade_hand_sample(struct shade_hand *hand, const struct hal_shade *device,
                           uint64_t now_ns);

/* For tick `index` of the `tick_count` >= 1 ticks of this frame. One that was not there before
 * comes where it is. */
struct shade_input shade_hand_at(const struct shade_hand *hand, uint32_t index,
                                 uint32_t tick_count);

/* After the frame's last tick: the way is done. */
void shade_hand_end(struct shade_hand *hand);

#endif
