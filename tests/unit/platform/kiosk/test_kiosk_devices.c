/* test_kiosk_devices.c -- Tests the frame loop while the poi or the display is slow, absent or
 * unplugged. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/kiosk_fixture.h"

static void test_no_pose_is_used_twice_while_the_controller_moves(void **state)
{
    (void)state;
    glide(1000, 1);
    frames(50);
    for (uint32_t i = 3; i < rig.seen_count; i++) {
        const float now = rig.seen[i].poi[0].target.position_m.x;
        const float before = rig.seen[i - 1].poi[0].target.position_m.x;
        assert_int_equal(rig.seen[i].poi[0].link, POI_SOURCE_LIVE);
        assert_true(now > before);
    }
}

static void test_a_disconnected_poi_keeps_its_pose_and_reconnects_within_a_second(void **state)
{
    (void)state;
    glide(1000, 10);
    rig.poi.feed.unplug_at = 20;
    rig.poi.feed.replug_ns = 2500 * MS;
    frames(30);
    const struct poi_input lost = rig.kiosk.input.poi[0];
    assert_int_equal(lost.link, POI_SOURCE_LOST);
    assert_true(rig.kiosk.faults.poi >= 1);
    frames(30);
    assert_memory_equal(&rig.kiosk.input.poi[0].target, &lost.target, sizeof lost.target);
    uint32_t waited = 0;
    while (rig.kiosk.input.poi[0].link != POI_SOURCE_LIVE && waited < 300) {
        frames(1);
        waited++;
    }
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
    assert_true(rig.clock.now_ns < (2500 + 1000 + 20) * MS);
    assert_in_range(rig.poi.feed.open_count, 3, 5); /* The kiosk opens the poi once at the start,
                                                       and then tries to reopen it once a
                                                       second. */
}

static void test_the_frame_loop_survives_an_unplug_at_any_report(void **state)
{
    (void)state;
    for (uint32_t at = 0; at < 50; at++) {
        set_up(state);
        glide(100, 3);
        rig.poi.feed.unplug_at = at;
        rig.poi.feed.replug_ns = 1500 * MS;
        rig.poi.feed.double_every = 3;
        rig.poi.feed.jump_at = at / 2;
        frames(200);
        assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
        assert_int_equal(rig.kiosk.core.game.tick, 400);
    }
}

static void test_a_controller_without_reports_keeps_its_pose(void **state)
{
    (void)state;
    glide(1000, 2);
    rig.poi.feed.silent_from_ns = 1200 * MS;
    rig.poi.feed.silent_to_ns = 1700 * MS;
    frames(30);
    const float held = rig.kiosk.input.poi[0].target.position_m.x;
    frames(5);
    assert_true(rig.kiosk.input.poi[0].target.position_m.x == held);
    frames(15);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
    assert_true(rig.kiosk.input.poi[0].target.position_m.x > held);
}

static void test_a_kiosk_without_a_controller_reports_an_absent_poi(void **state)
{
    (void)state;
    rig.hal.poi[0] = null_hal(NULL).poi[0];
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &small), CORE_OK);
    frames(10);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_ABSENT);
    assert_int_equal(rig.kiosk.faults.poi, 0);
}

static void test_a_poi_assigned_to_the_bot_ignores_the_controller(void **state)
{
    struct kiosk_config config = small;
    (void)state;
    config.bot[0] = 1;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    glide(100, 3);
    frames(10);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_BOT);
}

static void test_a_permanently_lost_display_ends_the_loop(void **state)
{
    (void)state;
    rig.display.gone_at = 3;
    frames(3);
    assert_int_equal(frame_after(FRAME_NS), KIOSK_DISPLAY_LOST);
}

static void test_the_game_continues_while_the_display_is_unplugged(void **state)
{
    (void)state;
    frames(10);
    rig.display.away = 1;
    const uint32_t tick = rig.kiosk.core.game.tick, shown = rig.display.present_count;
    rig.kicks = 0;
    frames(300);
    assert_int_equal(rig.kiosk.core.game.tick, tick + 600u);
    assert_int_equal(rig.kicks, 300);
    assert_int_equal(rig.display.present_count, shown);
    assert_int_equal(rig.kiosk.faults.display, 1); /* The loss of the display counts as one fault,
                                                      although many frames fail. */
    /* The kiosk tries to reopen the display once a second instead of in every frame. */
    assert_in_range(rig.display.open_count, 4, 5);
    rig.display.away = 0;
    frames(62);
    assert_true(rig.display.present_count > shown);
    assert_int_equal(rig.display.scene.tick, rig.kiosk.scene.tick);
}

static void test_a_monitor_that_is_off_at_the_start_is_used_later(void **state)
{
    (void)state;
    rig.display.away = rig.display.needs_open = 1;
    frames(120);
    assert_int_equal(rig.kiosk.core.game.tick, 240);
    rig.display.away = 0;
    frames(62);
    assert_true(rig.display.present_count > 0);
}

static void test_the_orientation_is_kept_while_the_display_is_unplugged(void **state)
{
    (void)state;
    rig.kiosk.input.upright = 1;
    rig.display.away = 1;
    frames(3);
    assert_int_equal(rig.kiosk.input.upright, 1);
}

static void test_one_failed_present_is_counted_as_one_fault(void **state)
{
    (void)state;
    rig.display.fail_at = 3;
    frames(10);
    assert_int_equal(rig.kiosk.faults.display, 1);
}

static void test_closing_the_window_ends_the_loop(void **state)
{
    (void)state;
    frames(1);
    rig.display.quit = 1;
    assert_int_equal(frame_after(FRAME_NS), KIOSK_QUIT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_no_pose_is_used_twice_while_the_controller_moves),
        TEST(test_a_disconnected_poi_keeps_its_pose_and_reconnects_within_a_second),
        TEST(test_the_frame_loop_survives_an_unplug_at_any_report),
        TEST(test_a_controller_without_reports_keeps_its_pose),
        TEST(test_a_kiosk_without_a_controller_reports_an_absent_poi),
        TEST(test_a_poi_assigned_to_the_bot_ignores_the_controller),
        TEST(test_a_permanently_lost_display_ends_the_loop),
        TEST(test_the_game_continues_while_the_display_is_unplugged),
        TEST(test_a_monitor_that_is_off_at_the_start_is_used_later),
        TEST(test_the_orientation_is_kept_while_the_display_is_unplugged),
        TEST(test_one_failed_present_is_counted_as_one_fault),
        TEST(test_closing_the_window_ends_the_loop),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
