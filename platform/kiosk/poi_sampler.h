/* poi_sampler.h -- samples the controllers of the pois for the frame loop.
 *
 * Devices are polled once per frame. Each tick of the frame gets its own pose on the path between
 * the reports (resample.h). Device values are passed on without validation because the core
 * validates them. */
#ifndef KINGYO_PLATFORM_KIOSK_POI_SAMPLER_H
#define KINGYO_PLATFORM_KIOSK_POI_SAMPLER_H

#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"
#include "platform/kiosk/resample.h"
#include "platform/kiosk/timing.h"

/* Report statistics of a controller, measured over one second and shown during the next second. */
struct report_pace {
    uint64_t begin_ns; /* Start of the current second. */
    uint64_t last_ns;  /* Arrival time of the last report. 0 means no report yet. */
    uint64_t gap_ns;   /* Longest gap between two reports in the current second. */
    uint32_t count;
    uint32_t shown_count; /* Number of reports in the last complete second. */
    uint64_t shown_gap_ns;
};

/* Sampler for the controller of one player. */
struct poi_sampler {
    struct report_pace pace;
    struct resampler path;
    uint64_t retry_ns;           /* Time of the next attempt to open a lost controller. */
    uint64_t newest_ns;          /* Arrival time of the newest report. */
    uint8_t link;                /* Connection state of the controller (enum poi_source), never
                                    POI_SOURCE_BOT. */
    uint8_t has_wrist, trembles; /* Flags of the newest report; see struct poi_sample. */
    uint8_t was_seen; /* 1 if the controller has sent a report since program start, otherwise 0. */
    uint64_t waiting_ns[HAL_POI_SAMPLES_MAX]; /* Arrival times of reports that no tick has used
                                                 yet. */
    uint32_t waiting_count;                   /* Number of entries in `waiting_ns`. When
                                                 `waiting_ns` is full, the waiting time of a further
                                                 report is not measured. */
};

/* Opens the controller. Returns 1 if open() returned a device fault (hal_is_fault()), otherwise
 * 0. */
uint32_t poi_sampler_open(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns);

/* Reads the reports that arrived since the last frame. Tries to reopen a lost controller once per
 * second. Returns the number of faults: failed calls, and reports with invalid numbers. */
uint32_t poi_sampler_sample(struct poi_sampler *hand, const struct hal_poi *device,
                            uint64_t now_ns);

/* Writes the pose for tick `index` of the `tick_count` >= 1 ticks of the frame that started at
 * `now_ns`. A controller that never sent a report counts as absent. A controller that stopped
 * reporting counts as lost, and its pose stays unchanged. If the reports cover much more time than
 * the ticks, the pose is not interpolated. The core then gets late reports
 * (core/game/control/input_validation.h) and moves the poi slowly to the new pose. */
void poi_sampler_at(const struct poi_sampler *hand, uint32_t index, uint32_t tick_count,
                    uint64_t now_ns, struct poi_input *out);

/* Adds the waiting time of each unused report to the histogram `wait`. Call before the first tick
 * of the frame. */
void poi_sampler_time(struct poi_sampler *hand, uint64_t now_ns, struct timing *wait);

/* Makes the newest report the first point of the next frame's path. Call after the last tick of the
 * frame. */
void poi_sampler_end(struct poi_sampler *hand);

#endif
