/* test_pointer_fan.c -- a fan led by a pointer: its swing, and the poi that waits meanwhile. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/pointer/pointer_poi.h"
#include "tests/unit/support/pointer.h"

#define SWING_MS ((uint64_t)(POINTER_FAN_SWING_S * 1000.0f))

static struct pointer_fan fan;
static struct pointer_poi poi;

static int fresh(void **state)
{
    (void)state;
    pointer_fan_init(&fan, stall_view());
    pointer_poi_init(&poi, stall_view());
    return 0;
}

/* Both hands of one player hear the same reports. */
static void give(struct pointer_report given)
{
    assert_int_equal(pointer_fan_report(&fan, &given), pointer_poi_report(&poi, &given));
}

static struct shade_input fan_after(uint64_t ms)
{
    return pointer_fan_shade(&fan, ms * MS);
}

static vec3 poi_after(uint64_t ms)
{
    return pointer_poi_target(&poi, ms * MS).position_m;
}

/* ---- The fan -------------------------------------------------------------------------------- */

static void test_there_is_no_fan_until_its_key_is_held(void **state)
{
    (void)state;
    give(report(10, 300.0f, 300.0f, POINTER_DIP));
    assert_int_equal(fan_after(1000).present, 0);
}

static void test_the_fan_comes_under_the_pointer_and_follows_it(void **state)
{
    (void)state;
    give(report(1000, 500.0f, 300.0f, POINTER_FAN));
    const struct shade_input there = fan_after(1000 + SWING_MS + 1);
    assert_int_equal(there.present, 1);
    assert_float_equal(there.x_m, on_water(500.0f, 300.0f).x, 1e-5f);
    assert_float_equal(there.z_m, on_water(500.0f, 300.0f).z, 1e-5f);
    assert_float_equal(there.radius_m, POINTER_FAN_RADIUS_M, 0.0f);
    give(report(2000, 700.0f, 400.0f, POINTER_FAN));
    assert_float_equal(fan_after(2000).x_m, on_water(700.0f, 400.0f).x, 1e-5f);
    assert_float_equal(fan_after(2000).z_m, on_water(700.0f, 400.0f).z, 1e-5f);
}

/* It enters and leaves over the near edge, beyond what the screen shows, and never jumps, even when
 * the key is let go in mid swing. */
static void test_the_fan_swings_in_and_out_without_a_jump(void **state)
{
    (void)state;
    struct shade_input before = { 0 };
    uint32_t seen = 0;
    for (uint64_t ms = 1000; ms < 2400; ms++) {
        if (ms == 1010 || ms == 1300) {
            give(report(ms, 640.0f, 300.0f, POINTER_FAN));
        } else if (ms == 1200 || ms == 1800) {
            give(report(ms, 640.0f, 300.0f, 0));
        }
        const struct shade_input now = fan_after(ms);
        const float near_edge_m = 0.35f + POINTER_FAN_RADIUS_M;
        if (now.present && before.present) {
            assert_true(fabsf(now.z_m - before.z_m) < 0.003f); /* 3 m/s at most. */
        } else if (now.present != before.present) {
            assert_true((now.present ? now.z_m : before.z_m) > near_edge_m);
        }
        seen += now.present;
        before = now;
    }
    assert_true(seen > 2 * SWING_MS);
    assert_int_equal(before.present, 0);
}

static void test_a_report_that_is_no_number_moves_nothing(void **state)
{
    (void)state;
    give(report(1000, 500.0f, 300.0f, POINTER_FAN));
    const struct shade_input there = fan_after(2000);
    give(report(2001, NAN, 300.0f, POINTER_FAN));
    give(report(2002, 500.0f, INFINITY, 0));
    struct pointer_report no_window = report(2003, 1.0f, 1.0f, 0);
    no_window.width_px = 0;
    give(no_window);
    const struct shade_input still = fan_after(3000);
    assert_int_equal(still.present, 1);
    assert_true(still.x_m == there.x_m && still.z_m == there.z_m);
}

/* ---- The poi meanwhile ---------------------------------------------------------------------- */

static void test_the_poi_waits_where_it_was_while_the_fan_is_led(void **state)
{
    (void)state;
    give(report(1000, 640.0f, 360.0f, 0));
    const vec3 waits = poi_after(1001);
    give(report(1100, 640.0f, 360.0f, POINTER_FAN));
    for (uint64_t ms = 1110; ms < 2000; ms += 10) {
        give(report(ms, 640.0f - (float)(ms - 1110) * 0.5f, 200.0f, POINTER_FAN));
        const vec3 now = poi_after(ms);
        assert_float_equal(now.x, waits.x, 1e-6f);
        assert_float_equal(now.y, waits.y, 1e-6f);
        assert_float_equal(now.z, waits.z, 1e-6f);
    }
}

/* One hand fans, the other scoops. */
static void test_a_waiting_poi_dips_all_the_same(void **state)
{
    (void)state;
    give(report(1000, 640.0f, 360.0f, 0));
    give(report(1100, 640.0f, 360.0f, POINTER_FAN));
    give(report(1200, 300.0f, 300.0f, POINTER_FAN | POINTER_DIP));
    const vec3 down = poi_after(1200 + 400);
    assert_float_equal(down.y, POINTER_DIP_M, 1e-4f);
    assert_true(fabsf(down.x - on_water(640.0f, 360.0f).x) < 0.02f);
}

/* Who lets the fan go has the pointer elsewhere: the poi must not leap there, or its paper would
 * tear, nor may it leap when the fan is taken up again on the way. */
static void test_the_poi_glides_back_under_the_pointer(void **state)
{
    (void)state;
    give(report(1000, 300.0f, 300.0f, 0));
    give(report(1100, 300.0f, 300.0f, POINTER_FAN));
    give(report(1500, 1000.0f, 500.0f, POINTER_FAN));
    vec3 before = poi_after(1599);
    for (uint64_t ms = 1600; ms < 4000; ms++) {
        if (ms == 1600) {
            give(report(ms, 1000.0f, 500.0f, 0));
        } else if (ms == 1900) {
            give(report(ms, 1000.0f, 500.0f, POINTER_FAN));
        } else if (ms == 2200) {
            give(report(ms, 1000.0f, 500.0f, 0));
        }
        const vec3 now = poi_after(ms);
        assert_true(v3_length(v3_sub(now, before)) < 0.0015f); /* 1.5 m/s in the air. */
        before = now;
    }
    const vec3 home = view_point_on_plane(stall_view(), (float)WIDTH / (float)HEIGHT,
                                          2.0f * 1000.0f / 1280.0f - 1.0f,
                                          1.0f - 2.0f * 500.0f / 720.0f, POINTER_HOVER_M);
    assert_float_equal(before.x, home.x, 1e-4f);
    assert_float_equal(before.z, home.z, 1e-4f);
}

/* The button is held, or was let go together with the key: it comes up first, and then glides. */
static void test_under_water_the_poi_glides_back_so_slowly_that_its_paper_lives(void **state)
{
    (void)state;
    give(report(1000, 400.0f, 300.0f, 0));
    give(report(1100, 400.0f, 300.0f, POINTER_FAN));
    give(report(1500, 800.0f, 400.0f, POINTER_FAN | POINTER_DIP));
    give(report(2500, 800.0f, 400.0f, POINTER_DIP));
    vec3 before = poi_after(2500);
    for (uint64_t ms = 2501; ms < 6000; ms++) {
        if (ms == 3000) {
            give(report(ms, 800.0f, 400.0f, 0));
        }
        const vec3 now = poi_after(ms);
        const vec3 step = v3(now.x - before.x, 0.0f, now.z - before.z);
        const int is_down = now.y < POINTER_DIP_M + 0.002f;  /* A stroke goes along the ray. */
        assert_true(!is_down || v3_length(step) < 0.00015f); /* 0.15 m/s and slower. */
        before = now;
    }
    assert_float_equal(before.y, POINTER_HOVER_M, 1e-4f);
    assert_true(before.x > on_water(760.0f, 400.0f).x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_there_is_no_fan_until_its_key_is_held, fresh),
        cmocka_unit_test_setup(test_the_fan_comes_under_the_pointer_and_follows_it, fresh),
        cmocka_unit_test_setup(test_the_fan_swings_in_and_out_without_a_jump, fresh),
        cmocka_unit_test_setup(test_a_report_that_is_no_number_moves_nothing, fresh),
        cmocka_unit_test_setup(test_the_poi_waits_where_it_was_while_the_fan_is_led, fresh),
        cmocka_unit_test_setup(test_a_waiting_poi_dips_all_the_same, fresh),
        cmocka_unit_test_setup(test_the_poi_glides_back_under_the_pointer, fresh),
        cmocka_unit_test_setup(test_under_water_the_poi_glides_back_so_slowly_that_its_paper_lives,
                               fresh),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
