/* gamepad_sim.c -- implements the simulated game pad, which tests use in place of SDL's game
 * pads. */
#include "drivers/sim/gamepad_sim.h"

#include "core/base/panic.h"

#define GAMEPAD_STREAM 83u

void gamepad_sim_init(struct gamepad_sim *sim, struct hal_clock clock, const struct view *view)
{
    CORE_ASSERT(view);
    *sim = (struct gamepad_sim){ .feed = report_feed_begin(clock) };
    gamepad_queue_init(&sim->track, view, report_feed_now_ns(&sim->feed));
}

static int gamepad_sim_open(void *self)
{
    struct gamepad_sim *sim = self;
    const int result = report_feed_open(&sim->feed);
    if (result > 0) {
        const struct view view = sim->track.hand.fly.view;
        /* A game pad that is plugged in again starts with a new state, as with SDL. */
        gamepad_queue_init(&sim->track, &view, report_feed_now_ns(&sim->feed));
    }
    return result < 0 ? HAL_ERR_GONE : HAL_OK;
}

static vec3 random_vec3(uint32_t index, uint32_t what)
{
    return v3(report_feed_random_float(GAMEPAD_STREAM, index, what),
              report_feed_random_float(GAMEPAD_STREAM, index, what + 1),
              report_feed_random_float(GAMEPAD_STREAM, index, what + 2));
}

/* Returns a report with its faults. A report with random bits is possible, because SDL does not
 * validate the values of real game pads. */
static struct gamepad_report faulty_pad_report(const struct gamepad_sim *sim,
                                               const struct report_fault *fault)
{
    CORE_ASSERT(fault->index < sim->feed.count);
    struct gamepad_report report = sim->reports[fault->index];
    if (fault->jumps) {
        report.axis[GAMEPAD_LEAD_X] = report.axis[GAMEPAD_TILT_X] = INT16_MAX;
        report.axis[GAMEPAD_LEAD_Y] = report.axis[GAMEPAD_TILT_Y] = INT16_MIN;
    }
    if (fault->spoils) {
        for (uint32_t i = 0; i < GAMEPAD_AXIS_COUNT; i++) {
            report.axis[i] = (int16_t)report_feed_random(GAMEPAD_STREAM, fault->index, i);
        }
        report.buttons = report_feed_random(GAMEPAD_STREAM, fault->index, 7);
        report.has_turn = report.has_weight = 1;
        report.turn_rad_s = random_vec3(fault->index, 10);
        report.weight_m_s2 = random_vec3(fault->index, 20);
    }
    return report;
}

/* Queues the reports that are due at the current time. Returns HAL_OK, or HAL_ERR_GONE after the
 * game pad was unplugged. */
static int queue_reports(struct gamepad_sim *sim)
{
    CORE_ASSERT(sim->feed.next <= sim->feed.count && (sim->reports || sim->feed.count == 0));
    struct report_feed *feed = &sim->feed;
    const uint64_t now_ns = report_feed_now_ns(feed);
    if (feed->gone || report_feed_is_silent(feed, now_ns)) {
        return feed->gone ? (int)HAL_ERR_GONE : (int)HAL_OK;
    }
    while (feed->next < feed->count && sim->reports[feed->next].time_ns <= now_ns) {
        struct report_fault fault;
        if (!report_feed_take(feed, &fault)) {
            return HAL_ERR_GONE;
        }
        const struct gamepad_report report = faulty_pad_report(sim, &fault);
        for (uint32_t i = 0; i < fault.copies; i++) {
            gamepad_queue_push(&sim->track, &report);
        }
    }
    return HAL_OK;
}

static int gamepad_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct gamepad_sim *sim = self;
    CORE_ASSERT(out || max == 0);
    const int result = queue_reports(sim);
    return result == HAL_OK
               ? (int)gamepad_queue_pop(&sim->track, report_feed_now_ns(&sim->feed), out, max)
               : result;
}

static int gamepad_sim_set_force(void *self, const struct poi_force *force)
{
    struct gamepad_sim *sim = self;
    CORE_ASSERT(force);
    sim->felt = gamepad_decoder_rumble(force);
    return sim->feed.gone ? HAL_ERR_GONE : HAL_OK;
}

static void gamepad_sim_set_view(void *self, const struct view *view,
                                 const struct display_settings *display_settings)
{
    struct gamepad_sim *sim = self;
    CORE_ASSERT(view);
    (void)display_settings; /* Unused, because a stick moves relative to the water and not to the
                               screen. */
    gamepad_decoder_set_view(&sim->track.hand, view);
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
    *out = gamepad_decoder_fan(&sim->track.hand, report_feed_now_ns(&sim->feed));
    return HAL_OK;
}

static int gamepad_buttons_sim_poll(void *self, struct button_sample *out)
{
    struct gamepad_sim *sim = self;
    *out = (struct button_sample){ 0 };
    if (queue_reports(sim) != HAL_OK) {
        return HAL_ERR_GONE;
    }
    gamepad_queue_buttons(&sim->track, out);
    return HAL_OK;
}

struct hal_poi gamepad_sim_device(struct gamepad_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_poi_ops ops = {
        .open = gamepad_sim_open,
        .poll = gamepad_sim_poll,
        .set_force = gamepad_sim_set_force,
        .set_view = gamepad_sim_set_view,
        .describe = gamepad_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}

struct hal_fan gamepad_sim_fan(struct gamepad_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_fan_ops ops = {
        .open = report_feed_fan_open,
        .poll = gamepad_fan_sim_poll,
        .describe = gamepad_sim_describe,
    };
    return (struct hal_fan){ .ops = &ops, .self = sim };
}

struct hal_buttons gamepad_sim_buttons(struct gamepad_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_buttons_ops ops = {
        .poll = gamepad_buttons_sim_poll,
        .describe = gamepad_sim_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = sim };
}
