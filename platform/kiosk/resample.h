/* resample.h -- computes exactly one pose a tick from time-stamped reports. Pure.
 *
 * A tick that reused a pose would see a poi that stops and starts, with the speeds 2v, 0, 2v. The
 * drag, which grows with the square of the speed, would be four times too large. Therefore the
 * reports of a frame are spread over the frame's ticks. The newest tick gets the newest report, so
 * that no latency is added. The earlier ticks get points on the path from the last frame's end,
 * linear between reports. Invalid numbers and jumps are not interpolated: they appear in the tick
 * that they belong to. */
#ifndef KINGYO_PLATFORM_KIOSK_RESAMPLE_H
#define KINGYO_PLATFORM_KIOSK_RESAMPLE_H

#include <stdint.h>

#include "platform/hal.h"

/* Reports of one frame and of a few frames without ticks, and the last report that was used. */
#define RESAMPLE_MAX (2u * HAL_POI_SAMPLES_MAX)

struct resampler {
    struct poi_sample path[RESAMPLE_MAX]; /* Reports in order; [0] is the pose of the last tick. */
    uint32_t count;                       /* 0: no report yet. */
};

/* Forgets the path. Used after a controller was lost, because the motion in between is unknown. */
void resample_reset(struct resampler *resampler);

/* Adds a report. A report with the same or an earlier time replaces the newest one. When full, the
 * second oldest is dropped. Any bit pattern is accepted because the core validates it. Returns 0 if
 * a number is invalid or beyond the range of core/game/control/input_validation.h. */
int resample_push(struct resampler *resampler, const struct poi_sample *sample);

/* Returns the pose for tick `index` of the `tick_count` >= 1 ticks of this frame. `count` must be >
 * 0. */
struct poi_target resample_at(const struct resampler *resampler, uint32_t index,
                              uint32_t tick_count);

/* Makes the newest report the start of the next path. Call after the frame's last tick. */
void resample_end(struct resampler *resampler);

#endif
