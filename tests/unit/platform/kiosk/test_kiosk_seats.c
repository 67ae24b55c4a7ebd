/* test_kiosk_seats.c -- the frame loop and who sits where: when seats may change, what becomes of a
 * hand that does, and how long its reports wait for a tick. */
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

/* A seat where two hands may sit. */
static struct {
    struct clock_sim clock;
    struct buttons_sim buttons;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t asked_moving, asked_still; /* Arranged so often with and without leave to move. */
    uint32_t moves;                     /* Answered to the next question that finds it. */
    uint8_t other_sits;
    uint8_t is_gone, is_absent;
    uint32_t open_count;
    uint64_t late_ns; /* Reports came so long ago. */
    uint8_t stamps;
    uint32_t told; /* Reports each frame. */
} rig;

static uint32_t arrange(void *self, int may_move)
{
    (void)self;
    rig.asked_moving += may_move != 0;
    rig.asked_still += may_move == 0;
    const uint32_t moves = rig.moves;
    rig.moves = 0;
    return moves;
}

static int hand_open(void *self)
{
    (void)self;
    rig.open_count++;
    return rig.is_absent ? HAL_ERR_ABSENT : rig.is_gone ? HAL_ERR_GONE : HAL_OK;
}

static int hand_poll(void *self, struct poi_sample *out, uint32_t max)
{
    (void)self;
    assert_true(max >= rig.told);
    if (rig.is_gone) {
        return HAL_ERR_GONE;
    }
    for (uint32_t i = 0; i < rig.told; i++) {
        out[i] = (struct poi_sample){
            .time_ns = rig.clock.now_ns - rig.late_ns + i,
            .was_stamped = rig.stamps,
            .target.position_m = v3(rig.other_sits ? 0.2f : -0.2f, 0.05f, 0.0f),
        };
    }
    return (int)rig.told;
}

static int hand_feel(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_OK;
}

static void hand_look(void *self, const struct view *view,
                      const struct display_settings *display_settings)
{
    (void)self;
    (void)view;
    (void)display_settings;
}

static const char *hand_describe(void *self)
{
    (void)self;
    return "a hand";
}

static int set_up(void **state)
{
    static const struct hal_seats_ops seats = { .arrange = arrange };
    static const struct hal_poi_ops hand = {
        .open = hand_open,
        .poll = hand_poll,
        .set_force = hand_feel,
        .set_view = hand_look,
        .describe = hand_describe,
    };
    static const struct kiosk_config config = { .core = {
                                                    .seed = 5, .fish_count = 8, .round_s = 10 } };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.told = 1;
    rig.hal = null_hal();
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.buttons.clock = rig.hal.clock;
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    rig.hal.seats.ops = &seats;
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

static void test_seats_may_change_while_nobody_plays_and_at_no_other_time(void **state)
{
    (void)state;
    frames(10);
    assert_int_equal(rig.asked_moving, 11); /* Once before the first frame. */
    assert_int_equal(rig.asked_still, 0);
    begin_round();
    const uint32_t before = rig.asked_moving;
    frames(60);
    assert_int_equal(rig.asked_moving, before);
    assert_true(rig.asked_still >= 60);
}

static void test_in_the_operators_menu_they_may_too(void **state)
{
    (void)state;
    rig.kiosk.core.game.phase = PHASE_MENU;
    const uint32_t before = rig.asked_moving;
    frames(1);
    assert_int_equal(rig.asked_moving, before + 1);
}

/* The way from the one to the other is nobody's, and no fault. */
static void test_who_sits_down_is_opened_and_leads_in_the_same_frame(void **state)
{
    (void)state;
    frames(10);
    const uint32_t opened = rig.open_count;
    rig.other_sits = 1;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.open_count, opened + 1);
    assert_int_equal(rig.kiosk.hands[0].link, POI_SOURCE_LIVE);
    assert_true(rig.kiosk.input.poi[0].target.position_m.x == 0.2f);
    assert_int_equal(rig.kiosk.faults.poi, 0);
}

static void test_a_seat_that_was_empty_plays_once_somebody_sits_down(void **state)
{
    (void)state;
    rig.is_absent = 1;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.kiosk.hands[0].link, POI_SOURCE_ABSENT);
    const uint32_t opened = rig.open_count;
    frames(200);
    assert_int_equal(rig.open_count, opened); /* Nobody looks for who is not expected. */
    rig.is_absent = 0;
    rig.moves = 1u;
    frames(1);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
}

/* Without the seats' word it would be looked for a second after it was lost. */
static void test_one_that_comes_back_plays_on_in_the_frame_that_sees_it(void **state)
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

static void test_a_report_waits_from_its_arrival_to_its_tick(void **state)
{
    (void)state;
    rig.stamps = 1;
    rig.told = 4;
    rig.late_ns = 5 * MS;
    frames(50);
    const struct frame_timing *wait = &rig.kiosk.report_wait;
    assert_int_equal(wait->count, 200);
    assert_true(frame_timing_quantile_ns(wait, 0.5) >= 4900000u);
    assert_true(frame_timing_quantile_ns(wait, 0.99) <= 5100000u);
}

/* A frame without a tick uses nothing: what came in it waits on. */
static void test_a_report_between_two_ticks_waits_for_the_next(void **state)
{
    (void)state;
    frames(1);
    rig.stamps = 1;
    rig.clock.now_ns += 1 * MS;
    kiosk_frame(&rig.kiosk, &rig.hal);
    assert_int_equal(rig.kiosk.report_wait.count, 0);
    rig.told = 0;
    rig.clock.now_ns += 20 * MS;
    kiosk_frame(&rig.kiosk, &rig.hal);
    assert_int_equal(rig.kiosk.report_wait.count, 1);
    assert_int_equal(rig.kiosk.report_wait.max_ns, 20 * MS);
}

static void test_what_a_driver_makes_up_is_not_timed(void **state)
{
    (void)state;
    rig.late_ns = 5 * MS;
    frames(50);
    assert_int_equal(rig.kiosk.report_wait.count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_seats_may_change_while_nobody_plays_and_at_no_other_time,
                               set_up),
        cmocka_unit_test_setup(test_in_the_operators_menu_they_may_too, set_up),
        cmocka_unit_test_setup(test_who_sits_down_is_opened_and_leads_in_the_same_frame, set_up),
        cmocka_unit_test_setup(test_a_seat_that_was_empty_plays_once_somebody_sits_down, set_up),
        cmocka_unit_test_setup(test_one_that_comes_back_plays_on_in_the_frame_that_sees_it, set_up),
        cmocka_unit_test_setup(test_a_report_waits_from_its_arrival_to_its_tick, set_up),
        cmocka_unit_test_setup(test_a_report_between_two_ticks_waits_for_the_next, set_up),
        cmocka_unit_test_setup(test_what_a_driver_makes_up_is_not_timed, set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
