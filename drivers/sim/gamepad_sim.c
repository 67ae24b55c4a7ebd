/* gamepad_sim.c -- implements the simulated game pad, which tests use in place of SDL's game
 * pads. */
#include "drivers/sim/gamepad_sim.h"

#include "core/base/panic.h"

#define GAMEPAD_STREAM 83u

void gamepad_sim_init(struct gamepad_sim *sim, struct hal_clock clock, const struct view *view)
{
    CORE_ASSERT(view);
    *sim = (struct gamepad_sim){ .feed = report_feed_begin(clock) };
    gamepad_queue_init(&sim->track, view, hal_now_ns(sim->feed.clock));
}

static int gamepad_sim_open(void *self)
{
    struct gamepad_sim *sim = self;
    const int result = report_feed_open(&sim->feed);
    if (result > 0) {
        const struct view view = sim->track.decoder.fly.view;
        /* A game pad that is plugged in again starts with a new decoder state, as with SDL. */
        gamepad_queue_init(&sim->track, &view, hal_now_ns(sim->feed.clock));
    }
    return result < 0 ? HAL_ERR_GONE : HAL_OK;
}

/* Returns the next report with its faults. A report with random bits is a possible fault, because
 * SDL does not validate the values of real game pads. */
static struct gamepad_report faulty_pad_report(const struct gamepad_sim *sim,
                                               const struct report_fault *fault)
{
    CORE_ASSERT(fault->index < sim->feed.count);
    struct gamepad_report report = sim->reports[fault->index];
    if (fault->jumps) {
        report.axis[GAMEPAD_LEAD_X] = report.axis[GAMEPAD_TILT_X] = INT16_MAX;
        report.axis[GAMEPAD_LEAD_Y] = report.axis[GAMEPAD_TILT_Y] = INT16_MIN;
    }
    if (fault->is_random) {
        for (uint32_t i = 0; i < GAMEPAD_AXIS_COUNT; i++) {
            report.axis[i] = (int16_t)report_feed_random(GAMEPAD_STREAM, fault->index, i);
        }
        report.buttons = report_feed_random(GAMEPAD_STREAM, fault->index, 7);
        report.has_turn = report.has_weight = true;
        vec3 *const vectors[] = { &report.turn_rad_s, &report.weight_m_s2 };
        for (uint32_t i = 0; i < 2; i++) {
            const uint32_t what = 10u * (i + 1u);
            *vectors[i] = v3(report_feed_random_float(GAMEPAD_STREAM, fault->index, what),
                             report_feed_random_float(GAMEPAD_STREAM, fault->index, what + 1u),
                             report_feed_random_float(GAMEPAD_STREAM, fault->index, what + 2u));
        }
    }
    return report;
}

/* Queues the reports that are due at the current time. Returns true, or false after the game pad
 * was unplugged. */
static bool queue_reports(struct gamepad_sim *sim)
{
    struct report_fault fault;
    int result;
    while ((result = report_feed_take(&sim->feed, sim->reports, sizeof *sim->reports, &fault)) >
           0) {
        const struct gamepad_report report = faulty_pad_report(sim, &fault);
        for (uint32_t i = 0; i < fault.copies; i++) {
            gamepad_queue_push(&sim->track, &report);
        }
    }
    return result != HAL_ERR_GONE;
}

static int gamepad_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct gamepad_sim *sim = self;
    CORE_ASSERT(out || max == 0);
    return queue_reports(sim)
               ? (int)gamepad_queue_pop(&sim->track, hal_now_ns(sim->feed.clock), out, max)
               : (int)HAL_ERR_GONE;
}

static int gamepad_sim_set_force(void *self, const struct poi_force *force)
{
    struct gamepad_sim *sim = self;
    CORE_ASSERT(force);
    sim->felt = gamepad_decoder_rumble(force);
    return sim->feed.gone ? HAL_ERR_GONE : HAL_OK;
}

static void gamepad_sim_set_view(void *self, const struct view *view,
                                 const struct display_settings *display_settings, bool scoops)
{
    struct gamepad_sim *sim = self;
    CORE_ASSERT(view);
    /* `display_settings` is unused, because a stick moves the poi relative to the water and not to
     * the screen. */
    (void)display_settings;
    stick_motion_set_view(&sim->track.decoder.fly, view);
    sim->track.decoder.fly.dip.scoops = scoops;
}

static const char *gamepad_sim_describe(void *self)
{
    (void)self;
    return "simulated pad";
}

static int gamepad_fan_sim_poll(void *self, struct shade_input *out)
{
    struct gamepad_sim *sim = self;
    if (sim->feed.gone) {
        return HAL_ERR_GONE;
    }
    *out = stick_motion_fan(&sim->track.decoder.fly, hal_now_ns(sim->feed.clock));
    return HAL_OK;
}

static int gamepad_buttons_sim_poll(void *self, struct button_sample *out)
{
    struct gamepad_sim *sim = self;
    *out = (struct button_sample){ 0 };
    if (!queue_reports(sim)) {
        return HAL_ERR_GONE;
    }
    gamepad_queue_buttons(&sim->track, out);
    return HAL_OK;
}

struct hal_controller_devices gamepad_sim_devices(struct gamepad_sim *sim)
{
    static const struct hal_poi_ops poi = {
        .open = gamepad_sim_open,
        .poll = gamepad_sim_poll,
        .set_force = gamepad_sim_set_force,
        .set_view = gamepad_sim_set_view,
        .describe = gamepad_sim_describe,
    };
    static const struct hal_fan_ops fan = {
        .open = report_feed_fan_open,
        .poll = gamepad_fan_sim_poll,
        .describe = gamepad_sim_describe,
    };
    static const struct hal_buttons_ops buttons = {
        .poll = gamepad_buttons_sim_poll,
        .describe = gamepad_sim_describe,
    };
    return (struct hal_controller_devices){
        .poi = { &poi, sim },
        .fan = { &fan, sim },
        .buttons = { &buttons, sim },
    };
}
