/* test_kiosk_slots.c -- Tests the assignment of controllers to player slots in the frame loop.
 *
 * The assignment may change only at certain times, and a newly assigned controller must be opened
 * and used. Also tests the measured time from the arrival of a report to the tick that uses it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "platform/kiosk/kiosk.h"

#define MS 1000000ull
#define FRAME_NS 16666667ull

/* One player slot and two controllers that can be assigned to the slot. */
static struct {
    struct clock_sim clock;
    struct buttons_sim buttons;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t moving_calls, still_calls; /* Number of calls of arrange() with `may_move` true
                                           (moving_calls) and with `may_move` false
                                           (still_calls). */
    /* Result of the next call of arrange(): bit 0 is set if the controller of slot 0 changed. */
    uint32_t moves;
    uint8_t other_sits;
    uint8_t is_gone, is_absent;
    uint32_t open_count, view_count;
    bool scoops;      /* Value of the parameter `scoops` in the last call of set_view(). */
    uint64_t late_ns; /* Age of a report when the kiosk polls the controller, in ns. */
    uint8_t stamps;
    uint32_t report_count; /* Number of reports that each poll of the controller returns. */
} rig;

static uint32_t arrange(void *self, bool may_move)
{
    (void)self;
    rig.moving_calls += may_move != 0;
    rig.still_calls += may_move == 0;
    const uint32_t moves = rig.moves;
    rig.moves = 0;
    return moves;
}

static int controller_open(void *self)
{
    (void)self;
    rig.open_count++;
    return rig.is_absent ? HAL_ERR_ABSENT : rig.is_gone ? HAL_ERR_GONE : HAL_OK;
}

static int controller_poll(void *self, struct poi_sample *out, uint32_t max)
{
    (void)self;
    assert_true(max >= rig.report_count);
    if (rig.is_gone) {
        return HAL_ERR_GONE;
    }
    for (uint32_t i = 0; i < rig.report_count; i++) {
        out[i] = (struct poi_sample){
            .time_ns = rig.clock.now_ns - rig.late_ns + i,
            .was_stamped = rig.stamps,
            .target.position_m = v3(rig.other_sits ? 0.2f : -0.2f, 0.05f, 0.0f),
        };
    }
    return (int)rig.report_count;
}

static int fake_set_force(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_OK;
}

static void fake_set_view(void *self, const struct view *view,
                          const struct display_settings *display_settings, bool scoops)
{
    (void)self;
    assert_memory_equal(view, &rig.kiosk.view, sizeof *view);
    assert_memory_equal(display_settings, &rig.kiosk.display_settings, sizeof *display_settings);
    rig.scoops = scoops;
    rig.view_count++;
}

static const char *fake_describe(void *self)
{
    (void)self;
    return "a hand";
}

static int set_up(void **state)
{
    static const struct hal_slots_ops slots = { .arrange = arrange };
    static const struct hal_poi_ops hand = {
        .open = controller_open,
        .poll = controller_poll,
        .set_force = fake_set_force,
        .set_view = fake_set_view,
        .describe = fake_describe,
    };
    static const struct kiosk_config config = { .core = {
                                                    .seed = 5, .fish_count = 8, .round_s = 10 } };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.report_count = 1;
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.buttons.clock = rig.hal.clock;
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    rig.hal.slots.ops = &slots;
    rig.hal.poi[0].ops = &hand;
    return kiosk_init(&rig.kiosk, &rig.hal, &config);
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        rig.clock.now_ns += FRAME_NS;
        assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
    }
}

static void begin_round(void)
{
    rig.kiosk.input.pressed = INPUT_START;
    while (rig.kiosk.core.game.phase != PHASE_ROUND) {
        frames(1);
        assert_true(rig.kiosk.core.game.tick < 10 * CORE_TICK_HZ);
    }
}

static void test_controllers_are_reassigned_only_while_no_player_is_active(void **state)
{
    (void)state;
    frames(10);
    assert_int_equal(rig.moving_calls, 11); /* arrange() is called once before the first frame, and
                                               once in each of 10 frames. */
    assert_int_equal(rig.still_calls, 0);
    begin_round();
    const uint32_t before = rig.moving_calls;
    frames(60);
    assert_int_equal(rig.moving_calls, before);
    assert_true(rig.still_calls >= 60);
}

static void test_a_dip_scoops_in_a_round_and_presses_on_pages(void **state)
{
    (void)state;
    frames(10);
    assert_false(rig.scoops);
    begin_round();
    frames(1);
    assert_true(rig.scoops);
    rig.kiosk.core.game.phase = PHASE_MENU;
    frames(2);
    assert_false(rig.scoops);
}

static void test_controllers_are_reassigned_in_the_operator_menu(void **state)
{
    (void)state;
    rig.kiosk.core.game.phase = PHASE_MENU;
    const uint32_t before = rig.moving_calls;
    frames(1);
    assert_int_equal(rig.moving_calls, before + 1);
}

/* A slot that gets another controller has no input loss, so no fault must be counted. */
static void test_a_new_controller_is_opened_and_used_in_the_same_frame(void **state)
{
    (void)state;
    frames(9);
    const uint32_t before = rig.view_count;
    frames(1);
    const uint32_t opened = rig.open_count, viewed = rig.view_count, per_frame = viewed - before;
    rig.other_sits = 1;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.open_count, opened + 1);
    /* set_view() is called once more than usual, to pass the view to the new controller. */
    assert_int_equal(rig.view_count, viewed + per_frame + 1);
    assert_int_equal(rig.kiosk.samplers[0].link, POI_SOURCE_LIVE);
    assert_true(rig.kiosk.input.poi[0].target.position_m.x == 0.2f);
    assert_int_equal(rig.kiosk.faults.poi, 0);
}

static void test_an_empty_player_slot_plays_after_a_controller_is_assigned(void **state)
{
    (void)state;
    rig.is_absent = 1;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.kiosk.samplers[0].link, POI_SOURCE_ABSENT);
    const uint32_t opened = rig.open_count;
    frames(200);
    assert_int_equal(rig.open_count, opened); /* The slot is empty, so the kiosk does not try to
                                                 open a poi. */
    rig.is_absent = 0;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
}

/* The kiosk tries to reopen a lost controller only once a second. The reconnected controller must
 * be opened earlier, because arrange() reports it. */
static void test_a_reconnected_controller_is_used_in_the_frame_that_detects_it(void **state)
{
    (void)state;
    begin_round();
    rig.is_gone = 1;
    frames(5);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LOST);
    rig.is_gone = 0;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
    assert_int_equal(rig.kiosk.core.game.phase, PHASE_ROUND);
}

static void test_the_latency_of_a_report_is_measured_from_arrival_to_tick(void **state)
{
    (void)state;
    rig.stamps = 1;
    rig.report_count = 4;
    rig.late_ns = 5 * MS;
    frames(50);
    const struct frame_timing *wait = &rig.kiosk.report_wait;
    assert_int_equal(wait->count, 200);
    assert_true(frame_timing_quantile_ns(wait, 0.5) >= 4900000u);
    assert_true(frame_timing_quantile_ns(wait, 0.99) <= 5100000u);
}

/* A frame of 1 ms is too short for a tick, so a report of this frame must be used by the tick of
 * the next frame. */
static void test_a_report_between_two_ticks_is_used_by_the_next_tick(void **state)
{
    (void)state;
    frames(1);
    rig.stamps = 1;
    rig.clock.now_ns += 1 * MS;
    kiosk_frame(&rig.kiosk, &rig.hal);
    assert_int_equal(rig.kiosk.report_wait.count, 0);
    rig.report_count = 0;
    rig.clock.now_ns += 20 * MS;
    kiosk_frame(&rig.kiosk, &rig.hal);
    assert_int_equal(rig.kiosk.report_wait.count, 1);
    assert_int_equal(rig.kiosk.report_wait.max_ns, 20 * MS);
}

static void test_generated_samples_are_excluded_from_the_latency(void **state)
{
    (void)state;
    rig.late_ns = 5 * MS;
    frames(50);
    assert_int_equal(rig.kiosk.report_wait.count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_controllers_are_reassigned_only_while_no_player_is_active,
                               set_up),
        cmocka_unit_test_setup(test_a_dip_scoops_in_a_round_and_presses_on_pages, set_up),
        cmocka_unit_test_setup(test_controllers_are_reassigned_in_the_operator_menu, set_up),
        cmocka_unit_test_setup(test_a_new_controller_is_opened_and_used_in_the_same_frame, set_up),
        cmocka_unit_test_setup(test_an_empty_player_slot_plays_after_a_controller_is_assigned,
                               set_up),
        cmocka_unit_test_setup(test_a_reconnected_controller_is_used_in_the_frame_that_detects_it,
                               set_up),
        cmocka_unit_test_setup(test_the_latency_of_a_report_is_measured_from_arrival_to_tick,
                               set_up),
        cmocka_unit_test_setup(test_a_report_between_two_ticks_is_used_by_the_next_tick, set_up),
        cmocka_unit_test_setup(test_generated_samples_are_excluded_from_the_latency, set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
