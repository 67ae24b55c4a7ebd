/* test_kiosk.c -- Tests the frame loop with simulated devices: ticks per frame, buttons, coins, and
 * the end of the program. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder/score_playback.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "tests/unit/support/kiosk_fixture.h"

static void expect_in_tick(void *self, const struct input *input)
{
    const struct session_recorder *sessions = self;
    (void)input;
    assert_true(atomic_load(&sessions->is_busy));
    assert_true(atomic_load(&sessions->is_in_tick));
    rig.seen_count++;
}

/* Before each tick, the kiosk calls session_recorder_before(), which blocks the thread of the frame
 * loop if another thread has panicked. This call must come before the recording callback (the tap)
 * gets the input of the tick. */
static void test_a_stopped_thread_stops_before_its_tap_records_the_tick(void **state)
{
    static struct session_recorder sessions;
    struct kiosk_config config = small;
    (void)state;
    config.sessions = &sessions;
    config.tap = (struct kiosk_tap){ .before = expect_in_tick, .self = &sessions };
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    frames(2);
    assert_int_equal(rig.seen_count, 4);
}

/* ---- Tests of ticks and frames -------------------------------------------------------------- */

static void test_a_frame_has_two_ticks_one_picture_and_one_watchdog_kick(void **state)
{
    (void)state;
    frames(60);
    assert_int_equal(rig.kiosk.core.game.tick, 120);
    assert_int_equal(rig.display.present_count, 60);
    assert_int_equal(rig.display.scene.tick, 120);
    assert_int_equal(rig.kicks, 60);
    assert_int_equal(rig.kiosk.pace.dropped, 0);
}

static void test_a_frame_without_ticks_presents_but_does_not_kick_the_watchdog(void **state)
{
    (void)state;
    frames(1);
    frame_after(2 * MS);
    assert_int_equal(rig.kiosk.core.game.tick, 2);
    assert_int_equal(rig.display.present_count, 2);
    assert_int_equal(rig.kicks, 1);
}

static void test_ticks_of_a_delayed_frame_are_dropped_and_counted(void **state)
{
    (void)state;
    frames(1);
    frame_after(1000 * MS);
    assert_int_equal(rig.kiosk.core.game.tick, 2 + 60);
    assert_int_equal(rig.kiosk.pace.dropped, 60);
}

/* ---- Tests of buttons and coins ------------------------------------------------------------- */

static uint32_t ticks_that_saw(uint32_t button)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < rig.seen_count; i++) {
        count += (rig.seen[i].pressed & button) != 0;
    }
    return count;
}

static uint32_t coins_seen(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < rig.seen_count; i++) {
        count += rig.seen[i].coin_count[0];
    }
    return count;
}

static void test_a_button_press_is_delivered_to_exactly_one_tick(void **state)
{
    static const struct button_event events[] = {
        { .time_ns = 1030 * MS, .pressed = INPUT_LANGUAGE },
        { .time_ns = 1200 * MS, .released = INPUT_LANGUAGE },
    };
    (void)state;
    script(events, 2);
    frames(30);
    assert_int_equal(ticks_that_saw(INPUT_LANGUAGE), 1);
    assert_int_equal(rig.kiosk.core.game.language, LANGUAGE_EN);
}

static void test_a_press_in_a_frame_without_ticks_is_delivered_to_the_next_tick(void **state)
{
    static const struct button_event events[] = {
        { .time_ns = 1018 * MS, .pressed = INPUT_START, .coin_count[0] = 2 },
        { .time_ns = 1019 * MS, .released = INPUT_START, .coin_count[0] = 1 },
    };
    (void)state;
    script(events, 2);
    frame_after(FRAME_NS);
    frame_after(2 * MS);
    frame_after(2 * MS);
    assert_int_equal(ticks_that_saw(INPUT_START), 0);
    frame_after(FRAME_NS);
    assert_int_equal(ticks_that_saw(INPUT_START), 1);
    assert_int_equal(coins_seen(), 3);
    frames(10);
    assert_int_equal(ticks_that_saw(INPUT_START), 1);
    assert_int_equal(coins_seen(), 3);
}

static void test_each_coin_is_counted_once_at_any_frame_time(void **state)
{
    static struct button_event events[500];
    (void)state;
    for (uint32_t i = 0; i < 500; i++) {
        events[i] = (struct button_event){ .time_ns = (1000 + 7 * i) * MS, .coin_count[0] = 1 };
    }
    script(events, 500);
    for (uint32_t i = 0; i < 400; i++) {
        frame_after((1 + (i * 7919u) % 23u) * MS);
    }
    assert_int_equal(coins_seen(), 500);
}

static void test_a_second_press_of_quit_ends_the_loop_after_its_frame(void **state)
{
    static const struct button_event events[] = { { .time_ns = 1020 * MS, .quit = 1 },
                                                  { .time_ns = 5900 * MS, .quit = 1 } };
    (void)state;
    script(events, 2);
    frames(1);
    assert_int_equal(frame_after(FRAME_NS), KIOSK_RUNS);
    assert_int_equal(rig.display.scene.is_confirming_quit, 1);
    uint32_t count = 0;
    while (frame_after(FRAME_NS) == KIOSK_RUNS) {
        assert_in_range(++count, 1, 400);
    }
    assert_int_equal(rig.kiosk.end, KIOSK_QUIT);
    assert_in_range(count, 285, 300);
}

static void test_one_press_of_quit_never_ends_the_loop(void **state)
{
    static const struct button_event event = { .time_ns = 1020 * MS, .quit = 1 };
    (void)state;
    script(&event, 1);
    frames(2);
    assert_int_equal(rig.display.scene.is_confirming_quit, 1);
    frames(1200); /* 1200 frames are 20 s, so the first QUIT has long timed out. */
    assert_int_equal(rig.kiosk.end, KIOSK_RUNS);
    assert_int_equal(rig.display.scene.is_confirming_quit, 0);
}

static void test_the_quit_confirmation_times_out_after_five_seconds(void **state)
{
    static const struct button_event events[] = { { .time_ns = 1020 * MS, .quit = 1 },
                                                  { .time_ns = 6200 * MS, .quit = 1 } };
    (void)state;
    script(events, 2);
    /* The clock is at 6.1 s, more than five seconds after the first QUIT, so the confirmation is no
     * longer shown. */
    frames(305);
    assert_int_equal(rig.display.scene.is_confirming_quit, 0);
    frames(20);
    assert_int_equal(rig.kiosk.end, KIOSK_RUNS);
    /* This QUIT counts as a first one, so it shows the confirmation again. */
    assert_int_equal(rig.display.scene.is_confirming_quit, 1);
}

static void test_any_other_button_cancels_the_quit_confirmation(void **state)
{
    static const struct button_event events[] = {
        { .time_ns = 1020 * MS, .quit = 1 },
        { .time_ns = 1100 * MS, .pressed = INPUT_LEFT },
        { .time_ns = 1200 * MS, .released = INPUT_LEFT, .quit = 1 },
    };
    (void)state;
    script(events, 3);
    frames(8);
    assert_int_equal(rig.display.scene.is_confirming_quit, 0);
    frames(10);
    assert_int_equal(rig.kiosk.end, KIOSK_RUNS);
    assert_int_equal(rig.display.scene.is_confirming_quit, 1);
}

static void test_the_full_screen_key_is_passed_to_the_display(void **state)
{
    static const struct button_event events[] = { { .time_ns = 1020 * MS, .full_screen = 1 } };
    (void)state;
    script(events, 1);
    frames(5);
    assert_int_equal(rig.display.full_screen_count, 1);
}

static void test_the_kiosk_runs_without_any_device(void **state)
{
    (void)state;
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &small), CORE_OK);
    frames(600);
    assert_int_equal(rig.kiosk.core.game.tick, 1200);
    assert_int_equal(rig.kiosk.faults.display, 0);
}

static void test_equal_devices_give_equal_hashes(void **state)
{
    (void)state;
    play_a_round();
    const uint64_t first = core_hash(&rig.kiosk.core);
    set_up(state);
    play_a_round();
    assert_true(core_hash(&rig.kiosk.core) == first);
}

static void test_a_config_out_of_range_is_refused(void **state)
{
    struct kiosk_config config = small;
    (void)state;
    config.core.round_s = 5;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_ERR_RANGE);
}

/* ---- Tests of the playback of a score ------------------------------------------------------- */

static void test_the_button_that_ends_a_playback_has_no_other_effect(void **state)
{
    (void)state;
    static struct score_playback playback;
    static const struct button_event events[] = {
        { .time_ns = 3000 * MS, .pressed = INPUT_START },
    };
    memset(&playback, 0, sizeof playback);
    rig.kiosk.config.playback = &playback;
    frames(2);
    assert_int_equal(rig.display.scene.playback, PLAYBACK_OFF);
    rig.kiosk.wanted_replay_id = 7;
    frames(2);
    assert_int_equal(rig.kiosk.wanted_replay_id, 0);
    assert_int_equal(rig.display.scene.playback, PLAYBACK_NONE); /* The store has no replay of round
                                                                  7, so nothing is played back. */
    script(events, 1);
    frames(2);
    while (rig.clock.now_ns < 3100 * MS) {
        frames(1);
    }
    assert_int_equal(rig.display.scene.playback, PLAYBACK_OFF);
    assert_int_equal(rig.kiosk.core.game.phase, PHASE_ATTRACT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_the_button_that_ends_a_playback_has_no_other_effect),
        TEST(test_a_stopped_thread_stops_before_its_tap_records_the_tick),
        TEST(test_a_frame_has_two_ticks_one_picture_and_one_watchdog_kick),
        TEST(test_a_frame_without_ticks_presents_but_does_not_kick_the_watchdog),
        TEST(test_ticks_of_a_delayed_frame_are_dropped_and_counted),
        TEST(test_a_button_press_is_delivered_to_exactly_one_tick),
        TEST(test_a_press_in_a_frame_without_ticks_is_delivered_to_the_next_tick),
        TEST(test_each_coin_is_counted_once_at_any_frame_time),
        TEST(test_a_second_press_of_quit_ends_the_loop_after_its_frame),
        TEST(test_one_press_of_quit_never_ends_the_loop),
        TEST(test_the_quit_confirmation_times_out_after_five_seconds),
        TEST(test_any_other_button_cancels_the_quit_confirmation),
        TEST(test_the_full_screen_key_is_passed_to_the_display),
        TEST(test_the_kiosk_runs_without_any_device),
        TEST(test_equal_devices_give_equal_hashes),
        TEST(test_a_config_out_of_range_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
