/* gamepad_queue.h -- queues a pad's reports and samples the resulting motion. Pure.
 *
 * A stick sets a velocity, so the poi moves between reports too. The motion is sampled once for
 * each tick, however rarely the kiosk polls. SDL's pads and their simulated twin use this
 * module. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_QUEUE_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_QUEUE_H

#include "drivers/gamepad/gamepad_decoder.h"

#define GAMEPAD_REPORTS_MAX 64u /* Queue capacity, the same as HAL_POI_SAMPLES_MAX. */

struct gamepad_queue {
    struct gamepad_decoder hand;
    struct gamepad_report report[GAMEPAD_REPORTS_MAX]; /* Pending reports, oldest first. */
    uint32_t report_count;
    uint64_t sampled_ns;
};

/* Initializes the track with the poi over the middle of the water at `time_ns`. */
void gamepad_queue_init(struct gamepad_queue *track, const struct view *view, uint64_t time_ns);

/* Appends a report. If the queue is full, the oldest report is decoded now. The buttons of that
 * report count, but the motion is not sampled. */
void gamepad_queue_push(struct gamepad_queue *track, const struct gamepad_report *report);

/* Samples the motion from the last call to `now_ns`. Writes at most `max` samples, of which the
 * last is at `now_ns`. Returns their number. */
uint32_t gamepad_queue_pop(struct gamepad_queue *track, uint64_t now_ns, struct poi_sample *out,
                           uint32_t max);

/* Decodes all pending reports and writes the buttons. */
void gamepad_queue_buttons(struct gamepad_queue *track, struct button_sample *out);

#endif
