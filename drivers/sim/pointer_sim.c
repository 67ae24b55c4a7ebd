/* pointer_sim.c -- implements the simulated mouse and the simulated touch screen. */
#include "drivers/sim/pointer_sim.h"

#include "core/base/panic.h"

#define POINTER_STREAM 79u
#define TOUCH_STREAM 89u

void pointer_sim_init(struct pointer_sim *sim, struct hal_clock clock, const struct view *view)
{
    CORE_ASSERT(view);
    *sim = (struct pointer_sim){ .feed = report_feed_begin(clock) };
    pointer_poi_init(&sim->pointer, view);
}

void pointer_sim_init_touch(struct pointer_sim *sim, struct hal_clock clock,
                            const struct view *view, uint32_t width, uint32_t height)
{
    CORE_ASSERT(width > 0 && height > 0);
    pointer_sim_init(sim, clock, view);
    sim->is_touch = true;
    sim->report = (struct pointer_report){
        .x_px = 0.5f * (float)width,
        .y_px = 0.5f * (float)height,
        .width_px = width,
        .height_px = height,
    };
}

/* Opens a touch screen without fingers, because the fingers from before unplugging are unknown. */
static int pointer_sim_open(void *self)
{
    struct pointer_sim *sim = self;
    const int result = report_feed_open(&sim->feed);
    if (result > 0) {
        sim->fingers = (struct touch_fingers){ 0 };
    }
    return result < 0 ? HAL_ERR_GONE : HAL_OK;
}

/* Returns a report of the mouse with its faults. If the report has random numbers (`is_random`),
 * the number `x_px` is NaN in every fourth such report. */
static struct pointer_report mouse_report(struct pointer_sim *sim, const struct report_fault *fault)
{
    CORE_ASSERT(fault->index < sim->feed.count);
    struct pointer_report report = sim->reports[fault->index];
    if (fault->jumps) {
        report.x_px = (float)report.width_px;
        report.y_px = 0.0f;
    }
    if (fault->is_random) {
        const uint32_t index = sim->random_count++;
        report.x_px = index % 4u ? report_feed_random_float(POINTER_STREAM, index, 0) : 0.0f / 0.0f;
        report.y_px = report_feed_random_float(POINTER_STREAM, index, 1);
        report.wheel_notches = report_feed_random_float(POINTER_STREAM, index, 2);
        report.buttons = report_feed_random(POINTER_STREAM, index, 3);
        report.width_px = index % 3u ? report.width_px : 0u;
    }
    return report;
}

/* Passes the next finger event, with its faults, to the finger tracking of the touch screen.
 * Returns the resulting pointer report. */
static struct pointer_report touch_report(struct pointer_sim *sim, const struct report_fault *fault)
{
    CORE_ASSERT(fault->index < sim->feed.count && fault->copies <= 2u);
    struct touch_event event = sim->events[fault->index];
    const bool is_mute =
        sim->mute_every > 0 && fault->index % sim->mute_every == 0 && event.kind == TOUCH_UP;
    if (fault->jumps) {
        event.x = 1.0f;
        event.y = 0.0f;
    }
    if (fault->is_random) {
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
    return sim->report;
}

/* Plays all reports that are due. The last sample is at the current time, because a dip continues
 * between reports and a resting pointer is still valid. */
static int pointer_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct pointer_sim *sim = self;
    const void *reports = sim->is_touch ? (const void *)sim->events : sim->reports;
    const size_t size = sim->is_touch ? sizeof *sim->events : sizeof *sim->reports;
    struct report_fault fault;
    uint32_t count = 0;
    int result;
    CORE_ASSERT(out && max > 0);
    while ((result = report_feed_take(&sim->feed, reports, size, &fault)) > 0) {
        const struct pointer_report report =
            sim->is_touch ? touch_report(sim, &fault) : mouse_report(sim, &fault);
        for (uint32_t i = 0; i < (sim->is_touch ? 1u : fault.copies); i++) {
            if (pointer_poi_report(&sim->pointer, &report) && count + 1 < max) {
                out[count++] = (struct poi_sample){
                    .time_ns = report.time_ns,
                    .target = pointer_poi_target(&sim->pointer, report.time_ns),
                };
            }
        }
    }
    if (result < 0) {
        return result == HAL_ERR_BUSY ? 0 : result;
    }
    const uint64_t now_ns = hal_now_ns(sim->feed.clock);
    out[count++] = (struct poi_sample){
        .time_ns = now_ns,
        .target = pointer_poi_target(&sim->pointer, now_ns),
    };
    return (int)count;
}

static void pointer_sim_set_view(void *self, const struct view *view,
                                 const struct display_settings *display_settings, bool scoops)
{
    struct pointer_sim *sim = self;
    CORE_ASSERT(view);
    /* `display_settings` is unused, because the simulated image fills the window. */
    (void)display_settings;
    sim->pointer.view = *view;
    sim->pointer.dip.scoops = scoops;
}

/* A touch screen has no force feedback. */
static int pointer_sim_set_force(void *self, const struct poi_force *force)
{
    struct pointer_sim *sim = self;
    CORE_ASSERT(force);
    sim->felt = *force;
    return sim->is_touch ? HAL_ERR_ABSENT : sim->feed.gone ? HAL_ERR_GONE : (int)HAL_OK;
}

static const char *pointer_sim_describe(void *self)
{
    const struct pointer_sim *sim = self;
    return sim->is_touch ? "simulated touch screen" : "simulated mouse";
}

static int fan_poll(void *self, struct shade_input *out)
{
    struct pointer_sim *sim = self;
    if (sim->feed.gone) {
        return HAL_ERR_GONE;
    }
    *out = pointer_fan_shade(&sim->pointer, hal_now_ns(sim->feed.clock));
    return HAL_OK;
}

struct hal_controller_devices pointer_sim_devices(struct pointer_sim *sim)
{
    static const struct hal_poi_ops poi = {
        .open = pointer_sim_open,
        .poll = pointer_sim_poll,
        .set_force = pointer_sim_set_force,
        .set_view = pointer_sim_set_view,
        .describe = pointer_sim_describe,
    };
    static const struct hal_fan_ops fan = {
        .open = report_feed_fan_open,
        .poll = fan_poll,
        .describe = pointer_sim_describe,
    };
    CORE_ASSERT(sim);
    return (struct hal_controller_devices){ .poi = { &poi, sim }, .fan = { &fan, sim } };
}
