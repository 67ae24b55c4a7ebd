/* poi_sampler.c -- converts the reports of a device to one pose per tick; see poi_sampler.h. */
#include "platform/kiosk/poi_sampler.h"

#include "core/game/control/input_validation.h"

#define RETRY_NS 1000000000ull
#define NS_PER_S 1000000000ull
#define TICK_NS (NS_PER_S / CORE_TICK_HZ)
/* Time in nanoseconds by which the reports may span more than the frame's ticks. If the reports
 * span more, their motion is not interpolated. */
#define UNSEEN_NS 100000000ull

uint32_t poi_sampler_open(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns)
{
    const int result = device->ops->open(device->self);
    hand->retry_ns = now_ns + RETRY_NS;
    hand->link = result == HAL_OK           ? POI_SOURCE_LIVE
                 : result == HAL_ERR_ABSENT ? POI_SOURCE_ABSENT
                                            : POI_SOURCE_LOST;
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

/* Marks the device as lost and clears its path, because the motion until the next report is
 * unknown. */
static void lose(struct poi_sampler *hand, uint64_t now_ns)
{
    hand->link = POI_SOURCE_LOST;
    hand->retry_ns = now_ns + RETRY_NS;
    resample_reset(&hand->path);
}

/* Counts one report and updates the longest gap between reports. */
static void count_report(struct report_pace *pace, uint64_t time_ns)
{
    const uint64_t gap_ns =
        pace->last_ns > 0 && time_ns > pace->last_ns ? time_ns - pace->last_ns : 0u;
    pace->gap_ns = gap_ns > pace->gap_ns ? gap_ns : pace->gap_ns;
    pace->last_ns = time_ns;
    pace->count++;
}

/* Publishes the statistics once per second and starts the next second. The time since the last
 * report also counts as a gap. */
static void turn_second(struct report_pace *pace, uint64_t now_ns)
{
    if (now_ns - pace->begin_ns < NS_PER_S) {
        return;
    }
    const uint64_t silent_ns =
        pace->last_ns > 0 && now_ns > pace->last_ns ? now_ns - pace->last_ns : 0u;
    pace->shown_count = pace->count;
    pace->shown_gap_ns = silent_ns > pace->gap_ns ? silent_ns : pace->gap_ns;
    pace->begin_ns = now_ns;
    pace->gap_ns = pace->count = 0;
}

static uint32_t poi_sampler_push(struct poi_sampler *hand, const struct poi_sample *sample)
{
    hand->has_wrist = sample->has_wrist;
    hand->trembles = sample->trembles;
    hand->newest_ns = sample->time_ns;
    hand->was_seen = 1;
    if (sample->was_stamped) {
        count_report(&hand->pace, sample->time_ns);
    }
    if (sample->was_stamped && hand->waiting_count < HAL_POI_SAMPLES_MAX) {
        hand->waiting_ns[hand->waiting_count++] = sample->time_ns;
    }
    return !resample_push(&hand->path, sample);
}

uint32_t poi_sampler_sample(struct poi_sampler *hand, const struct hal_poi *device, uint64_t now_ns)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    uint32_t faults = 0;
    turn_second(&hand->pace, now_ns);
    if (hand->link == POI_SOURCE_LOST) {
        faults += look_for(hand, device, now_ns);
    }
    if (hand->link != POI_SOURCE_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, samples, HAL_POI_SAMPLES_MAX);
    for (int i = 0; i < result; i++) {
        faults += poi_sampler_push(hand, &samples[i]);
    }
    if (result == HAL_ERR_GONE) {
        lose(hand, now_ns);
    }
    return faults + (uint32_t)hal_is_fault(result);
}

static uint8_t link_of(const struct poi_sampler *hand)
{
    if (hand->link == POI_SOURCE_LIVE && hand->path.count > 0) {
        return POI_SOURCE_LIVE;
    }
    return hand->was_seen ? POI_SOURCE_LOST : POI_SOURCE_ABSENT;
}

/* Returns the age of the newest report in ticks. A report with a time stamp in the future has age
 * 0. */
static uint16_t age_ticks(const struct poi_sampler *hand, uint64_t now_ns)
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
    const struct resampler *path = &hand->path;
    const uint64_t span_ns = path->path[path->count - 1].time_ns - path->path[0].time_ns;
    return span_ns > tick_count * TICK_NS + UNSEEN_NS;
}

/* Passes the motion during a delay to the core as late reports. The first tick gets the old pose
 * with the age INPUT_SILENT_TICKS, which is below the limit of input loss. Each later tick gets the
 * newest pose. */
static void pass_over(const struct poi_sampler *hand, uint32_t index, struct poi_input *out)
{
    const struct resampler *path = &hand->path;
    out->target = path->path[index == 0 ? 0 : path->count - 1].target;
    out->age_ticks = index == 0 ? INPUT_SILENT_TICKS : 0u;
}

void poi_sampler_at(const struct poi_sampler *hand, uint32_t index, uint32_t tick_count,
                    uint64_t now_ns, struct poi_input *out)
{
    out->link = link_of(hand);
    out->has_wrist = hand->has_wrist;
    out->trembles = hand->trembles;
    out->age_ticks = out->link == POI_SOURCE_LIVE ? age_ticks(hand, now_ns) : 0u;
    if (out->link == POI_SOURCE_LIVE && was_unseen(hand, tick_count)) {
        pass_over(hand, index, out);
    } else if (hand->path.count > 0) {
        out->target = resample_at(&hand->path, index, tick_count);
    }
}

void poi_sampler_time(struct poi_sampler *hand, uint64_t now_ns, struct timing *wait)
{
    for (uint32_t i = 0; i < hand->waiting_count; i++) {
        const uint64_t came_ns = hand->waiting_ns[i];
        timing_add(wait, now_ns > came_ns ? now_ns - came_ns : 0u);
    }
    hand->waiting_count = 0;
}

void poi_sampler_end(struct poi_sampler *hand)
{
    resample_end(&hand->path);
}
