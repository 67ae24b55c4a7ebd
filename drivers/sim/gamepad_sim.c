/* gamepad_sim.c -- implements the simulated game pad, which replaces SDL's game pads in tests. */
#include "drivers/sim/gamepad_sim.h"

#include <string.h>

#include "core/base/rng.h"

void gamepad_sim_init(struct gamepad_sim *sim, struct hal_clock clock, const struct view *view)
{
    *sim = (struct gamepad_sim){
        .clock = clock,
        .unplug_at = GAMEPAD_SIM_NEVER,
        .jump_at = GAMEPAD_SIM_NEVER,
    };
    gamepad_queue_init(&sim->track, view, clock.ops->now_ns(clock.self));
}

static uint64_t gamepad_sim_now_ns(const struct gamepad_sim *sim)
{
    return sim->clock.ops->now_ns(sim->clock.self);
}

static int pad_sim_open(void *self)
{
    struct gamepad_sim *sim = self;
    sim->open_count++;
    if (sim->gone && gamepad_sim_now_ns(sim) >= sim->replug_ns) {
        const struct view view = sim->track.hand.fly.view;
        /* A game pad that is plugged in again starts with a new state, as with SDL. */
        gamepad_queue_init(&sim->track, &view, gamepad_sim_now_ns(sim));
        sim->gone = 0;
        sim->unplug_at = GAMEPAD_SIM_NEVER;
    }
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static float any_float(uint32_t index, uint32_t what)
{
    const uint32_t bits = rng_u32((struct rng_key){ 83, index, what, RNG_TEST });
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static vec3 any_vec3(uint32_t index, uint32_t what)
{
    return v3(any_float(index, what), any_float(index, what + 1), any_float(index, what + 2));
}

/* Fills a report with random bits, because SDL does not validate the values of real game pads. */
static void spoil(struct gamepad_report *report, uint32_t index)
{
    for (uint32_t i = 0; i < GAMEPAD_AXIS_COUNT; i++) {
        report->axis[i] = (int16_t)rng_u32((struct rng_key){ 83, index, i, RNG_TEST });
    }
    report->buttons = rng_u32((struct rng_key){ 83, index, 7, RNG_TEST });
    report->has_turn = report->has_weight = 1;
    report->turn_rad_s = any_vec3(index, 10);
    report->weight_m_s2 = any_vec3(index, 20);
}

static struct gamepad_report next_report(struct gamepad_sim *sim)
{
    struct gamepad_report report = sim->reports[sim->next];
    if (sim->next == sim->jump_at) {
        report.axis[GAMEPAD_LEAD_X] = report.axis[GAMEPAD_TILT_X] = INT16_MAX;
        report.axis[GAMEPAD_LEAD_Y] = report.axis[GAMEPAD_TILT_Y] = INT16_MIN;
    }
    if (sim->next >= sim->spoil_from && sim->next < sim->spoil_to) {
        spoil(&report, sim->next);
    }
    sim->next++;
    return report;
}

/* Queues the reports that are due at the current time. Returns HAL_OK, or HAL_ERR_GONE after the
 * game pad was unplugged. */
static int arrive(struct gamepad_sim *sim)
{
    const uint64_t now_ns = gamepad_sim_now_ns(sim);
    if (sim->gone || (now_ns >= sim->silent_from_ns && now_ns < sim->silent_to_ns)) {
        return sim->gone ? (int)HAL_ERR_GONE : (int)HAL_OK;
    }
    while (sim->next < sim->report_count && sim->reports[sim->next].time_ns <= now_ns) {
        if (sim->next >= sim->unplug_at) {
            sim->gone = 1;
            return HAL_ERR_GONE;
        }
        const int twice = sim->double_every > 0 && sim->next % sim->double_every == 0;
        const struct gamepad_report report = next_report(sim);
        for (int i = 0; i <= twice; i++) {
            gamepad_queue_push(&sim->track, &report);
        }
    }
    return HAL_OK;
}

static int pad_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct gamepad_sim *sim = self;
    const int result = arrive(sim);
    return result == HAL_OK ? (int)gamepad_queue_pop(&sim->track, gamepad_sim_now_ns(sim), out, max)
                            : result;
}

static int pad_sim_set_force(void *self, const struct poi_force *force)
{
    struct gamepad_sim *sim = self;
    sim->felt = gamepad_decoder_rumble(force);
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static void pad_sim_set_view(void *self, const struct view *view,
                             const struct display_settings *display_settings)
{
    struct gamepad_sim *sim = self;
    (void)display_settings; /* Unused, because a stick moves relative to the water and not to the
                               screen. */
    gamepad_decoder_set_view(&sim->track.hand, view);
}

static const char *pad_sim_describe(void *self)
{
    (void)self;
    return "simulated pad";
}

static int gamepad_sim_fan_open(void *self)
{
    const struct gamepad_sim *sim = self;
    return sim->gone ? HAL_ERR_GONE : HAL_OK;
}

static int gamepad_sim_fan_poll(void *self, struct shade_input *out)
{
    struct gamepad_sim *sim = self;
    if (sim->gone) {
        return HAL_ERR_GONE;
    }
    *out = gamepad_decoder_fan(&sim->track.hand, gamepad_sim_now_ns(sim));
    return HAL_OK;
}

static int gamepad_sim_buttons_poll(void *self, struct button_sample *out)
{
    struct gamepad_sim *sim = self;
    *out = (struct button_sample){ 0 };
    if (arrive(sim) != HAL_OK) {
        return HAL_ERR_GONE;
    }
    gamepad_queue_buttons(&sim->track, out);
    return HAL_OK;
}

struct hal_poi gamepad_sim_device(struct gamepad_sim *sim)
{
    static const struct hal_poi_ops ops = {
        .open = pad_sim_open,
        .poll = pad_sim_poll,
        .set_force = pad_sim_set_force,
        .set_view = pad_sim_set_view,
        .describe = pad_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}

struct hal_fan gamepad_sim_fan(struct gamepad_sim *sim)
{
    static const struct hal_fan_ops ops = {
        .open = gamepad_sim_fan_open,
        .poll = gamepad_sim_fan_poll,
        .describe = pad_sim_describe,
    };
    return (struct hal_fan){ .ops = &ops, .self = sim };
}

struct hal_buttons gamepad_sim_buttons(struct gamepad_sim *sim)
{
    static const struct hal_buttons_ops ops = {
        .poll = gamepad_sim_buttons_poll,
        .describe = pad_sim_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = sim };
}
