/* pointer_sim.c -- implements the simulated mouse. */
#include "drivers/sim/pointer_sim.h"

#include <string.h>

#include "core/base/rng.h"

void pointer_sim_init(struct pointer_sim *sim, struct hal_clock clock, const struct view *view)
{
    *sim = (struct pointer_sim){
        .clock = clock,
        .unplug_at = POINTER_SIM_NEVER,
        .jump_at = POINTER_SIM_NEVER,
    };
    pointer_poi_init(&sim->pointer, view);
    pointer_fan_init(&sim->fan, view);
}

static uint64_t pointer_sim_now_ns(const struct pointer_sim *sim)
{
    return sim->clock.ops->now_ns(sim->clock.self);
}

static int poi_sim_open(void *self)
{
    struct pointer_sim *sim = self;
    sim->open_count++;
    if (sim->gone && pointer_sim_now_ns(sim) >= sim->replug_ns) {
        sim->gone = 0;
        sim->unplug_at = POINTER_SIM_NEVER;
    }
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static struct poi_sample sample_now(struct pointer_sim *sim, uint64_t time_ns)
{
    return (struct poi_sample){
        .time_ns = time_ns,
        .target = pointer_poi_target(&sim->pointer, time_ns),
    };
}

static float any_bits(uint32_t index, uint32_t what)
{
    const uint32_t bits = rng_u32((struct rng_key){ 79, index, what, RNG_TEST });
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Fills a report with random numbers; every fourth report contains a NaN. */
static void spoil(struct pointer_report *report, uint32_t index)
{
    report->x_px = index % 4u ? any_bits(index, 0) : 0.0f / 0.0f;
    report->y_px = any_bits(index, 1);
    report->wheel_notches = any_bits(index, 2);
    report->buttons = rng_u32((struct rng_key){ 79, index, 3, RNG_TEST });
    report->width_px = index % 3u ? report->width_px : 0u;
}

static struct pointer_report take_report(struct pointer_sim *sim)
{
    struct pointer_report report = sim->reports[sim->next];
    if (sim->next == sim->jump_at) {
        report.x_px = (float)report.width_px;
        report.y_px = 0.0f;
    }
    if (sim->next >= sim->spoil_from && sim->next < sim->spoil_to) {
        spoil(&report, sim->spoil_count++);
    }
    sim->next++;
    return report;
}

/* Plays all reports that are due. The last sample is at the current time, because a dip continues
 * between reports and a resting pointer is still valid. */
static int poi_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct pointer_sim *sim = self;
    const uint64_t now_ns = pointer_sim_now_ns(sim);
    uint32_t count = 0;
    if (sim->gone) {
        return HAL_ERR_GONE;
    }
    if (now_ns >= sim->silent_from_ns && now_ns < sim->silent_to_ns) {
        return 0;
    }
    while (sim->next < sim->report_count && sim->reports[sim->next].time_ns <= now_ns) {
        if (sim->next >= sim->unplug_at) {
            sim->gone = 1;
            return HAL_ERR_GONE;
        }
        const uint32_t index = sim->next;
        const struct pointer_report report = take_report(sim);
        const int twice = sim->double_every > 0 && index % sim->double_every == 0;
        for (int i = 0; i <= twice; i++) {
            pointer_fan_report(&sim->fan, &report);
            if (pointer_poi_report(&sim->pointer, &report) && count + 1 < max) {
                out[count++] = sample_now(sim, report.time_ns);
            }
        }
    }
    if (count < max) {
        out[count++] = sample_now(sim, now_ns);
    }
    return (int)count;
}

static void poi_sim_set_view(void *self, const struct view *view,
                             const struct display_settings *display_settings)
{
    struct pointer_sim *sim = self;
    (void)display_settings; /* Unused, because the simulated image fills the window. */
    sim->pointer.view = sim->fan.view = *view;
}

static int poi_sim_set_force(void *self, const struct poi_force *force)
{
    struct pointer_sim *sim = self;
    sim->felt = *force;
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static const char *poi_sim_describe(void *self)
{
    (void)self;
    return "simulated mouse";
}

static int pointer_sim_fan_open(void *self)
{
    const struct pointer_sim *sim = self;
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static int pointer_sim_fan_poll(void *self, struct shade_input *out)
{
    struct pointer_sim *sim = self;
    if (sim->gone) {
        return HAL_ERR_GONE;
    }
    *out = pointer_fan_shade(&sim->fan, pointer_sim_now_ns(sim));
    return HAL_OK;
}

static const char *pointer_sim_fan_describe(void *self)
{
    (void)self;
    return "simulated fan";
}

struct hal_fan pointer_sim_fan(struct pointer_sim *sim)
{
    static const struct hal_fan_ops ops = {
        .open = pointer_sim_fan_open,
        .poll = pointer_sim_fan_poll,
        .describe = pointer_sim_fan_describe,
    };
    return (struct hal_fan){ .ops = &ops, .self = sim };
}

struct hal_poi pointer_sim_device(struct pointer_sim *sim)
{
    static const struct hal_poi_ops ops = {
        .open = poi_sim_open,
        .poll = poi_sim_poll,
        .set_force = poi_sim_set_force,
        .set_view = poi_sim_set_view,
        .describe = poi_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}
