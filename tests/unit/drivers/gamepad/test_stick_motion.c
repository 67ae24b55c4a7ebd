/* test_stick_motion.c -- tests the speed and the range of a poi that is moved with a stick. The
 * speed must be so low that the motion does not tear the paper. */
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
    stick_motion_init(&fly, festival_view());
    now_ms = 1000;
    stick_motion_report(&fly, &(struct stick_report){ .time_ns = now_ms * MS });
}

static void push(vec3 way, vec3 twist, uint32_t buttons)
{
    const struct stick_report report = {
        .time_ns = now_ms * MS, .push = way, .twist = twist, .buttons = buttons
    };
    stick_motion_report(&fly, &report);
}

static struct poi_target after(uint64_t ms)
{
    now_ms += ms;
    return stick_motion_target(&fly, now_ms * MS);
}

static const vec3 none = { 0.0f, 0.0f, 0.0f };

static void test_full_deflection_gives_full_speed_in_air_and_less_in_water(void **state)
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

static void test_a_small_deflection_gives_a_small_displacement(void **state)
{
    (void)state;
    begin();
    push(v3(0.2f, 0, 0), none, 0);
    after(300);
    const float from_m = after(0).position_m.x;
    const float slow_m_s = (after(300).position_m.x - from_m) / 0.3f;
    assert_true(slow_m_s > 0.0f && slow_m_s < 0.1f * STICK_MOTION_AIR_M_S);
}

static void test_the_ring_stays_within_the_visible_area(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        begin();
        push(v3(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f), none, 0);
        for (uint32_t j = 0; j < 40; j++) {
            after(200);
        }
        const vec3 end = after(0).position_m;
        const struct basis axes = view_basis(festival_view());
        const vec3 body = vec_basis_to_body(&axes, v3_sub(end, festival_view()->eye_m));
        const float tan_y = view_half_height_tan(festival_view(), 16.0f / 9.0f);
        assert_true(f_abs(body.x / body.z) < 1.2f * tan_y * 16.0f / 9.0f);
        assert_true(f_abs(body.y / body.z) < 1.2f * tan_y);
        assert_in_range((int)(1000.0f * (end.y + 1.0f)),
                        (int)(1000.0f * (1.0f + STICK_MOTION_LOW_M)) - 1,
                        (int)(1000.0f * (1.0f + STICK_MOTION_HIGH_M)) + 1);
    }
}

/* The bowls of all presets must be within range. Otherwise a fish could not be put into its
 * bowl. */
static void test_every_bowl_is_in_range(void **state)
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

static void test_the_path_does_not_depend_on_the_sample_rate(void **state)
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

static void test_the_ring_does_not_move_during_a_second_without_samples(void **state)
{
    (void)state;
    begin();
    push(v3(1, 0, 0), none, 0);
    const vec3 before = after(100).position_m;
    assert_float_equal(after(5000).position_m.x, before.x, 1e-6f);
}

static void test_no_step_between_two_ticks_is_a_pose_jump(void **state)
{
    (void)state;
    begin();
    vec3 before = after(8).position_m;
    for (uint32_t i = 0; i < 600; i++) {
        const float side = i / 60u % 2u ? 1.0f : -1.0f;
        push(v3(side, -side, side), v3(side, side, side), i / 45u % 2u ? POINTER_DIP : 0u);
        const vec3 now = after(8).position_m;
        /* 11 mm in 8 ms is about 1.4 m/s. The ring must be slower, even if it dips and moves
         * sideways at the same time. */
        assert_true(v3_length(v3_sub(now, before)) < 0.011f);
        before = now;
    }
}

/* A press of 20 ms must give a complete dip, as with a pointer (test_pointer_poi.c). */
static void test_a_short_press_completes_the_dip_from_the_near_side(void **state)
{
    (void)state;
    begin();
    const float hover_z_m = after(0).position_m.z;
    push(none, none, POINTER_DIP);
    after(20);
    push(none, none, 0);
    float nearest_m = hover_z_m, lowest_m = DIP_HOVER_M, end_z_m = 0.0f;
    for (uint32_t i = 0; i < 200; i++) {
        const vec3 now = after(5).position_m;
        nearest_m = f_max(nearest_m, now.z);
        if (now.y < lowest_m) {
            lowest_m = now.y;
            end_z_m = now.z;
        }
    }
    assert_float_equal(lowest_m, DIP_DEPTH_M, 1e-4f);
    assert_true(nearest_m > hover_z_m + 0.005f && nearest_m < hover_z_m + DIP_NEAR_M);
    /* The lift follows the line of sight away from the player, so it ends farther away than the dip
     * began. */
    assert_true(end_z_m < hover_z_m - 0.03f);
    assert_float_equal(after(0).position_m.y, DIP_HOVER_M, 1e-5f);
    assert_float_equal(after(0).position_m.z, hover_z_m, 1e-5f);
}

/* After the button is released, no pose is read for 1.5 s. The motion of the stick is not
 * integrated over a gap of more than 1 s, but the lift must still be completed. */
static void test_a_pause_without_samples_does_not_delay_the_lift(void **state)
{
    (void)state;
    begin();
    push(none, none, POINTER_DIP);
    after(20);
    push(none, none, 0);
    assert_float_equal(after(1500).position_m.y, DIP_HOVER_M, 1e-5f);
}

static void test_the_level_button_lifts_the_ring_of_a_3d_mouse_over_the_water(void **state)
{
    (void)state;
    begin();
    push(v3(0, -1, 0), none, 0);
    assert_true(after(900).position_m.y < -0.05f);
    push(none, none, POINTER_LEVEL);
    after(900);
    assert_float_equal(after(600).position_m.y, DIP_HOVER_M, 2e-3f);
}

static void test_an_input_that_is_not_finite_moves_nothing(void **state)
{
    (void)state;
    begin();
    push(v3(NEVER_NUMBER, 1.0f / 0.0f, -1.0f / 0.0f), v3(NEVER_NUMBER, NEVER_NUMBER, 0), 0);
    const vec3 at = after(300).position_m;
    assert_float_equal(at.x, 0.0f, 1e-6f);
    assert_float_equal(at.y, DIP_HOVER_M, 1e-6f);
    /* A value above full deflection counts as full deflection. */
    push(v3(1e30f, 0, 0), none, 0);
    assert_true(after(200).position_m.x < 0.2f * STICK_MOTION_AIR_M_S);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_full_deflection_gives_full_speed_in_air_and_less_in_water),
        cmocka_unit_test(test_a_small_deflection_gives_a_small_displacement),
        cmocka_unit_test(test_the_ring_stays_within_the_visible_area),
        cmocka_unit_test(test_every_bowl_is_in_range),
        cmocka_unit_test(test_the_path_does_not_depend_on_the_sample_rate),
        cmocka_unit_test(test_the_ring_does_not_move_during_a_second_without_samples),
        cmocka_unit_test(test_no_step_between_two_ticks_is_a_pose_jump),
        cmocka_unit_test(test_a_short_press_completes_the_dip_from_the_near_side),
        cmocka_unit_test(test_a_pause_without_samples_does_not_delay_the_lift),
        cmocka_unit_test(test_the_level_button_lifts_the_ring_of_a_3d_mouse_over_the_water),
        cmocka_unit_test(test_an_input_that_is_not_finite_moves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
