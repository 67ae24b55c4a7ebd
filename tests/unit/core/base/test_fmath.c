/* test_fmath.c -- checks that the core's mathematical functions differ from the host's libm by at
 * most their documented errors. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/fmath.h"

struct sweep {
    float (*ours)(float);
    double (*theirs)(double);
    float low, high;
    double error_max;
    int relative;
};

static void check_sweep(const struct sweep *sweep)
{
    const uint32_t steps = 200000;
    for (uint32_t i = 0; i <= steps; i++) {
        const float x = sweep->low + (sweep->high - sweep->low) * ((float)i / (float)steps);
        const double expected = sweep->theirs((double)x);
        double error = fabs((double)sweep->ours(x) - expected);
        if (sweep->relative) {
            error /= fabs(expected);
        }
        if (!(error <= sweep->error_max)) {
            fail_msg("at %.9g: %.9g, not %.9g", (double)x, (double)sweep->ours(x), expected);
        }
    }
}

static void test_sine_and_cosine_stay_within_two_millionths(void **state)
{
    (void)state;
    check_sweep(&(struct sweep){ f_sin, sin, -1000.0f, 1000.0f, 2e-6, 0 });
    check_sweep(&(struct sweep){ f_cos, cos, -1000.0f, 1000.0f, 2e-6, 0 });
}

static void test_exponential_has_a_relative_error_below_three_millionths(void **state)
{
    (void)state;
    check_sweep(&(struct sweep){ f_exp, exp, -80.0f, 80.0f, 3e-6, 1 });
}

static void test_exponential_saturates_instead_of_overflowing(void **state)
{
    (void)state;
    assert_true(f_is_finite(f_exp(1e6f)));
    assert_true(f_exp(-1e6f) >= 0.0f);
    assert_true(f_exp(-1e6f) < 1e-37f);
}

static void test_logarithm_has_an_error_below_three_millionths(void **state)
{
    (void)state;
    check_sweep(&(struct sweep){ f_log, log, 1e-6f, 2.0f, 3e-6, 0 });
    check_sweep(&(struct sweep){ f_log, log, 2.0f, 1e6f, 3e-6, 0 });
}

static void test_arc_cosine_accepts_values_that_rounding_moved_past_one(void **state)
{
    (void)state;
    check_sweep(&(struct sweep){ f_acos, acos, -1.0f, 1.0f, 1e-4, 0 });
    assert_true(f_acos(1.0000001f) == 0.0f);
    assert_true(fabsf(f_acos(-1.0000001f) - F_PI) < 1e-4f);
}

static void test_atan2_covers_all_four_quadrants(void **state)
{
    (void)state;
    for (int i = -720; i <= 720; i++) {
        const double angle = i * 3.14159265358979 / 720.0 * 0.9999;
        const float y = (float)(3.7 * sin(angle)), x = (float)(3.7 * cos(angle));
        assert_true(fabs((double)f_atan2(y, x) - atan2((double)y, (double)x)) < 3e-6);
    }
    assert_true(f_atan2(0.0f, 0.0f) == 0.0f);
}

static void test_floor_rounds_toward_minus_infinity(void **state)
{
    (void)state;
    assert_true(f_floor(1.5f) == 1.0f);
    assert_true(f_floor(-1.5f) == -2.0f);
    assert_true(f_floor(-2.0f) == -2.0f);
    assert_true(f_floor(0.0f) == 0.0f);
    assert_true(f_floor(8388607.5f) == 8388607.0f);
    assert_true(f_floor(-8388607.5f) == -8388608.0f);
    /* These values are outside the range of int32_t. A function that converted them to int32_t
     * would return a wrong result. */
    assert_true(f_floor(3e9f) == 3e9f);
    assert_true(f_floor(-3e38f) == -3e38f);
}

static void test_a_wrapped_angle_has_the_same_direction(void **state)
{
    (void)state;
    for (int i = -4000; i <= 4000; i++) {
        const float angle = (float)i * 0.01f;
        const float wrapped = f_wrap_angle(angle);
        assert_true(wrapped >= -F_PI - 1e-5f && wrapped < F_PI + 1e-5f);
        assert_true(fabs(sin((double)angle) - sin((double)wrapped)) < 1e-4);
    }
}

static void test_infinities_and_nan_are_not_finite(void **state)
{
    (void)state;
    assert_false(f_is_finite(INFINITY));
    assert_false(f_is_finite(-INFINITY));
    assert_false(f_is_finite(NAN));
    assert_true(f_is_finite(3.4e38f));
    assert_true(f_is_finite(0.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sine_and_cosine_stay_within_two_millionths),
        cmocka_unit_test(test_exponential_has_a_relative_error_below_three_millionths),
        cmocka_unit_test(test_exponential_saturates_instead_of_overflowing),
        cmocka_unit_test(test_logarithm_has_an_error_below_three_millionths),
        cmocka_unit_test(test_arc_cosine_accepts_values_that_rounding_moved_past_one),
        cmocka_unit_test(test_atan2_covers_all_four_quadrants),
        cmocka_unit_test(test_floor_rounds_toward_minus_infinity),
        cmocka_unit_test(test_a_wrapped_angle_has_the_same_direction),
        cmocka_unit_test(test_infinities_and_nan_are_not_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
