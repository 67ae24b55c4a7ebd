/* buttons_sim.c -- plays a script of button events as debounced buttons would report them. */
#include "drivers/sim/buttons_sim.h"

static int buttons_sim_poll(void *self, struct button_sample *out)
{
    struct buttons_sim *sim = self;
    const uint64_t now_ns = sim->clock.ops->now_ns(sim->clock.self);
    *out = (struct button_sample){ 0 };
    while (sim->next < sim->event_count && sim->events[sim->next].time_ns <= now_ns) {
        const struct button_event *event = &sim->events[sim->next++];
        out->pressed |= event->pressed;
        for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
            out->coin_count[line] += event->coin_count[line];
        }
        out->quit |= event->quit;
        out->full_screen |= event->full_screen;
        sim->held = (sim->held | event->pressed) & ~event->released;
    }
    out->held = sim->held;
    return HAL_OK;
}

static const char *buttons_sim_describe(void *self)
{
    (void)self;
    return "buttons pressed by a script";
}

struct hal_buttons buttons_sim_device(struct buttons_sim *sim)
{
    static const struct hal_buttons_ops ops = {
        .poll = buttons_sim_poll,
        .describe = buttons_sim_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = sim };
}
