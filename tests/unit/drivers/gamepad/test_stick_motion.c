/* test_stick_motion.c -- a hand that sticks fly: how fast, how far, and that it costs no paper. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/tank/preset.h"
#include "drivers/gamepad/stick_motion.h"
#include "tests/unit/support/pointer.h"

#define NEVER_NUMBER (0.0f / 0.0f)

static struct stick_motion fly;
static uint64_t now_ms;

static void begin(void)
{
    stick_motion_init(&fly, stall_view());
    now_ms = 1000;
    stick_motion_report(&fly, &(struct stick_report){ .time_ns = now_ms * MS });
}

static void push(vec3 way, vec3 twist, uint32_t buttons)
{
    const struct stick_report said = {
        .time_ns = now_ms * MS, .push = way, .twist = twist, .buttons = buttons
    };
    stick_motion_report(&fly, &said);
}

static struct poi_target after(uint64_t ms)
{
    now_ms += ms;
    return stick_motion_target(&fly, now_ms * MS);
}

static const vec3 none = { 0.0f, 0.0f, 0.0f };

static void test_full_push_is_full_speed_in_the_air_and_less_in_the_water(void **state)
{
    (void)state;
    begin();
    push(v3(-0.6f, 0, 0), none, 0);
    after(400);
    push(v3(1, 0, 0), none, 0);
    const float from_m = after(400).position_m.x;
    const float air_m_s = (after(200).position_m.x - from_m) / 0.2f;
    assert_float_equal(air_m_s, STICK_MOTION_AIR_M_S, 0.01f);
    begin();
    push(v3(-1, 0, 0), none, POINTER_DIP);
    after(600);
    push(v3(1, 0, 0), none, POINTER_DIP);
    const float wet_m = after(500).position_m.x;
    assert_float_equal((after(300).position_m.x - wet_m) / 0.3f, STICK_MOTION_WATER_M_S, 0.01f);
}

static void test_a_little_push_goes_a_little_way(void **state)
{
    (void)state;
    begin();
    push(v3(0.2f, 0, 0), none, 0);
    after(300);
    const float from_m = after(0).position_m.x;
    const float slow_m_s = (after(300).position_m.x - from_m) / 0.3f;
    assert_true(slow_m_s > 0.0f && slow_m_s < 0.1f * STICK_MOTION_AIR_M_S);
}

static void test_however_it_is_pushed_it_stays_within_what_is_seen(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        begin();
        push(v3(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f), none, 0);
        for (uint32_t j = 0; j < 40; j++) {
            after(200);
        }
        const vec3 end = after(0).position_m;
        const struct basis axes = view_basis(stall_view());
        const vec3 body = vec_basis_to_body(&axes, v3_sub(end, stall_view()->eye_m));
        const float tan_y = view_half_height_tan(stall_view(), 16.0f / 9.0f);
        assert_true(f_abs(body.x / body.z) < 1.2f * tan_y * 16.0f / 9.0f);
        assert_true(f_abs(body.y / body.z) < 1.2f * tan_y);
        assert_in_range((int)(1000.0f * (end.y + 1.0f)),
                        (int)(1000.0f * (1.0f + STICK_MOTION_LOW_M)) - 1,
                        (int)(1000.0f * (1.0f + STICK_MOTION_HIGH_M)) + 1);
    }
}

/* All bowls of all presets are within its reach, or a catch could not be landed. */
static void test_every_bowl_is_within_reach(void **state)
{
    (void)state;
    for (int preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        const struct tank_preset *tank = tank_preset((enum tank_preset_id)preset);
        stick_motion_init(&fly, &tank->view);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            assert_true(f_abs(tank->bowl_m[i].x) < fly.high_m[0].x);
            assert_true(f_abs(tank->bowl_m[i].x) < fly.high_m[1].x);
            assert_true(tank->bowl_m[i].z < fly.high_m[0].z);
            assert_true(tank->bowl_m[i].z < fly.high_m[1].z);
        }
    }
}

static void test_it_goes_the_same_way_however_often_it_is_asked(void **state)
{
    (void)state;
    begin();
    push(v3(0.7f, 0.3f, -0.5f), v3(0.2f, 0, 0), POINTER_DIP);
    const vec3 once = after(240).position_m;
    begin();
    push(v3(0.7f, 0.3f, -0.5f), v3(0.2f, 0, 0), POINTER_DIP);
    for (uint32_t i = 0; i < 30; i++) {
        after(8);
    }
    const vec3 often = after(0).position_m;
    assert_float_equal(v3_length(v3_sub(once, often)), 0.0f, 1e-4f);
}

static void test_after_a_second_without_a_look_it_is_where_it_was(void **state)
{
    (void)state;
    begin();
    push(v3(1, 0, 0), none, 0);
    const vec3 before = after(100).position_m;
    assert_float_equal(after(5000).position_m.x, before.x, 1e-6f);
}

static void test_no_step_from_tick_to_tick_is_a_leap(void **state)
{
    (void)state;
    begin();
    vec3 before = after(8).position_m;
    for (uint32_t i = 0; i < 600; i++) {
        const float side = i / 60u % 2u ? 1.0f : -1.0f;
        push(v3(side, -side, side), v3(side, side, side), i / 45u % 2u ? POINTER_DIP : 0u);
        const vec3 now = after(8).position_m;
        assert_true(v3_length(v3_sub(now, before)) < 0.011f); /* 1.3 m/s: dip and flight. */
        before = now;
    }
}

static void test_level_brings_a_pucks_ring_back_over_the_water(void **state)
{
    (void)state;
    begin();
    push(v3(0, -1, 0), none, 0);
    assert_true(after(900).position_m.y < -0.05f);
    push(none, none, POINTER_LEVEL);
    after(900);
    assert_float_equal(after(600).position_m.y, DIP_HOVER_M, 2e-3f);
}

static void test_what_is_no_number_pushes_nothing(void **state)
{
    (void)state;
    begin();
    push(v3(NEVER_NUMBER, 1.0f / 0.0f, -1.0f / 0.0f), v3(NEVER_NUMBER, NEVER_NUMBER, 0), 0);
    const vec3 at = after(300).position_m;
    assert_float_equal(at.x, 0.0f, 1e-6f);
    assert_float_equal(at.y, DIP_HOVER_M, 1e-6f);
    push(v3(1e30f, 0, 0), none, 0); /* And what is too much is all there is. */
    assert_true(after(200).position_m.x < 0.2f * STICK_MOTION_AIR_M_S);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_full_push_is_full_speed_in_the_air_and_less_in_the_water),
        cmocka_unit_test(test_a_little_push_goes_a_little_way),
        cmocka_unit_test(test_however_it_is_pushed_it_stays_within_what_is_seen),
        cmocka_unit_test(test_every_bowl_is_within_reach),
        cmocka_unit_test(test_it_goes_the_same_way_however_often_it_is_asked),
        cmocka_unit_test(test_after_a_second_without_a_look_it_is_where_it_was),
        cmocka_unit_test(test_no_step_from_tick_to_tick_is_a_leap),
        cmocka_unit_test(test_level_brings_a_pucks_ring_back_over_the_water),
        cmocka_unit_test(test_what_is_no_number_pushes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
