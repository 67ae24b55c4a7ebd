/* gamepad_queue.h -- queues the reports of a game pad and samples the resulting motion.
 *
 * A stick sets a velocity, so the poi (the paper scoop) moves between reports too. The motion is
 * sampled once for each tick (1/120 s), however rarely the kiosk polls. SDL's game pads and the
 * simulated game pad share this module. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_QUEUE_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_QUEUE_H

#include "drivers/gamepad/gamepad_decoder.h"

#define GAMEPAD_REPORTS_MAX 64u /* Capacity of the queue, equal to HAL_POI_SAMPLES_MAX. */

struct gamepad_queue {
    struct gamepad_decoder hand;                       /* Decoder, whose state includes all decoded
                                                          reports. */
    struct gamepad_report report[GAMEPAD_REPORTS_MAX]; /* Reports that are not decoded yet, oldest
                                                          first. */
    uint32_t report_count;
    uint64_t sampled_ns; /* Time of the newest sample. */
};

/* Initializes `track` with the poi over the middle of the water at `time_ns`. */
void gamepad_queue_init(struct gamepad_queue *track, const struct view *view, uint64_t time_ns);

/* Appends a report. If the queue is full, the oldest report is decoded immediately. The buttons of
 * the oldest report still count, but the motion up to its time is not sampled. */
void gamepad_queue_push(struct gamepad_queue *track, const struct gamepad_report *report);

/* Samples the motion from the previous call to `now_ns`. Writes at most `max` samples, the last of
 * which is at `now_ns`. Returns the number of samples. */
uint32_t gamepad_queue_pop(struct gamepad_queue *track, uint64_t now_ns, struct poi_sample *out,
                           uint32_t max);

/* Decodes all pending reports and writes the pressed buttons to `out`. */
void gamepad_queue_buttons(struct gamepad_queue *track, struct button_sample *out);

#endif
