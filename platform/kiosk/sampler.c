/* sampler.c -- converts the reports of pois and fans to one pose per tick; see sampler.h. */
#include "platform/kiosk/sampler.h"

#include "core/base/panic.h"
#include "core/game/control/input_pose.h"

#define RETRY_NS 1000000000ull
#define TICK_NS (NS_PER_S / CORE_TICK_HZ)
/* If the first and the last report of a frame are further apart than the time of the frame's ticks
 * plus this limit (in nanoseconds), the motion is not interpolated. */
#define UNSEEN_NS 100000000ull

/* Returns the connection state (enum poi_source) of a device whose open() returned `result`. */
static uint8_t link_after_open(int result)
{
    return result == HAL_OK           ? POI_SOURCE_LIVE
           : result == HAL_ERR_ABSENT ? POI_SOURCE_ABSENT
                                      : POI_SOURCE_LOST;
}

/* Returns the time from `from_ns` to `to_ns`, or 0 if `to_ns` is earlier. */
static uint64_t time_since_ns(uint64_t to_ns, uint64_t from_ns)
{
    return to_ns > from_ns ? to_ns - from_ns : 0;
}

uint32_t sampler_poi_open(struct poi_sampler *sampler, const struct hal_poi *device,
                          uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    const int result = device->ops->open(device->self);
    sampler->retry_ns = now_ns + RETRY_NS;
    sampler->link = link_after_open(result);
    return (uint32_t)hal_is_fault(result);
}

uint32_t sampler_poi_sample(struct poi_sampler *sampler, const struct hal_poi *device,
                            uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    CORE_ASSERT(sampler->path.count <= SAMPLER_PATH_MAX);
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    uint32_t faults = 0;
    /* Publishes the statistics once per second and starts the next second. The time since the
     * last report also counts as a gap. */
    struct report_pace *pace = &sampler->pace;
    if (now_ns - pace->begin_ns >= NS_PER_S) {
        const uint64_t silent_ns = pace->last_ns > 0 ? time_since_ns(now_ns, pace->last_ns) : 0;
        pace->shown_count = pace->count;
        pace->shown_gap_ns = silent_ns > pace->gap_ns ? silent_ns : pace->gap_ns;
        pace->begin_ns = now_ns;
        pace->gap_ns = pace->count = 0;
    }
    /* A lost controller stays lost until open() returns HAL_OK. */
    if (sampler->link == POI_SOURCE_LOST && now_ns >= sampler->retry_ns) {
        sampler->retry_ns = now_ns + RETRY_NS;
        if (device->ops->open(device->self) == HAL_OK) {
            sampler->link = POI_SOURCE_LIVE;
        } else {
            faults++;
        }
    }
    if (sampler->link != POI_SOURCE_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, samples, HAL_POI_SAMPLES_MAX);
    for (int i = 0; i < result; i++) {
        const uint64_t came_ns = samples[i].time_ns;
        sampler->has_wrist = samples[i].has_wrist;
        sampler->trembles = samples[i].trembles;
        sampler->newest_ns = came_ns;
        sampler->was_seen = true;
        if (samples[i].was_stamped) {
            const uint64_t gap_ns = pace->last_ns > 0 ? time_since_ns(came_ns, pace->last_ns) : 0;
            pace->gap_ns = gap_ns > pace->gap_ns ? gap_ns : pace->gap_ns;
            pace->last_ns = came_ns;
            pace->count++;
            if (sampler->waiting_count < HAL_POI_SAMPLES_MAX) {
                sampler->waiting_ns[sampler->waiting_count++] = came_ns;
            }
        }
        faults += !sampler_path_push(&sampler->path, &samples[i]);
    }
    if (result == HAL_ERR_GONE) {
        /* Marks the device as lost and clears its path of reports, because the motion until the
         * next report is unknown. */
        sampler->link = POI_SOURCE_LOST;
        sampler->retry_ns = now_ns + RETRY_NS;
        sampler->path.count = 0;
    }
    return faults + (uint32_t)hal_is_fault(result);
}

void sampler_poi_at(const struct poi_sampler *sampler, uint32_t index, uint32_t tick_count,
                    uint64_t now_ns, struct poi_input *out)
{
    CORE_ASSERT(index < tick_count);
    out->link = sampler->link == POI_SOURCE_LIVE && sampler->path.count > 0 ? POI_SOURCE_LIVE
                : sampler->was_seen                                         ? POI_SOURCE_LOST
                                                                            : POI_SOURCE_ABSENT;
    out->has_wrist = sampler->has_wrist;
    out->trembles = sampler->trembles;
    /* A report with a time stamp in the future has age 0. */
    const uint64_t age = time_since_ns(now_ns, sampler->newest_ns) / TICK_NS;
    out->age_ticks = out->link != POI_SOURCE_LIVE ? 0u
                     : age < UINT16_MAX           ? (uint16_t)age
                                                  : UINT16_MAX;
    /* If the reports span much more time than the frame's ticks, the kiosk was delayed and has
     * dropped ticks. Interpolation would compress the motion of the whole delay into the remaining
     * ticks, and the poi would move faster than the player did. Each tick therefore gets the newest
     * pose, and the first tick has the flag `has_gap`. */
    const struct poi_sample *path = sampler->path.path;
    const uint32_t last = sampler->path.count - 1u;
    const bool is_unseen = out->link == POI_SOURCE_LIVE &&
                           path[last].time_ns - path[0].time_ns > tick_count * TICK_NS + UNSEEN_NS;
    out->has_gap = is_unseen && index == 0;
    if (is_unseen) {
        out->target = path[last].target;
    } else if (sampler->path.count > 0) {
        out->target = sampler_path_at(&sampler->path, index, tick_count);
    }
}

void sampler_poi_time(struct poi_sampler *sampler, uint64_t now_ns, struct frame_timing *wait)
{
    CORE_ASSERT(sampler->waiting_count <= HAL_POI_SAMPLES_MAX);
    for (uint32_t i = 0; i < sampler->waiting_count; i++) {
        frame_timing_add(wait, time_since_ns(now_ns, sampler->waiting_ns[i]));
    }
    sampler->waiting_count = 0;
}

/* ---- Resampling ---------------------------------------------------------------------------- */

bool sampler_path_push(struct sampler_path *resampler, const struct poi_sample *sample)
{
    CORE_ASSERT(resampler->count <= SAMPLER_PATH_MAX);
    struct poi_sample next = *sample;
    if (resampler->count > 0) {
        const uint64_t newest_ns = resampler->path[resampler->count - 1u].time_ns;
        if (next.time_ns <= newest_ns) {
            /* A report that is out of order gets the time of the newest report, so that the times
             * along the path never decrease. */
            next.time_ns = newest_ns;
            resampler->count -= resampler->count > 1;
        }
    }
    if (resampler->count == SAMPLER_PATH_MAX) {
        for (uint32_t i = 2; i < resampler->count; i++) {
            resampler->path[i - 1] = resampler->path[i];
        }
        resampler->count--;
    }
    resampler->path[resampler->count++] = next;
    return input_pose_is_finite(&next.target);
}

struct poi_target sampler_path_at(const struct sampler_path *resampler, uint32_t index,
                                  uint32_t tick_count)
{
    CORE_ASSERT(resampler->count > 0);
    CORE_ASSERT(index < tick_count);
    const struct poi_sample *path = resampler->path;
    const uint32_t last = resampler->count - 1;
    const uint64_t begin_ns = path[0].time_ns;
    if (index + 1 == tick_count || path[last].time_ns <= begin_ns) {
        return path[last].target;
    }
    const uint64_t span_ns = path[last].time_ns - begin_ns;
    const uint64_t time_ns = begin_ns + span_ns * (index + 1) / tick_count;
    uint32_t next = 1;
    while (next < last && path[next].time_ns < time_ns) {
        next++;
    }
    const uint64_t from_ns = path[next - 1].time_ns;
    /* `gap_ns` is 0 only if all reports of the path lie within a few nanoseconds. */
    const uint64_t gap_ns = path[next].time_ns - from_ns;
    const float t = gap_ns > 0 ? (float)(time_ns - from_ns) / (float)gap_ns : 1.0f;
    return input_pose_between(&path[next - 1].target, &path[next].target, t, (float)gap_ns * 1e-9f,
                              path[next].has_wrist);
}

void sampler_path_end(struct sampler_path *resampler)
{
    CORE_ASSERT(resampler->count <= SAMPLER_PATH_MAX);
    if (resampler->count > 1) {
        resampler->path[0] = resampler->path[resampler->count - 1u];
        resampler->count = 1;
    }
}

/* ---- Fans ---------------------------------------------------------------------------------- */

#define RANGE_MAX_M 1000.0f

uint32_t sampler_fan_open(struct fan_sampler *sampler, const struct hal_fan *device,
                          uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    const int result = device->ops->open(device->self);
    sampler->retry_ns = now_ns + RETRY_NS;
    sampler->link = link_after_open(result);
    return sampler->link == POI_SOURCE_LOST;
}

uint32_t sampler_fan_sample(struct fan_sampler *sampler, const struct hal_fan *device,
                            uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    struct shade_input reading = { 0 };
    uint32_t faults = 0;
    if (sampler->link == POI_SOURCE_LOST && now_ns >= sampler->retry_ns) {
        faults += sampler_fan_open(sampler, device, now_ns);
    }
    if (sampler->link != POI_SOURCE_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, &reading);
    /* A comparison with NaN is false. Therefore a report with NaN is treated as out of range. */
    if (result == HAL_OK && f_abs(reading.x_m) <= RANGE_MAX_M &&
        f_abs(reading.z_m) <= RANGE_MAX_M && f_abs(reading.radius_m) <= RANGE_MAX_M) {
        sampler->to = reading;
        return faults;
    }
    if (result == HAL_ERR_GONE) {
        sampler->link = POI_SOURCE_LOST;
        sampler->retry_ns = now_ns + RETRY_NS;
        sampler->to = (struct shade_input){ 0 };
    }
    return faults + (result != HAL_ERR_BUSY && result != HAL_ERR_ABSENT);
}

struct shade_input sampler_fan_at(const struct fan_sampler *sampler, uint32_t index,
                                  uint32_t tick_count)
{
    CORE_ASSERT(index < tick_count);
    struct shade_input at = sampler->to;
    const float t = (float)(index + 1) / (float)tick_count;
    if (at.present && sampler->from.present && index + 1 < tick_count) {
        at.x_m = f_lerp(sampler->from.x_m, at.x_m, t);
        at.z_m = f_lerp(sampler->from.z_m, at.z_m, t);
        at.radius_m = f_lerp(sampler->from.radius_m, at.radius_m, t);
    }
    return at;
}
