/* resample.c -- computes the poses of ticks at equal time steps on the path of reports; see
 * resample.h. */
#include "platform/kiosk/resample.h"

#include "core/base/panic.h"
#include "core/game/control/input_validation.h"
#include "core/poi/pose.h"

void resample_reset(struct resampler *resampler)
{
    resampler->count = 0;
}

static void drop_second(struct resampler *resampler)
{
    for (uint32_t i = 2; i < resampler->count; i++) {
        resampler->path[i - 1] = resampler->path[i];
    }
    resampler->count--;
}

int resample_push(struct resampler *resampler, const struct poi_sample *sample)
{
    struct poi_sample next = *sample;
    if (resampler->count > 0) {
        const uint64_t newest_ns = resampler->path[resampler->count - 1].time_ns;
        if (next.time_ns <= newest_ns) {
            next.time_ns = newest_ns; /* The time along the path never decreases. */
            resampler->count -= resampler->count > 1;
        }
    }
    if (resampler->count == RESAMPLE_MAX) {
        drop_second(resampler);
    }
    resampler->path[resampler->count++] = next;
    return input_pose_is_finite(&next.target);
}

/* Returns the pose between two reports. `t` is 0 at the first report and 1 at the second report.
 * Before a jump or an invalid second report, returns the pose of the first report until t = 1. */
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

struct poi_target resample_at(const struct resampler *resampler, uint32_t index,
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
    const uint64_t gap_ns = path[next].time_ns - from_ns; /* The gap is 0 only if the reports of the
                                                             whole path lie within a few
                                                             nanoseconds. */
    const float t = gap_ns > 0 ? (float)(time_ns - from_ns) / (float)gap_ns : 1.0f;
    return target_on_way(&path[next - 1], &path[next], t);
}

void resample_end(struct resampler *resampler)
{
    if (resampler->count > 1) {
        resampler->path[0] = resampler->path[resampler->count - 1];
        resampler->count = 1;
    }
}
