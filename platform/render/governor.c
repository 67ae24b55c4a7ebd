/* governor.c -- implementation of governor.h. */
#include "platform/render/governor.h"

#include "platform/render/quality.h"

#define NS_PER_S 1000000000ull
#define STALL_NS (NS_PER_S / 4u)
/* Number of consecutive stalls after which slow drawing is assumed to be their cause. */
#define STALLS 3u
#define HZ 60u
/* Limit of the mean frame duration, in per cent of a refresh period. At the limit, one frame in
 * nine is late by one refresh period. */
#define LATE_PERCENT 111u
/* Number of seconds without late frames after which the trial of a finer step has succeeded. */
#define HELD_S 60u

void governor_begin(struct governor *governor, uint32_t refresh_hz)
{
    const uint32_t hz = refresh_hz == 0 || refresh_hz > HZ ? HZ : refresh_hz;
    *governor = (struct governor){ .turn_ns = NS_PER_S / hz, .patience_s = GOVERNOR_PATIENCE_S };
}

static void be_late(struct governor *governor)
{
    if (governor->is_trying && governor->patience_s < GOVERNOR_PATIENCE_MAX_S) {
        governor->patience_s *= 2u;
    }
    governor->is_trying = 0;
    governor->timely_s = 0;
    if (governor->step < QUALITY_STEP_MAX) {
        governor->step++;
    }
}

static void be_timely(struct governor *governor, bool may_refine)
{
    governor->timely_s += GOVERNOR_LOOK_S;
    if (governor->is_trying && governor->timely_s >= HELD_S) {
        governor->is_trying = 0;
        governor->patience_s = GOVERNOR_PATIENCE_S;
    }
    if (governor->step > 0 && governor->timely_s >= governor->patience_s && may_refine) {
        governor->step--;
        governor->is_trying = 1;
        governor->timely_s = 0;
    }
}

static void governor_adjust_quality(struct governor *governor, bool may_refine)
{
    const uint64_t mean_ns = governor->sum_ns / governor->count;
    governor->sum_ns = governor->count = 0;
    if (mean_ns * 100u > governor->turn_ns * LATE_PERCENT) {
        be_late(governor);
    } else {
        be_timely(governor, may_refine);
    }
}

uint32_t governor_frame(struct governor *governor, uint64_t now_ns, bool may_refine)
{
    const uint64_t frame_ns = now_ns - governor->last_ns;
    governor->stalls = frame_ns < STALL_NS ? 0 : governor->stalls + 1u;
    const bool is_drawing = governor->stalls == 0 || governor->stalls >= STALLS;
    const bool counts = governor->last_ns > 0 && is_drawing;
    governor->last_ns = now_ns;
    if (counts) {
        governor->sum_ns += frame_ns;
        governor->count++;
    }
    if (governor->sum_ns >= GOVERNOR_LOOK_S * NS_PER_S) {
        governor_adjust_quality(governor, may_refine);
    }
    return governor->step > governor->heat ? governor->step : governor->heat;
}

void governor_set_temperature(struct governor *governor, int32_t margin_mdeg)
{
    if (margin_mdeg < GOVERNOR_HOT_MDEG && governor->heat < QUALITY_STEP_MAX) {
        governor->heat++;
    } else if (margin_mdeg > GOVERNOR_COOL_MDEG && governor->heat > 0) {
        governor->heat--;
    }
}
