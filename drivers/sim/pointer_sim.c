/* pointer_sim.c -- implements the simulated mouse and the simulated touch screen. */
#include "drivers/sim/pointer_sim.h"

#include "core/base/panic.h"

static struct poi_sample pointer_sample(struct pointer_poi *pointer, uint64_t time_ns)
{
    return (struct poi_sample){
        .time_ns = time_ns,
        .target = pointer_poi_target(pointer, time_ns),
    };
}

/* ---- Mouse ----------------------------------------------------------------------------------- */

#define POINTER_STREAM 79u

void pointer_sim_init(struct pointer_sim *sim, struct hal_clock clock, const struct view *view)
{
    CORE_ASSERT(view);
    *sim = (struct pointer_sim){ .feed = report_feed_begin(clock) };
    pointer_poi_init(&sim->pointer, view);
    pointer_fan_init(&sim->fan, view);
}

static int pointer_sim_open(void *self)
{
    struct pointer_sim *sim = self;
    return report_feed_open(&sim->feed) < 0 ? HAL_ERR_GONE : HAL_OK;
}

/* Returns the next report with its faults. Every fourth report with random numbers has a NaN. */
static struct pointer_report faulty_report(struct pointer_sim *sim,
                                           const struct report_fault *fault)
{
    CORE_ASSERT(fault->index < sim->feed.count);
    struct pointer_report report = sim->reports[fault->index];
    if (fault->jumps) {
        report.x_px = (float)report.width_px;
        report.y_px = 0.0f;
    }
    if (fault->spoils) {
        const uint32_t index = sim->spoil_count++;
        report.x_px = index % 4u ? report_feed_random_float(POINTER_STREAM, index, 0) : 0.0f / 0.0f;
        report.y_px = report_feed_random_float(POINTER_STREAM, index, 1);
        report.wheel_notches = report_feed_random_float(POINTER_STREAM, index, 2);
        report.buttons = report_feed_random(POINTER_STREAM, index, 3);
        report.width_px = index % 3u ? report.width_px : 0u;
    }
    return report;
}

/* Plays all reports that are due. The last sample is at the current time, because a dip continues
 * between reports and a resting pointer is still valid. */
static int pointer_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct pointer_sim *sim = self;
    CORE_ASSERT(sim->feed.next <= sim->feed.count && (sim->reports || sim->feed.count == 0));
    struct report_feed *feed = &sim->feed;
    const uint64_t now_ns = report_feed_now_ns(feed);
    uint32_t count = 0;
    if (feed->gone || report_feed_is_silent(feed, now_ns)) {
        return feed->gone ? HAL_ERR_GONE : 0;
    }
    while (feed->next < feed->count && sim->reports[feed->next].time_ns <= now_ns) {
        struct report_fault fault;
        if (!report_feed_take(feed, &fault)) {
            return HAL_ERR_GONE;
        }
        const struct pointer_report report = faulty_report(sim, &fault);
        for (uint32_t i = 0; i < fault.copies; i++) {
            pointer_fan_report(&sim->fan, &report);
            if (pointer_poi_report(&sim->pointer, &report) && count + 1 < max) {
                out[count++] = pointer_sample(&sim->pointer, report.time_ns);
            }
        }
    }
    if (count < max) {
        out[count++] = pointer_sample(&sim->pointer, now_ns);
    }
    return (int)count;
}

static void pointer_sim_set_view(void *self, const struct view *view,
                                 const struct display_settings *display_settings)
{
    struct pointer_sim *sim = self;
    CORE_ASSERT(view);
    (void)display_settings; /* Unused, because the simulated image fills the window. */
    sim->pointer.view = sim->fan.view = *view;
}

static int pointer_sim_set_force(void *self, const struct poi_force *force)
{
    struct pointer_sim *sim = self;
    CORE_ASSERT(force);
    sim->felt = *force;
    return sim->feed.gone ? HAL_ERR_GONE : HAL_OK;
}

static const char *pointer_sim_describe(void *self)
{
    (void)self;
    return "simulated mouse";
}

struct hal_poi pointer_sim_device(struct pointer_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_poi_ops ops = {
        .open = pointer_sim_open,
        .poll = pointer_sim_poll,
        .set_force = pointer_sim_set_force,
        .set_view = pointer_sim_set_view,
        .describe = pointer_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}

static int pointer_fan_sim_poll(void *self, struct shade_input *out)
{
    struct pointer_sim *sim = self;
    if (sim->feed.gone) {
        return HAL_ERR_GONE;
    }
    *out = pointer_fan_shade(&sim->fan, report_feed_now_ns(&sim->feed));
    return HAL_OK;
}

static const char *pointer_fan_sim_describe(void *self)
{
    (void)self;
    return "simulated fan";
}

struct hal_fan pointer_sim_fan(struct pointer_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_fan_ops ops = {
        .open = report_feed_fan_open,
        .poll = pointer_fan_sim_poll,
        .describe = pointer_fan_sim_describe,
    };
    return (struct hal_fan){ .ops = &ops, .self = sim };
}

/* ---- Touch screen ---------------------------------------------------------------------------- */

#define TOUCH_STREAM 89u

void sim_touch_init(struct touch_sim *sim, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height)
{
    CORE_ASSERT(width > 0 && height > 0);
    *sim = (struct touch_sim){
        .feed = report_feed_begin(clock),
        .report = { .width_px = width, .height_px = height },
    };
    sim->report.x_px = 0.5f * (float)width;
    sim->report.y_px = 0.5f * (float)height;
    pointer_poi_init(&sim->pointer, view);
}

/* Opens the screen without fingers, because the fingers from before unplugging are unknown. */
static int touch_sim_open(void *self)
{
    struct touch_sim *sim = self;
    const int result = report_feed_open(&sim->feed);
    if (result > 0) {
        sim->fingers = (struct touch_fingers){ 0 };
    }
    return result < 0 ? HAL_ERR_GONE : HAL_OK;
}

/* Passes an event with its faults to the decoder. */
static void play_event(struct touch_sim *sim, const struct report_fault *fault)
{
    CORE_ASSERT(fault->index < sim->feed.count && fault->copies <= 2u);
    struct touch_event event = sim->events[fault->index];
    const bool is_mute =
        sim->mute_every > 0 && fault->index % sim->mute_every == 0 && event.kind == TOUCH_UP;
    if (fault->jumps) {
        event.x = 1.0f;
        event.y = 0.0f;
    }
    if (fault->spoils) {
        event.x = report_feed_random_float(TOUCH_STREAM, fault->index, 0);
        event.y = report_feed_random_float(TOUCH_STREAM, fault->index, 1);
        event.kind = (uint8_t)report_feed_random(TOUCH_STREAM, fault->index, 2);
        event.id = (int64_t)report_feed_random(TOUCH_STREAM, fault->index, 3) % 16;
    }
    for (uint32_t i = 0; i < fault->copies && !is_mute; i++) {
        touch_fingers_take(&sim->fingers, &event);
    }
    touch_fingers_point(&sim->fingers, &sim->report);
    sim->report.time_ns = event.time_ns;
    pointer_poi_report(&sim->pointer, &sim->report);
}

static int touch_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct touch_sim *sim = self;
    CORE_ASSERT(sim->feed.next <= sim->feed.count && (sim->events || sim->feed.count == 0));
    struct report_feed *feed = &sim->feed;
    const uint64_t now_ns = report_feed_now_ns(feed);
    uint32_t count = 0;
    if (feed->gone || report_feed_is_silent(feed, now_ns)) {
        return feed->gone ? HAL_ERR_GONE : 0;
    }
    while (feed->next < feed->count && sim->events[feed->next].time_ns <= now_ns) {
        struct report_fault fault;
        if (!report_feed_take(feed, &fault)) {
            return HAL_ERR_GONE;
        }
        play_event(sim, &fault);
        if (count + 1u < max) {
            out[count++] = pointer_sample(&sim->pointer, sim->report.time_ns);
        }
    }
    if (count < max) {
        out[count++] = pointer_sample(&sim->pointer, now_ns);
    }
    return (int)count;
}

static void touch_sim_set_view(void *self, const struct view *view,
                               const struct display_settings *display_settings)
{
    struct touch_sim *sim = self;
    CORE_ASSERT(view);
    (void)display_settings; /* Unused, because the simulated image fills the window. */
    sim->pointer.view = *view;
}

static int touch_sim_set_force(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_ERR_ABSENT; /* A touch screen has no force feedback. */
}

static const char *touch_sim_describe(void *self)
{
    (void)self;
    return "simulated touch screen";
}

struct hal_poi sim_touch_device(struct touch_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_poi_ops ops = {
        .open = touch_sim_open,
        .poll = touch_sim_poll,
        .set_force = touch_sim_set_force,
        .set_view = touch_sim_set_view,
        .describe = touch_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}
