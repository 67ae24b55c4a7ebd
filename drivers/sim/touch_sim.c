/* touch_sim.c -- implements the simulated touch screen. */
#include "drivers/sim/touch_sim.h"

#include <string.h>

#include "core/base/rng.h"

void touch_sim_init(struct touch_sim *sim, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height)
{
    *sim = (struct touch_sim){
        .clock = clock,
        .unplug_at = TOUCH_SIM_NEVER,
        .jump_at = TOUCH_SIM_NEVER,
        .report = { .width_px = width, .height_px = height },
    };
    sim->report.x_px = 0.5f * (float)width;
    sim->report.y_px = 0.5f * (float)height;
    pointer_poi_init(&sim->pointer, view);
}

static uint64_t touch_sim_now_ns(const struct touch_sim *sim)
{
    return sim->clock.ops->now_ns(sim->clock.self);
}

/* Opens the screen without fingers, because the fingers from before unplugging are unknown. */
static int touch_sim_open(void *self)
{
    struct touch_sim *sim = self;
    sim->open_count++;
    if (sim->gone && touch_sim_now_ns(sim) >= sim->replug_ns) {
        sim->gone = 0;
        sim->unplug_at = TOUCH_SIM_NEVER;
        sim->fingers = (struct touch_fingers){ 0 };
    }
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static uint32_t any_bits(uint32_t index, uint32_t what)
{
    return rng_u32((struct rng_key){ 89, index, what, RNG_TEST });
}

static void spoil(struct touch_event *event, uint32_t index)
{
    const uint32_t x = any_bits(index, 0);
    const uint32_t y = any_bits(index, 1);
    memcpy(&event->x, &x, sizeof event->x);
    memcpy(&event->y, &y, sizeof event->y);
    event->kind = (uint8_t)any_bits(index, 2);
    event->id = (int64_t)any_bits(index, 3) % 16;
}

static struct touch_event next_event(struct touch_sim *sim)
{
    struct touch_event event = sim->events[sim->next];
    if (sim->next == sim->jump_at) {
        event.x = 1.0f;
        event.y = 0.0f;
    }
    if (sim->next >= sim->spoil_from && sim->next < sim->spoil_to) {
        spoil(&event, sim->next);
    }
    return event;
}

static int is_mute(const struct touch_sim *sim)
{
    return sim->mute_every > 0 && sim->next % sim->mute_every == 0 &&
           sim->events[sim->next].kind == TOUCH_UP;
}

static void touch_sim_read_events(struct touch_sim *sim)
{
    const struct touch_event event = next_event(sim);
    const int twice = sim->double_every > 0 && sim->next % sim->double_every == 0;
    const int times = is_mute(sim) ? 0 : 1 + twice;
    sim->next++;
    for (int i = 0; i < times; i++) {
        touch_fingers_take(&sim->fingers, &event);
    }
    touch_fingers_point(&sim->fingers, &sim->report);
    sim->report.time_ns = event.time_ns;
    pointer_poi_report(&sim->pointer, &sim->report);
}

static struct poi_sample sample_at(struct touch_sim *sim, uint64_t time_ns)
{
    return (struct poi_sample){
        .time_ns = time_ns,
        .target = pointer_poi_target(&sim->pointer, time_ns),
    };
}

static int touch_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct touch_sim *sim = self;
    const uint64_t now_ns = touch_sim_now_ns(sim);
    uint32_t count = 0;
    if (sim->gone) {
        return HAL_ERR_GONE;
    }
    if (now_ns >= sim->silent_from_ns && now_ns < sim->silent_to_ns) {
        return 0;
    }
    while (sim->next < sim->event_count && sim->events[sim->next].time_ns <= now_ns) {
        if (sim->next >= sim->unplug_at) {
            sim->gone = 1;
            return HAL_ERR_GONE;
        }
        touch_sim_read_events(sim);
        if (count + 1u < max) {
            out[count++] = sample_at(sim, sim->report.time_ns);
        }
    }
    if (count < max) {
        out[count++] = sample_at(sim, now_ns);
    }
    return (int)count;
}

static void touch_sim_set_view(void *self, const struct view *view,
                               const struct display_settings *display_settings)
{
    struct touch_sim *sim = self;
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

struct hal_poi touch_sim_device(struct touch_sim *sim)
{
    static const struct hal_poi_ops ops = {
        .open = touch_sim_open,
        .poll = touch_sim_poll,
        .set_force = touch_sim_set_force,
        .set_view = touch_sim_set_view,
        .describe = touch_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}
