/* test_pointer_fan.c -- tests the hand-held fan that a player moves over the water with the mouse,
 * and the poi that stays in place meanwhile. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/pointer/pointer_poi.h"
#include "tests/unit/support/pointer.h"

#define SWING_MS ((uint64_t)(POINTER_FAN_SWING_S * 1000.0f))

static struct pointer_poi poi;

static int fresh(void **state)
{
    (void)state;
    pointer_poi_init(&poi, festival_view());
    return 0;
}

/* Passes a report of the mouse to the poi. */
static void send_report(struct pointer_report given)
{
    pointer_poi_report(&poi, &given);
}

static struct shade_input fan_after(uint64_t ms)
{
    return pointer_fan_shade(&poi, ms * MS);
}

static vec3 poi_after(uint64_t ms)
{
    return pointer_poi_target(&poi, ms * MS).position_m;
}

/* ---- The fan -------------------------------------------------------------------------------- */

static void test_there_is_no_fan_unless_its_key_is_held(void **state)
{
    (void)state;
    send_report(report(10, 300.0f, 300.0f, POINTER_DIP));
    assert_int_equal(fan_after(1000).present, 0);
}

static void test_the_fan_moves_under_the_pointer_and_follows_it(void **state)
{
    (void)state;
    send_report(report(1000, 500.0f, 300.0f, POINTER_FAN));
    const struct shade_input there = fan_after(1000 + SWING_MS + 1);
    assert_int_equal(there.present, 1);
    assert_float_equal(there.x_m, on_water(500.0f, 300.0f).x, 1e-5f);
    assert_float_equal(there.z_m, on_water(500.0f, 300.0f).z, 1e-5f);
    assert_float_equal(there.radius_m, POINTER_FAN_RADIUS_M, 0.0f);
    send_report(report(2000, 700.0f, 400.0f, POINTER_FAN));
    assert_float_equal(fan_after(2000).x_m, on_water(700.0f, 400.0f).x, 1e-5f);
    assert_float_equal(fan_after(2000).z_m, on_water(700.0f, 400.0f).z, 1e-5f);
}

/* The fan must enter and leave across the near edge of the visible area without a jump, even if its
 * key is released while the fan is still entering. */
static void test_the_fan_enters_and_leaves_without_a_jump(void **state)
{
    (void)state;
    struct shade_input before = { 0 };
    uint32_t seen = 0;
    for (uint64_t ms = 1000; ms < 2400; ms++) {
        if (ms == 1010 || ms == 1300) {
            send_report(report(ms, 640.0f, 300.0f, POINTER_FAN));
        } else if (ms == 1200 || ms == 1800) {
            send_report(report(ms, 640.0f, 300.0f, 0));
        }
        const struct shade_input now = fan_after(ms);
        const float near_edge_m = 0.35f + POINTER_FAN_RADIUS_M;
        if (now.present && before.present) {
            /* 3 mm in 1 ms is 3 m/s, the maximum speed of the fan. */
            assert_true(fabsf(now.z_m - before.z_m) < 0.003f);
        } else if (now.present != before.present) {
            assert_true((now.present ? now.z_m : before.z_m) > near_edge_m);
        }
        seen += now.present;
        before = now;
    }
    assert_true(seen > 2 * SWING_MS);
    assert_int_equal(before.present, 0);
}

static void test_a_report_that_is_not_finite_moves_nothing(void **state)
{
    (void)state;
    send_report(report(1000, 500.0f, 300.0f, POINTER_FAN));
    const struct shade_input there = fan_after(2000);
    send_report(report(2001, NAN, 300.0f, POINTER_FAN));
    send_report(report(2002, 500.0f, INFINITY, 0));
    struct pointer_report no_window = report(2003, 1.0f, 1.0f, 0);
    no_window.width_px = 0;
    send_report(no_window);
    const struct shade_input still = fan_after(3000);
    assert_int_equal(still.present, 1);
    assert_true(still.x_m == there.x_m && still.z_m == there.z_m);
}

/* ---- The waiting poi ------------------------------------------------------------------------ */

static void test_the_poi_stays_in_place_while_the_fan_moves(void **state)
{
    (void)state;
    send_report(report(1000, 640.0f, 360.0f, 0));
    const vec3 waits = poi_after(1001);
    send_report(report(1100, 640.0f, 360.0f, POINTER_FAN));
    for (uint64_t ms = 1110; ms < 2000; ms += 10) {
        send_report(report(ms, 640.0f - (float)(ms - 1110) * 0.5f, 200.0f, POINTER_FAN));
        const vec3 now = poi_after(ms);
        assert_float_equal(now.x, waits.x, 1e-6f);
        assert_float_equal(now.y, waits.y, 1e-6f);
        assert_float_equal(now.z, waits.z, 1e-6f);
    }
}

/* While the mouse moves the fan, the mouse button still dips the poi. */
static void test_a_waiting_poi_can_still_dip(void **state)
{
    (void)state;
    send_report(report(1000, 640.0f, 360.0f, 0));
    send_report(report(1100, 640.0f, 360.0f, POINTER_FAN));
    send_report(report(1200, 300.0f, 300.0f, POINTER_FAN | POINTER_DIP));
    const vec3 down = poi_after(1200 + (uint64_t)(DIP_DOWN_S * 1000.0f) + 1);
    assert_float_equal(down.y, DIP_DEPTH_M, 1e-4f);
    assert_true(fabsf(down.x - on_water(640.0f, 360.0f).x) < 0.02f);
}

/* When the fan key is released, the pointer is far from the poi. The poi must return to the pointer
 * at a limited speed, because a jump would tear the paper. A second press of the fan key on the way
 * must not cause a jump either. */
static void test_the_poi_returns_under_the_pointer_at_limited_speed(void **state)
{
    (void)state;
    send_report(report(1000, 300.0f, 300.0f, 0));
    send_report(report(1100, 300.0f, 300.0f, POINTER_FAN));
    send_report(report(1500, 1000.0f, 500.0f, POINTER_FAN));
    vec3 before = poi_after(1599);
    for (uint64_t ms = 1600; ms < 4000; ms++) {
        if (ms == 1600) {
            send_report(report(ms, 1000.0f, 500.0f, 0));
        } else if (ms == 1900) {
            send_report(report(ms, 1000.0f, 500.0f, POINTER_FAN));
        } else if (ms == 2200) {
            send_report(report(ms, 1000.0f, 500.0f, 0));
        }
        const vec3 now = poi_after(ms);
        /* 1.5 mm in 1 ms is 1.5 m/s, the maximum speed in air. */
        assert_true(v3_length(v3_sub(now, before)) < 0.0015f);
        before = now;
    }
    const vec3 home = view_point_on_plane(festival_view(), (float)WIDTH / (float)HEIGHT,
                                          2.0f * 1000.0f / 1280.0f - 1.0f,
                                          1.0f - 2.0f * 500.0f / 720.0f, DIP_HOVER_M);
    assert_float_equal(before.x, home.x, 1e-4f);
    assert_float_equal(before.z, home.z, 1e-4f);
}

/* The poi is under water when the fan key is released. The poi must first rise and only then move
 * under the pointer, even if the mouse button is still held. */
static void test_under_water_the_poi_returns_at_a_speed_safe_for_the_paper(void **state)
{
    (void)state;
    send_report(report(1000, 400.0f, 300.0f, 0));
    send_report(report(1100, 400.0f, 300.0f, POINTER_FAN));
    send_report(report(1500, 800.0f, 400.0f, POINTER_FAN | POINTER_DIP));
    send_report(report(2500, 800.0f, 400.0f, POINTER_DIP));
    vec3 before = poi_after(2500);
    for (uint64_t ms = 2501; ms < 6000; ms++) {
        if (ms == 3000) {
            send_report(report(ms, 800.0f, 400.0f, 0));
        }
        const vec3 now = poi_after(ms);
        const vec3 step = v3(now.x - before.x, 0.0f, now.z - before.z);
        /* Only the speed at the full depth is limited. A rising poi may move sideways faster,
         * because a lift follows the line of sight. */
        const int is_down = now.y < DIP_DEPTH_M + 0.002f;
        /* 0.15 mm in 1 ms is 0.15 m/s, the maximum speed under water. */
        assert_true(!is_down || v3_length(step) < 0.00015f);
        before = now;
    }
    assert_float_equal(before.y, DIP_HOVER_M, 1e-4f);
    assert_true(before.x > on_water(760.0f, 400.0f).x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_there_is_no_fan_unless_its_key_is_held, fresh),
        cmocka_unit_test_setup(test_the_fan_moves_under_the_pointer_and_follows_it, fresh),
        cmocka_unit_test_setup(test_the_fan_enters_and_leaves_without_a_jump, fresh),
        cmocka_unit_test_setup(test_a_report_that_is_not_finite_moves_nothing, fresh),
        cmocka_unit_test_setup(test_the_poi_stays_in_place_while_the_fan_moves, fresh),
        cmocka_unit_test_setup(test_a_waiting_poi_can_still_dip, fresh),
        cmocka_unit_test_setup(test_the_poi_returns_under_the_pointer_at_limited_speed, fresh),
        cmocka_unit_test_setup(test_under_water_the_poi_returns_at_a_speed_safe_for_the_paper,
                               fresh),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
