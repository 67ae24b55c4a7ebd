/* test_gamepad_imu_filter.c -- Tests the tilt that is computed from a gamepad's gyroscope and
 * accelerometer, in physical units. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/gamepad/gamepad_decoder.h"

#define MS_NS 1000000ull
#define BEGIN_NS (5000u * MS_NS)

static float nan_of(float zero)
{
    return zero / zero;
}

/* Returns a filter in equilibrium for a level gamepad. */
static struct gamepad_imu_filter level_pad(void)
{
    struct gamepad_imu_filter tilt = { 0 };
    assert_int_equal(gamepad_imu_filter_add_gravity(&tilt, BEGIN_NS, v3(0.0f, 9.81f, 0.0f)), 0);
    assert_int_equal(gamepad_imu_filter_add_rotation(&tilt, BEGIN_NS, v3(0.0f, 0.0f, 0.0f)), 0);
    gamepad_imu_filter_level(&tilt);
    return tilt;
}

static void test_the_tilt_is_the_angular_rate_times_the_time(void **state)
{
    (void)state;
    struct gamepad_imu_filter tilt = level_pad();
    /* The gamepad turns at 3 rad/s for 0.1 s. */
    for (uint64_t ms = 0; ms <= 100; ms += 10) {
        gamepad_imu_filter_add_rotation(&tilt, BEGIN_NS + ms * MS_NS, v3(3.0f, 0.0f, 0.0f));
    }
    const struct angles angles = gamepad_imu_filter_at(&tilt, BEGIN_NS + 100u * MS_NS, 0);
    const float band_rad = 2.0f * F_DEG;
    assert_float_equal(f_abs(angles.pitch_rad), 0.3f - band_rad, 0.005f);
    assert_float_equal(angles.roll_rad, 0.0f, 1e-4f);
}

static void test_an_old_angular_rate_is_not_extrapolated_further(void **state)
{
    (void)state;
    struct gamepad_imu_filter tilt = level_pad();
    gamepad_imu_filter_add_rotation(&tilt, BEGIN_NS, v3(0.0f, 0.0f, 1.0f));
    const struct angles late = gamepad_imu_filter_at(&tilt, BEGIN_NS + 10000u * MS_NS, 0);
    /* A rotation is extrapolated for at most 0.25 s after the newest report. */
    assert_true(f_abs(late.roll_rad) > 0.15f);
    assert_true(f_abs(late.roll_rad) < 0.25f);
}

static void test_a_time_before_the_newest_report_changes_nothing(void **state)
{
    (void)state;
    struct gamepad_imu_filter tilt = level_pad();
    gamepad_imu_filter_add_rotation(&tilt, BEGIN_NS, v3(2.0f, 0.0f, 0.0f));
    const struct angles before = gamepad_imu_filter_at(&tilt, BEGIN_NS - 100u * MS_NS, 0);
    assert_float_equal(before.pitch_rad, 0.0f, 0.0f);
}

static void test_gravity_corrects_the_drift_within_seconds(void **state)
{
    (void)state;
    struct gamepad_imu_filter tilt = level_pad();
    /* Gravity as measured by a gamepad that is tilted by 0.5 rad. */
    const vec3 leaning = v3(0.0f, 9.81f * 0.8776f, 9.81f * 0.4794f);
    gamepad_imu_filter_add_gravity(&tilt, BEGIN_NS + 100u * MS_NS, leaning);
    const float soon = f_abs(gamepad_imu_filter_at(&tilt, BEGIN_NS + 100u * MS_NS, 0).pitch_rad);
    for (uint64_t ms = 200; ms <= 3000; ms += 100) {
        gamepad_imu_filter_add_gravity(&tilt, BEGIN_NS + ms * MS_NS, leaning);
    }
    const float late = f_abs(gamepad_imu_filter_at(&tilt, BEGIN_NS + 3000u * MS_NS, 0).pitch_rad);
    assert_true(soon < 0.1f); /* One report after 0.1 s corrects only about a sixth of the error of
                                 0.5 rad. */
    assert_float_equal(late, 0.5f - 2.0f * F_DEG, 0.02f);
}

static void test_shaking_and_values_that_are_not_finite_change_nothing(void **state)
{
    (void)state;
    struct gamepad_imu_filter tilt = level_pad();
    assert_int_equal(gamepad_imu_filter_add_gravity(&tilt, BEGIN_NS + MS_NS, v3(0.0f, 0.0f, 14.0f)),
                     0);
    assert_int_equal(gamepad_imu_filter_add_gravity(&tilt, BEGIN_NS + MS_NS, v3(0.0f, 0.0f, 6.0f)),
                     0);
    assert_int_equal(
        gamepad_imu_filter_add_gravity(&tilt, BEGIN_NS + MS_NS, v3(0.0f, nan_of(0.0f), 0.0f)), -1);
    assert_int_equal(
        gamepad_imu_filter_add_rotation(&tilt, BEGIN_NS + MS_NS, v3(nan_of(0.0f), 0.0f, 0.0f)), -1);
    const struct angles angles = gamepad_imu_filter_at(&tilt, BEGIN_NS + MS_NS, 0);
    assert_float_equal(angles.pitch_rad, 0.0f, 0.0f);
    assert_float_equal(angles.roll_rad, 0.0f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_tilt_is_the_angular_rate_times_the_time),
        cmocka_unit_test(test_an_old_angular_rate_is_not_extrapolated_further),
        cmocka_unit_test(test_a_time_before_the_newest_report_changes_nothing),
        cmocka_unit_test(test_gravity_corrects_the_drift_within_seconds),
        cmocka_unit_test(test_shaking_and_values_that_are_not_finite_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
