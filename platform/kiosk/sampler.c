/* sampler.c -- converts the reports of pois and fans to one pose per tick; see sampler.h. */
#include "platform/kiosk/sampler.h"

#include "core/base/panic.h"
#include "core/game/control/input_validation.h"
#include "core/poi/pose.h"

#define RETRY_NS 1000000000ull
#define NS_PER_S 1000000000ull
#define TICK_NS (NS_PER_S / CORE_TICK_HZ)
/* Limit in nanoseconds for the time between the first and the last report of a frame, in addition
 * to the time of the frame's ticks. If the limit is exceeded, the motion is not interpolated. */
#define UNSEEN_NS 100000000ull

/* Returns the enum poi_source of a device whose open() returned `result`. */
static uint8_t link_after_open(int result)
{
    return result == HAL_OK           ? POI_SOURCE_LIVE
           : result == HAL_ERR_ABSENT ? POI_SOURCE_ABSENT
                                      : POI_SOURCE_LOST;
}

uint32_t sampler_poi_open(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    const int result = device->ops->open(device->self);
    hand->retry_ns = now_ns + RETRY_NS;
    hand->link = link_after_open(result);
    return (uint32_t)hal_is_fault(result);
}

/* Tries to open a lost controller once per second. The controller stays lost until open() returns
 * HAL_OK. Returns 1 if open() failed, otherwise 0. */
static uint32_t look_for(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns)
{
    if (now_ns < hand->retry_ns) {
        return 0;
    }
    hand->retry_ns = now_ns + RETRY_NS;
    if (device->ops->open(device->self) != HAL_OK) {
        return 1;
    }
    hand->link = POI_SOURCE_LIVE;
    return 0;
}

uint32_t sampler_poi_sample(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    CORE_ASSERT(hand->path.count <= SAMPLER_PATH_MAX);
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    uint32_t faults = 0;
    /* Publishes the statistics once per second and starts the next second. The time since the
     * last report also counts as a gap. */
    if (now_ns - hand->pace.begin_ns >= NS_PER_S) {
        const uint64_t silent_ns = hand->pace.last_ns > 0 && now_ns > hand->pace.last_ns
                                       ? now_ns - hand->pace.last_ns
                                       : 0u;
        hand->pace.shown_count = hand->pace.count;
        hand->pace.shown_gap_ns = silent_ns > hand->pace.gap_ns ? silent_ns : hand->pace.gap_ns;
        hand->pace.begin_ns = now_ns;
        hand->pace.gap_ns = hand->pace.count = 0;
    }
    if (hand->link == POI_SOURCE_LOST) {
        faults += look_for(hand, device, now_ns);
    }
    if (hand->link != POI_SOURCE_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, samples, HAL_POI_SAMPLES_MAX);
    for (int i = 0; i < result; i++) {
        hand->has_wrist = samples[i].has_wrist;
        hand->trembles = samples[i].trembles;
        hand->newest_ns = samples[i].time_ns;
        hand->was_seen = 1;
        if (samples[i].was_stamped) {
            const uint64_t gap_ns =
                hand->pace.last_ns > 0 && samples[i].time_ns > hand->pace.last_ns
                    ? samples[i].time_ns - hand->pace.last_ns
                    : 0u;
            hand->pace.gap_ns = gap_ns > hand->pace.gap_ns ? gap_ns : hand->pace.gap_ns;
            hand->pace.last_ns = samples[i].time_ns;
            hand->pace.count++;
        }
        if (samples[i].was_stamped && hand->waiting_count < HAL_POI_SAMPLES_MAX) {
            hand->waiting_ns[hand->waiting_count++] = samples[i].time_ns;
        }
        faults += !sampler_path_push(&hand->path, &samples[i]);
    }
    if (result == HAL_ERR_GONE) {
        /* Marks the device as lost and clears its path of reports, because the motion until the
         * next report is unknown. */
        hand->link = POI_SOURCE_LOST;
        hand->retry_ns = now_ns + RETRY_NS;
        sampler_path_reset(&hand->path);
    }
    return faults + (uint32_t)hal_is_fault(result);
}

/* Returns the age of the newest report in ticks. A report with a time stamp in the future has age
 * 0. */
static uint16_t report_age_ticks(const struct poi_sampler *hand, uint64_t now_ns)
{
    const uint64_t age_ns = now_ns > hand->newest_ns ? now_ns - hand->newest_ns : 0;
    const uint64_t ticks = age_ns / TICK_NS;
    return ticks < UINT16_MAX ? (uint16_t)ticks : UINT16_MAX;
}

/* Returns 1 if the reports span much more time than the frame's ticks, otherwise 0. The kiosk was
 * then delayed and has dropped ticks. Interpolation would compress the motion of the whole delay
 * into the remaining ticks, faster than the player's motion. */
static int was_unseen(const struct poi_sampler *hand, uint32_t tick_count)
{
    const struct sampler_path *path = &hand->path;
    const uint64_t span_ns = path->path[path->count - 1].time_ns - path->path[0].time_ns;
    return span_ns > tick_count * TICK_NS + UNSEEN_NS;
}

void sampler_poi_at(const struct poi_sampler *hand, uint32_t index, uint32_t tick_count,
                    uint64_t now_ns, struct poi_input *out)
{
    CORE_ASSERT(index < tick_count);
    out->link = hand->link == POI_SOURCE_LIVE && hand->path.count > 0 ? POI_SOURCE_LIVE
                : hand->was_seen                                      ? POI_SOURCE_LOST
                                                                      : POI_SOURCE_ABSENT;
    out->has_wrist = hand->has_wrist;
    out->trembles = hand->trembles;
    out->age_ticks = out->link == POI_SOURCE_LIVE ? report_age_ticks(hand, now_ns) : 0u;
    if (out->link == POI_SOURCE_LIVE && was_unseen(hand, tick_count)) {
        /* Passes the motion during a delay to the core as late reports. The first tick gets the
         * old pose with the age INPUT_SILENT_TICKS, which is below the limit of input loss. Each
         * later tick gets the newest pose. */
        const struct sampler_path *path = &hand->path;
        out->target = path->path[index == 0 ? 0 : path->count - 1].target;
        out->age_ticks = index == 0 ? INPUT_SILENT_TICKS : 0u;
    } else if (hand->path.count > 0) {
        out->target = sampler_path_at(&hand->path, index, tick_count);
    }
}

void sampler_poi_time(struct poi_sampler *hand, uint64_t now_ns, struct frame_timing *wait)
{
    CORE_ASSERT(hand->waiting_count <= HAL_POI_SAMPLES_MAX);
    for (uint32_t i = 0; i < hand->waiting_count; i++) {
        const uint64_t came_ns = hand->waiting_ns[i];
        frame_timing_add(wait, now_ns > came_ns ? now_ns - came_ns : 0u);
    }
    hand->waiting_count = 0;
}

void sampler_poi_end(struct poi_sampler *hand)
{
    sampler_path_end(&hand->path);
}

/* ---- Resampling ---------------------------------------------------------------------------- */

void sampler_path_reset(struct sampler_path *resampler)
{
    resampler->count = 0;
}

int sampler_path_push(struct sampler_path *resampler, const struct poi_sample *sample)
{
    CORE_ASSERT(resampler->count <= SAMPLER_PATH_MAX);
    struct poi_sample next = *sample;
    if (resampler->count > 0) {
        const uint64_t newest_ns = resampler->path[resampler->count - 1].time_ns;
        if (next.time_ns <= newest_ns) {
            next.time_ns = newest_ns; /* The time along the path never decreases. */
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

/* Returns the pose between two reports. `t` is 0 at the first report and 1 at the second report. If
 * the second report is invalid, or if the motion between the two reports is a jump, returns the
 * pose of the first report until `t` is 1. */
static struct poi_target target_on_way(const struct poi_sample *from, const struct poi_sample *to,
                                       float t)
{
    const uint64_t gap_ns = to->time_ns - from->time_ns;
    if (!input_pose_is_finite(&from->target)) {
        return to->target;
    }
    if (!input_pose_is_finite(&to->target) ||
        input_pose_is_jump(&from->target, &to->target, (float)gap_ns * 1e-9f, to->has_wrist)) {
        return t < 1.0f ? from->target : to->target;
    }
    return pose_between(from->target, to->target, t);
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
    const uint64_t gap_ns = path[next].time_ns - from_ns; /* The gap is 0 only if all reports of the
                                                             path lie within a few nanoseconds. */
    const float t = gap_ns > 0 ? (float)(time_ns - from_ns) / (float)gap_ns : 1.0f;
    return target_on_way(&path[next - 1], &path[next], t);
}

void sampler_path_end(struct sampler_path *resampler)
{
    CORE_ASSERT(resampler->count <= SAMPLER_PATH_MAX);
    if (resampler->count > 1) {
        resampler->path[0] = resampler->path[resampler->count - 1];
        resampler->count = 1;
    }
}

/* ---- Fans ---------------------------------------------------------------------------------- */

#define RANGE_MAX_M 1000.0f

uint32_t sampler_fan_open(struct fan_sampler *hand, const struct hal_fan *device, uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    const int result = device->ops->open(device->self);
    hand->retry_ns = now_ns + RETRY_NS;
    hand->link = link_after_open(result);
    return hand->link == POI_SOURCE_LOST;
}

uint32_t sampler_fan_sample(struct fan_sampler *hand, const struct hal_fan *device, uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    struct shade_input reading = { 0 };
    uint32_t faults = 0;
    if (hand->link == POI_SOURCE_LOST && now_ns >= hand->retry_ns) {
        faults += sampler_fan_open(hand, device, now_ns);
    }
    if (hand->link != POI_SOURCE_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, &reading);
    /* A comparison with NaN is false. Therefore a report with NaN is treated as out of range. */
    if (result == HAL_OK && f_abs(reading.x_m) <= RANGE_MAX_M &&
        f_abs(reading.z_m) <= RANGE_MAX_M && f_abs(reading.radius_m) <= RANGE_MAX_M) {
        hand->to = reading;
        return faults;
    }
    if (result == HAL_ERR_GONE) {
        hand->link = POI_SOURCE_LOST;
        hand->retry_ns = now_ns + RETRY_NS;
        hand->to = (struct shade_input){ 0 };
    }
    return faults + (result != HAL_ERR_BUSY && result != HAL_ERR_ABSENT);
}

struct shade_input sampler_fan_at(const struct fan_sampler *hand, uint32_t index,
                                  uint32_t tick_count)
{
    CORE_ASSERT(index < tick_count);
    struct shade_input at = hand->to;
    const float t = (float)(index + 1) / (float)tick_count;
    if (at.present && hand->from.present && index + 1 < tick_count) {
        at.x_m = f_lerp(hand->from.x_m, at.x_m, t);
        at.z_m = f_lerp(hand->from.z_m, at.z_m, t);
        at.radius_m = f_lerp(hand->from.radius_m, at.radius_m, t);
    }
    return at;
}

void sampler_fan_end(struct fan_sampler *hand)
{
    hand->from = hand->to;
}
