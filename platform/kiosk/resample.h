/* resample.h -- from time-stamped readings of a hand to exactly one pose a tick. Pure.
 *
 * A tick that reused a pose would see a hand that stops and starts: speed 2v, 0, 2v, and drag,
 * which grows with its square, four-fold. So the readings of a frame are spread over the frame's
 * ticks: the newest tick gets the newest reading (no latency is added), the ones before it get
 * the path between that and the last frame's end, linear between readings. A way that no hand goes
 * is not walked: numbers that are none, and leaps, stand in the tick that they belong to. */
#ifndef KINGYO_PLATFORM_KIOSK_RESAMPLE_H
#define KINGYO_PLATFORM_KIOSK_RESAMPLE_H

#include <stdint.h>

#include "platform/hal.h"

/* A frame's worth of readings, those of a few tickless frames, and the last one used. */
#define RESAMPLE_MAX (2u * HAL_POI_SAMPLES_MAX)

struct resampler {
    struct poi_sample path[RESAMPLE_MAX]; /* [0] is where the last tick left the hand. */
    uint32_t count;                       /* 0: nothing was ever read. */
};

/* Forgets the path: after a link was lost, the way in between was not travelled. */
void resample_reset(struct resampler *resampler);

/* Adds a reading. One of the same or an earlier time replaces the newest; when full, the oldest but
 * one goes. Any bits are taken, for the core to judge; 0: some number is none, or beyond what
 * core/game/trust.h reads. */
int resample_push(struct resampler *resampler, const struct poi_sample *sample);

/* The pose for tick `index` of the `tick_count` >= 1 ticks of this frame; needs count > 0. */
struct poi_target resample_at(const struct resampler *resampler, uint32_t index,
                              uint32_t tick_count);

/* After the frame's last tick: the newest reading becomes the start of the next path. */
void resample_end(struct resampler *resampler);

#endif
