/* fan_sampler.h -- samples the fans for the frame loop. A fan is a device that a player holds above
 * the water and that casts a shadow on the water.
 *
 * A fan device reports its position once per frame, but a frame may run several ticks. Each tick
 * gets its own position on the line between two reports. Otherwise the shadow would stop for one
 * tick and jump in the next, and the core would detect a fast movement. */
#ifndef KINGYO_PLATFORM_KIOSK_FAN_SAMPLER_H
#define KINGYO_PLATFORM_KIOSK_FAN_SAMPLER_H

#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"

struct fan_sampler {
    struct shade_input from, to; /* Position at the last tick of the previous frame (`from`), and
                                    newest position from the device (`to`). */
    uint64_t retry_ns;           /* Time of the next attempt to open a lost device. */
    uint8_t link;                /* Connection state of the device (enum poi_source), never
                                    POI_SOURCE_BOT. */
};

/* Opens the fan device. Returns 1 if opening failed with a fault. Returns 0 on success, or if there
 * is no fan device. */
uint32_t fan_sampler_open(struct fan_sampler *hand, const struct hal_fan *device, uint64_t now_ns);

/* Reads the newest report. Tries to reopen a lost fan once per second. While a fan is lost, the fan
 * counts as absent. Rejects a report with a non-finite number or a value beyond 1,000 m. Returns
 * the number of faults. */
uint32_t fan_sampler_sample(struct fan_sampler *hand, const struct hal_fan *device,
                            uint64_t now_ns);

/* Returns the fan's position for tick `index` of the `tick_count` >= 1 ticks of the frame. A fan
 * that was absent before appears at its position without interpolation. */
struct shade_input fan_sampler_at(const struct fan_sampler *hand, uint32_t index,
                                  uint32_t tick_count);

/* Makes the newest position the first point of the next frame's line. Call after the last tick of
 * the frame. */
void fan_sampler_end(struct fan_sampler *hand);

#endif
