/* fan_sampler.h -- samples the fans for the frame loop.
 *
 * A device reports its fan's position once a frame. Each tick of the frame gets its own position on
 * the path, because a shadow that stops for a tick and jumps in the next would count as fast. */
#ifndef KINGYO_PLATFORM_KIOSK_FAN_SAMPLER_H
#define KINGYO_PLATFORM_KIOSK_FAN_SAMPLER_H

#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"

struct fan_sampler {
    struct shade_input from, to; /* Position at the last tick, and newest position of the device. */
    uint64_t retry_ns;           /* Time of the next attempt to open a lost device. */
    uint8_t link;                /* enum poi_source, but never BOT. */
};

/* Opens the device. Returns 1 if that failed with a fault, else 0. */
uint32_t fan_sampler_open(struct fan_sampler *hand, const struct hal_fan *device, uint64_t now_ns);

/* Reads the newest report. A lost device is retried once a second and counts as absent meanwhile.
 * Rejects a report with a number that is not finite or beyond 1,000 m. Returns the number of
 * faults. */
uint32_t fan_sampler_sample(struct fan_sampler *hand, const struct hal_fan *device,
                            uint64_t now_ns);

/* Returns the position for tick `index` of the `tick_count` >= 1 ticks of this frame. A fan that
 * was absent appears at its position without a path. */
struct shade_input fan_sampler_at(const struct fan_sampler *hand, uint32_t index,
                                  uint32_t tick_count);

/* Starts the next path. Call after the frame's last tick. */
void fan_sampler_end(struct fan_sampler *hand);

#endif
