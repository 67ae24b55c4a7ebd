/* test_attitude.c -- tests the rotation functions against the core's angles, and the attitude
 * filter (accelerometer and gyroscope) against the true attitude. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/attitude.h"
#include "core/base/rng.h"

#define DT_S 0.004f

static float drawn(uint32_t n, uint32_t what, float low, float high)
{
    return rng_range((struct rng_key){ 12, n, what, RNG_TEST }, low, high);
}

static void assert_near(struct angles a, struct angles b, float rad)
{
    assert_true(f_abs(f_wrap_angle(a.yaw_rad - b.yaw_rad)) < rad);
    assert_true(f_abs(f_wrap_angle(a.pitch_rad - b.pitch_rad)) < rad);
    assert_true(f_abs(f_wrap_angle(a.roll_rad - b.roll_rad)) < rad);
}

/* Returns the acceleration that a resting accelerometer measures if it is rotated by `angles`. */
static vec3 held_up(struct angles angles)
{
    const struct basis axes = vec_basis_from_angles(angles);
    return vec_basis_to_body(&axes, v3(0.0f, GRAVITY_M_S2, 0.0f));
}

static vec3 turned(struct quaternion q, vec3 v)
{
    const struct quaternion p = { 0.0f, v.x, v.y, v.z }, back = { q.w, -q.x, -q.y, -q.z };
    const struct quaternion r =
        attitude_quaternion_product(attitude_quaternion_product(q, p), back);
    return v3(r.x, r.y, r.z);
}

static void test_a_quaternion_rotates_like_the_angles_of_the_core(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 2000; n++) {
        const struct angles angles = { drawn(n, 0, -3.1f, 3.1f), drawn(n, 1, -1.5f, 1.5f),
                                       drawn(n, 2, -3.1f, 3.1f) };
        const struct basis axes = vec_basis_from_angles(angles);
        const struct quaternion q = attitude_quaternion_of_angles(angles);
        assert_true(v3_length(v3_sub(turned(q, v3(1, 0, 0)), axes.right)) < 2e-5f);
        assert_true(v3_length(v3_sub(turned(q, v3(0, 1, 0)), axes.up)) < 2e-5f);
        assert_true(v3_length(v3_sub(turned(q, v3(0, 0, 1)), axes.back)) < 2e-5f);
        assert_near(attitude_quaternion_angles(q), angles, 3e-4f);
    }
}

static void test_pitch_and_roll_at_rest_follow_from_gravity(void **state)
{
    (void)state;
    const struct angles slants[] = {
        { 0, 0, 0 }, { 0, 0.6f, 0 }, { 0, -1.2f, 0.4f }, { 0, 0.1f, -1.3f }
    };
    for (size_t i = 0; i < sizeof slants / sizeof slants[0]; i++) {
        struct attitude attitude = { 0 };
        for (uint32_t n = 0; n < 500; n++) {
            attitude_add_motion(&attitude, v3(0, 0, 0), held_up(slants[i]), DT_S);
        }
        const struct angles found = attitude_angles(&attitude, 0.0f, DT_S);
        assert_float_equal(found.pitch_rad, slants[i].pitch_rad, 2e-3f);
        assert_float_equal(found.roll_rad, slants[i].roll_rad, 2e-3f);
    }
}

static void test_a_swinging_poi_is_tracked_within_two_degrees_for_a_minute(void **state)
{
    (void)state;
    struct attitude attitude = { 0 };
    float worst_rad = 0.0f;
    struct quaternion before = attitude_quaternion_of_angles((struct angles){ 0 });
    for (uint32_t n = 0; n < 15000; n++) {
        const float t = (float)n * DT_S;
        const struct angles truth = { 0.3f * f_sin(0.7f * t), 0.7f * f_sin(2.1f * t),
                                      0.5f * f_sin(1.3f * t) };
        const struct quaternion q = attitude_quaternion_of_angles(truth);
        const struct quaternion back = { before.w, -before.x, -before.y, -before.z };
        const struct quaternion d = attitude_quaternion_product(back, q);
        const vec3 rate = n == 0 ? v3(0, 0, 0) : v3_scale(v3(d.x, d.y, d.z), 2.0f / DT_S);
        /* Adds the acceleration of a trembling hand (1 m/s^2) and the bias of an uncalibrated
         * gyroscope to the measured values. */
        vec3 pull = v3_add(held_up(truth), v3(f_sin(19.0f * t), 0.0f, f_sin(23.0f * t)));
        attitude_add_motion(&attitude, v3_add(rate, v3(0.01f, 0.0f, -0.01f)), pull, DT_S);
        before = q;
        const struct angles found = attitude_angles(&attitude, 0.0f, DT_S);
        worst_rad = f_max(worst_rad, f_abs(found.pitch_rad - truth.pitch_rad));
        worst_rad = f_max(worst_rad, f_abs(found.roll_rad - truth.roll_rad));
    }
    print_message("# pitch and roll within %.2f degrees\n", (double)(worst_rad / F_DEG));
    assert_true(worst_rad < 2.0f * F_DEG);
}

static void test_a_gyroscope_at_rest_estimates_its_bias(void **state)
{
    (void)state;
    struct attitude attitude = { 0 };
    const vec3 bias = { 0.01f, -0.03f, 0.02f };
    for (uint32_t n = 0; n < 5000; n++) {
        attitude_add_motion(&attitude, bias, v3(0, GRAVITY_M_S2, 0), DT_S);
    }
    assert_true(v3_length(v3_sub(attitude.bias_rad_s, bias)) < 2e-4f);
    const float yaw_rad = attitude_angles(&attitude, 0.0f, DT_S).yaw_rad;
    for (uint32_t n = 0; n < 15000; n++) {
        attitude_add_motion(&attitude, bias, v3(0, GRAVITY_M_S2, 0), DT_S);
    }
    /* Heading drift in the 15,000 steps, which are one minute. Without the bias correction it would
     * be 103 degrees. */
    const float drift_rad = attitude_angles(&attitude, 0.0f, DT_S).yaw_rad - yaw_rad;
    assert_true(f_abs(f_wrap_angle(drift_rad)) < 0.5f * F_DEG);
}

static void test_a_slow_rotation_is_not_taken_for_a_bias(void **state)
{
    (void)state;
    struct attitude attitude = { 0 };
    for (uint32_t n = 0; n < 2000; n++) {
        attitude_add_motion(&attitude, v3(0, 0.08f, 0), v3(0, GRAVITY_M_S2, 0), DT_S);
    }
    assert_true(v3_length(attitude.bias_rad_s) < 1e-6f);
    /* The filter defines the heading at its first reading as straight ahead (0). */
    assert_float_equal(attitude_angles(&attitude, 0.0f, DT_S).yaw_rad, 0.0f, 1e-3f);
}

static void test_only_the_heading_decays_to_straight_ahead(void **state)
{
    (void)state;
    struct attitude attitude = { 0 };
    attitude_set(&attitude, attitude_quaternion_of_angles((struct angles){ 2.0f, 0.3f, -0.2f }));
    assert_float_equal(attitude_angles(&attitude, 30.0f, DT_S).yaw_rad, 0.0f, 1e-4f);
    attitude_set(&attitude, attitude_quaternion_of_angles((struct angles){ 2.5f, 0.3f, -0.2f }));
    assert_float_equal(attitude_angles(&attitude, 30.0f, DT_S).yaw_rad, 0.5f, 1e-2f);
    struct angles found = { 0 };
    /* 7,500 steps are 30 s. In this time the heading falls to 1/e. */
    for (uint32_t n = 0; n < 7500; n++) {
        found = attitude_angles(&attitude, 30.0f, DT_S);
    }
    assert_float_equal(found.yaw_rad, 0.5f * 0.36788f, 2e-3f);
    assert_float_equal(found.pitch_rad, 0.3f, 1e-3f);
    assert_float_equal(found.roll_rad, -0.2f, 1e-3f);
}

static void test_values_that_are_not_finite_and_free_fall_change_nothing(void **state)
{
    (void)state;
    struct attitude attitude = { 0 };
    attitude_add_motion(&attitude, v3(0, 0, 0), held_up((struct angles){ 0, 0.5f, 0 }), DT_S);
    const struct attitude before = attitude;
    attitude_add_motion(&attitude, v3(__builtin_nanf(""), 0, 0), v3(0, GRAVITY_M_S2, 0), DT_S);
    attitude_add_motion(&attitude, v3(0, 0, 0), v3(0, __builtin_inff(), 0), DT_S);
    assert_memory_equal(&attitude, &before, sizeof before);
    for (uint32_t n = 0; n < 500; n++) {
        attitude_add_motion(&attitude, v3(0, 0, 0), v3(0.5f, 0, 0), DT_S);
    }
    assert_float_equal(attitude_angles(&attitude, 0.0f, DT_S).pitch_rad, 0.5f, 1e-3f);
    attitude_set(&attitude, (struct quaternion){ 0, 0, 0, 0 });
    assert_true(f_is_finite(attitude_angles(&attitude, 0.0f, DT_S).pitch_rad));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_quaternion_rotates_like_the_angles_of_the_core),
        cmocka_unit_test(test_pitch_and_roll_at_rest_follow_from_gravity),
        cmocka_unit_test(test_a_swinging_poi_is_tracked_within_two_degrees_for_a_minute),
        cmocka_unit_test(test_a_gyroscope_at_rest_estimates_its_bias),
        cmocka_unit_test(test_a_slow_rotation_is_not_taken_for_a_bias),
        cmocka_unit_test(test_only_the_heading_decays_to_straight_ahead),
        cmocka_unit_test(test_values_that_are_not_finite_and_free_fall_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
