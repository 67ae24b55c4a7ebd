/* test_cubic.c -- checks the cubic curve through the points of a table. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/fmath.h"
#include "core/morph/cubic.h"

#define STEPS 1000

static const struct cubic_point steps[] = { { 0.0f, 1.0f },  { 1.0f, 1.0f }, { 2.0f, 4.0f },
                                            { 2.5f, 9.0f },  { 6.0f, 9.5f }, { 7.0f, 3.0f },
                                            { 9.0f, 2.99f }, { 9.1f, 0.0f } };
#define COUNT (sizeof steps / sizeof steps[0])

static void test_the_curve_passes_through_every_point(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < COUNT; i++) {
        assert_true(cubic_curve(steps, COUNT, steps[i].at, NULL) == steps[i].value);
    }
}

static void assert_no_overshoot(const struct cubic_point *points, uint32_t count)
{
    for (uint32_t i = 0; i + 1 < count; i++) {
        const float low = f_min(points[i].value, points[i + 1].value);
        const float high = f_max(points[i].value, points[i + 1].value);
        for (int step = 0; step <= STEPS; step++) {
            const float at = f_lerp(points[i].at, points[i + 1].at, (float)step / STEPS);
            const float value = cubic_curve(points, count, at, NULL);
            assert_true(value >= low - 1e-5f && value <= high + 1e-5f);
        }
    }
}

static void test_the_curve_stays_between_two_adjacent_points(void **state)
{
    (void)state;
    assert_no_overshoot(steps, COUNT);
}

/* At the curve's end, the slope that is computed from three points is 7.5. The slope must be
 * limited to 3, because the curve would otherwise overshoot the small rise beside the steep
 * fall. */
static void test_the_curve_does_not_overshoot_at_its_ends(void **state)
{
    (void)state;
    const struct cubic_point first[3] = { { 0.0f, 0.0f }, { 1.0f, 1.0f }, { 2.0f, -11.0f } };
    const struct cubic_point last[3] = { { 0.0f, -11.0f }, { 1.0f, 1.0f }, { 2.0f, 0.0f } };
    assert_float_equal(cubic_slope(first, 3, 0), 3.0f, 1e-6f);
    assert_float_equal(cubic_slope(last, 3, 2), -3.0f, 1e-6f);
    assert_no_overshoot(first, 3);
    assert_no_overshoot(last, 3);
}

static void test_the_curve_is_constant_outside_its_ends(void **state)
{
    (void)state;
    assert_true(cubic_curve(steps, COUNT, -5.0f, NULL) == 1.0f);
    assert_true(cubic_curve(steps, COUNT, 50.0f, NULL) == 0.0f);
}

static void test_two_points_give_a_straight_line(void **state)
{
    (void)state;
    const struct cubic_point line[2] = { { 1.0f, 2.0f }, { 3.0f, 8.0f } };
    for (int step = 0; step <= STEPS; step++) {
        const float at = 1.0f + 2.0f * (float)step / STEPS;
        assert_float_equal(cubic_curve(line, 2, at, NULL), 2.0f + 3.0f * (at - 1.0f), 1e-5f);
    }
}

static void test_equal_slopes_are_kept(void **state)
{
    (void)state;
    const struct cubic_point line[4] = {
        { 0.0f, 0.0f }, { 1.0f, 2.0f }, { 1.5f, 3.0f }, { 4.0f, 8.0f }
    };
    for (uint32_t i = 0; i < 4; i++) {
        assert_float_equal(cubic_slope(line, 4, i), 2.0f, 1e-6f);
    }
}

static void test_fewer_than_two_points_fail_an_assertion(void **state)
{
    (void)state;
    expect_assert_failure(cubic_curve(steps, 1, 0.0f, NULL));
    expect_assert_failure(cubic_slope(steps, 3, 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_curve_passes_through_every_point),
        cmocka_unit_test(test_the_curve_stays_between_two_adjacent_points),
        cmocka_unit_test(test_the_curve_does_not_overshoot_at_its_ends),
        cmocka_unit_test(test_the_curve_is_constant_outside_its_ends),
        cmocka_unit_test(test_two_points_give_a_straight_line),
        cmocka_unit_test(test_equal_slopes_are_kept),
        cmocka_unit_test(test_fewer_than_two_points_fail_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
