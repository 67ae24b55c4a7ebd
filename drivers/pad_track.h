/* pad_track.h -- a pad's reports as they wait for the next look, and the way its hand makes. Pure.
 *
 * A stick is a speed, so a hand goes on between two reports: it is sampled a tick apart, however
 * seldom the kiosk looks. SDL's pads and their simulated twin both end here. */
#ifndef KINGYO_DRIVERS_PAD_TRACK_H
#define KINGYO_DRIVERS_PAD_TRACK_H

#include "drivers/pad_hand.h"

#define PAD_REPORTS_MAX 64u /* That wait: as many as HAL_POI_SAMPLES_MAX. */

struct pad_track {
    struct pad_hand hand;
    struct pad_report report[PAD_REPORTS_MAX]; /* Not taken yet, oldest first. */
    uint32_t report_count;
    uint64_t sampled_ns;
};

/* A hand over the middle of the water at `time_ns`. */
void pad_track_init(struct pad_track *track, const struct view *view, uint64_t time_ns);

/* A report came. Where PAD_REPORTS_MAX wait, the oldest is taken, and the way it told is not seen
 * but its buttons are. */
void pad_track_keep(struct pad_track *track, const struct pad_report *report);

/* The hand's way from the last look to `now_ns`: at most `max` samples, the last of now. Returns
 * how many. */
uint32_t pad_track_take(struct pad_track *track, uint64_t now_ns, struct poi_sample *out,
                        uint32_t max);

/* Its buttons, with those of all reports that still wait. */
void pad_track_buttons(struct pad_track *track, struct button_sample *out);

#endif
