/* sampler.h -- samples the controllers of the pois and the fans for the frame loop, and computes
 * one position per tick.
 *
 * Devices are polled once per frame, but a frame may run several ticks. Each tick of the frame gets
 * its own pose on the path between the reports. Device values are passed on without validation
 * because the core validates them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"
#include "platform/kiosk/frame_pacer.h"

/* ---- Resampling ---------------------------------------------------------------------------- */

/* Computes exactly one pose per tick from time-stamped reports. Pure functions. If a tick repeated
 * a pose, a poi that moves with the constant speed v would seem to move with the speeds 0 and 2v in
 * successive ticks. The drag force grows with the square of the speed and would be four times too
 * large at 2v. Therefore the reports of a frame are distributed over the frame's ticks. The last
 * tick gets the newest report, so that no latency is added. The earlier ticks get points on the
 * path from the end of the previous frame, linear between reports. A jump or a report with invalid
 * numbers is not interpolated but appears unchanged in the tick to which it belongs. */

/* Maximum number of reports in the path: the last used report, the reports of one frame, and the
 * reports of a few frames without ticks. */
#define SAMPLER_PATH_MAX (2u * HAL_POI_SAMPLES_MAX)

struct sampler_path {
    struct poi_sample
        path[SAMPLER_PATH_MAX]; /* Reports in time order. path[0] is the pose of the last tick. */
    uint32_t count;             /* Number of reports in `path`. 0 means no report yet. */
};

/* Adds a report. A report whose time is not later than the time of the newest report replaces the
 * newest report. If the path is full, the second oldest report is dropped, because the oldest
 * report is the start of the path. Stores even an invalid report, because the core validates the
 * values. Returns false if a number of the report is invalid or out of the range of
 * core/game/control/input_pose.h, otherwise true. */
bool sampler_path_push(struct sampler_path *resampler, const struct poi_sample *sample);

/* Returns the pose for tick `index` of the `tick_count` >= 1 ticks of the frame. Asserts that
 * `count` is greater than 0. */
struct poi_target sampler_path_at(const struct sampler_path *resampler, uint32_t index,
                                  uint32_t tick_count);

/* Makes the newest report the start of the next frame's path. The caller calls this function for
 * the path of each struct poi_sampler after the last tick of the frame. */
void sampler_path_end(struct sampler_path *resampler);

/* ---- Pois ---------------------------------------------------------------------------------- */

/* Report statistics of a controller, measured over one second and shown during the next second. */
struct report_pace {
    uint64_t begin_ns; /* Start time of the current second of the statistics. */
    uint64_t last_ns;  /* Arrival time of the last report. 0 means no report yet. */
    uint64_t gap_ns;   /* Longest gap between two reports in the current second. */
    uint32_t count;
    uint32_t shown_count; /* Number of reports in the last complete second. */
    uint64_t shown_gap_ns;
};

/* Sampler for the controller of one player. */
struct poi_sampler {
    struct report_pace pace;
    struct sampler_path path;
    uint64_t retry_ns;  /* Time of the next attempt to open a lost controller. */
    uint64_t newest_ns; /* Arrival time of the newest report. */
    /* Connection state of the controller (enum poi_source), never POI_SOURCE_BOT. */
    uint8_t link;
    bool has_wrist, trembles; /* Flags of the newest report; see struct poi_sample. */
    bool was_seen; /* True if the controller has sent at least one report after program start. */
    /* Arrival times of reports that no tick has used yet. */
    uint64_t waiting_ns[HAL_POI_SAMPLES_MAX];
    /* Number of entries in `waiting_ns`. If `waiting_ns` is full, the waiting times of further
     * reports are not measured. */
    uint32_t waiting_count;
};

/* Opens the controller. Returns 1 if open() returned a device fault (hal_is_fault()), otherwise
 * 0. */
uint32_t sampler_poi_open(struct poi_sampler *sampler, const struct hal_poi *device,
                          uint64_t now_ns);

/* Reads the reports that arrived after the previous frame. Tries to reopen a lost controller once
 * per second. Returns the number of faults, which are failed calls and reports with invalid
 * numbers. */
uint32_t sampler_poi_sample(struct poi_sampler *sampler, const struct hal_poi *device,
                            uint64_t now_ns);

/* Writes the pose for tick `index` of the `tick_count` >= 1 ticks of the frame that started at
 * `now_ns`. A controller that never sent a report counts as absent. A controller that stopped
 * reporting counts as lost, and its pose stays unchanged. If the reports cover much more time than
 * the ticks, the kiosk was delayed and the pose is not interpolated. The first tick then has the
 * flag `has_gap`, and the core moves the poi slowly to the new pose. */
void sampler_poi_at(const struct poi_sampler *sampler, uint32_t index, uint32_t tick_count,
                    uint64_t now_ns, struct poi_input *out);

/* Adds the waiting time of each report that no tick has used yet to the histogram `wait`. Call
 * before the first tick of the frame. */
void sampler_poi_time(struct poi_sampler *sampler, uint64_t now_ns, struct frame_timing *wait);

/* ---- Fans ---------------------------------------------------------------------------------- */

/* Sampler for one fan. A fan is a device that a player holds above the water and that casts a
 * shadow on the water. A fan device reports its position once per frame, but a frame may run
 * several ticks. Each tick gets its own position on the straight line between two reports.
 * Otherwise the shadow would stop for one tick and jump in the next, and the core would detect a
 * fast movement. */

struct fan_sampler {
    /* `from` is the fan's position at the last tick of the previous frame, and `to` is the newest
     * position from the device. The caller copies `to` to `from` after the last tick of a frame. */
    struct shade_input from, to;
    uint64_t retry_ns; /* Time of the next attempt to open a lost device. */
    /* Connection state of the device (enum poi_source), never POI_SOURCE_BOT. */
    uint8_t link;
};

/* Opens the fan device. Returns 1 if opening failed with a fault. Returns 0 on success, or if there
 * is no fan device. */
uint32_t sampler_fan_open(struct fan_sampler *sampler, const struct hal_fan *device,
                          uint64_t now_ns);

/* Reads the newest report. Tries to reopen a lost fan once per second. While a fan is lost, the fan
 * counts as absent. Rejects a report with a non-finite number or a value beyond 1,000 m. Returns
 * the number of faults. */
uint32_t sampler_fan_sample(struct fan_sampler *sampler, const struct hal_fan *device,
                            uint64_t now_ns);

/* Returns the fan's position for tick `index` of the `tick_count` >= 1 ticks of the frame. A fan
 * that was absent before appears at its position without interpolation. */
struct shade_input sampler_fan_at(const struct fan_sampler *sampler, uint32_t index,
                                  uint32_t tick_count);
