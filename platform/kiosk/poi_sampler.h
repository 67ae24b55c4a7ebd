/* poi_sampler.h -- samples the pois' controllers for the frame loop.
 *
 * Devices are polled once a frame. Each tick of the frame gets its own pose on the path between the
 * reports (resample.h). Device values are passed on without validation because the core validates
 * them. */
#ifndef KINGYO_PLATFORM_KIOSK_POI_SAMPLER_H
#define KINGYO_PLATFORM_KIOSK_POI_SAMPLER_H

#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"
#include "platform/kiosk/resample.h"
#include "platform/kiosk/timing.h"

/* Report rate of a controller, counted over one second and displayed during the next. */
struct report_pace {
    uint64_t begin_ns; /* Start of the second that is counted. */
    uint64_t last_ns;  /* Arrival time of the last report; 0: none yet. */
    uint64_t gap_ns;   /* Longest gap between two reports in this second. */
    uint32_t count;
    uint32_t shown_count; /* Reports in the last complete second. */
    uint64_t shown_gap_ns;
};

/* Controller of one player. */
struct poi_sampler {
    struct report_pace pace;
    struct resampler path;
    uint64_t retry_ns;           /* Time of the next attempt to open a lost controller. */
    uint64_t newest_ns;          /* Arrival time of the newest report. */
    uint8_t link;                /* enum poi_source, but never BOT. */
    uint8_t has_wrist, trembles; /* Flags of the newest report. */
    uint8_t was_seen; /* 1: the controller has sent at least one report since the start. */
    uint64_t waiting_ns[HAL_POI_SAMPLES_MAX]; /* Arrival times of reports that no tick has used
                                                 yet. */
    uint32_t waiting_count;                   /* Entries in waiting_ns; further reports are not
                                                 timed. */
};

/* Opens the device. Returns 1 if that failed with a fault, else 0. */
uint32_t poi_sampler_open(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns);

/* Reads the reports since the last frame. Retries a lost device once a second. Returns the number
 * of faults: failed calls, and reports with invalid numbers. */
uint32_t poi_sampler_sample(struct poi_sampler *hand, const struct hal_poi *device,
                            uint64_t now_ns);

/* Writes the pose for tick `index` of the `tick_count` >= 1 ticks of the frame that began at
 * `now_ns`. A controller without any report counts as absent. A controller that stopped reporting
 * counts as lost, and its target stays unchanged. A path that took much longer than the frame's
 * ticks is not interpolated. The core gets it as late reports
 * (core/game/control/input_validation.h) and blends it in slowly. */
void poi_sampler_at(const struct poi_sampler *hand, uint32_t index, uint32_t tick_count,
                    uint64_t now_ns, struct poi_input *out);

/* Adds to `wait` how long each report has waited. Call at the frame's first tick. */
void poi_sampler_time(struct poi_sampler *hand, uint64_t now_ns, struct timing *wait);

/* Starts the next path. Call after the frame's last tick. */
void poi_sampler_end(struct poi_sampler *hand);

#endif
