/* resample.h -- computes exactly one pose per tick from time-stamped reports. Pure functions.
 *
 * If a tick repeated a pose, a poi that moves with the constant speed v would seem to move with the
 * speeds 2v, 0 and 2v. The drag force grows with the square of the speed and would be four times
 * too large. Therefore the reports of a frame are distributed over the frame's ticks. The last tick
 * gets the newest report, so that no latency is added. The earlier ticks get points on the path
 * from the end of the previous frame, linear between reports. A jump or a report with invalid
 * numbers is not interpolated but appears unchanged in the tick to which it belongs. */
#ifndef KINGYO_PLATFORM_KIOSK_RESAMPLE_H
#define KINGYO_PLATFORM_KIOSK_RESAMPLE_H

#include <stdint.h>

#include "platform/hal.h"

/* Maximum number of reports in the path: the last used report, the reports of one frame, and the
 * reports of a few frames without ticks. */
#define RESAMPLE_MAX (2u * HAL_POI_SAMPLES_MAX)

struct resampler {
    struct poi_sample path[RESAMPLE_MAX]; /* Reports in time order. path[0] is the pose of the last
                                             tick. */
    uint32_t count;                       /* Number of reports in `path`. 0 means no report yet. */
};

/* Clears the path. Called after the loss of a controller, because the motion during the loss is
 * unknown. */
void resample_reset(struct resampler *resampler);

/* Adds a report. A report whose time is not later than the time of the newest report replaces the
 * newest report. If the path is full, the second oldest report is dropped, because the oldest
 * report is the start of the path. Accepts any bit pattern because the core validates the values.
 * Returns 1, or 0 if a number is invalid or out of the range of
 * core/game/control/input_validation.h. */
int resample_push(struct resampler *resampler, const struct poi_sample *sample);

/* Returns the pose for tick `index` of the `tick_count` >= 1 ticks of the frame. Asserts that
 * `count` is greater than 0. */
struct poi_target resample_at(const struct resampler *resampler, uint32_t index,
                              uint32_t tick_count);

/* Makes the newest report the start of the next frame's path. Call after the last tick of the
 * frame. */
void resample_end(struct resampler *resampler);

#endif
