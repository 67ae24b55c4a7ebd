/* test_growth.c -- checks growth curves, which give the length of a fish at an age and the age at a
 * length. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/morph/morph.h"

static const struct growth *const wakin = &species_wakin.card.growth;

static void test_a_hatchling_has_its_true_length(void **state)
{
    (void)state;
    assert_float_equal(growth_length_m(wakin, 0.0f), 0.005f, 1e-6f);
}

/* The 2005 thesis uses the bigeye tuna as an example. Its growth curve was fitted only to adults
 * (L_inf 2.0834 m, k 0.1985 a year, t0 -0.839 years). Without a correction, a hatchling would be 32
 * cm long. */
static void test_an_adult_fit_is_corrected_at_hatching_and_kept_for_adults(void **state)
{
    (void)state;
    const struct growth bigeye = { 2.0834f, 0.1985152f, -0.839f, 0.35f, 1, { { 0.0f, 0.003f } } };
    assert_float_equal(growth_length_m(&bigeye, 0.0f), 0.003f, 1e-6f);
    assert_float_equal(growth_length_m(&bigeye, 3.0f * 365.25f), 1.11f, 0.01f);
    assert_float_equal(growth_length_m(&bigeye, 10.0f * 365.25f), 1.84f, 0.01f);
}

static void test_a_goldfish_of_three_months_has_the_length_of_stall_fish(void **state)
{
    (void)state;
    assert_float_equal(growth_length_m(wakin, 91.3f), 0.039f, 0.0039f);
    assert_float_equal(growth_length_m(wakin, 30.4f), 0.017f, 0.003f);
    assert_float_equal(growth_length_m(wakin, 3.0f * 365.25f), 0.21f, 0.005f);
}

/* Returns the measured growth of a black conger. The larva grows, shrinks during its metamorphosis
 * to an eel, and then grows again. */
static struct growth conger_growth(void)
{
    return (struct growth){ 1.4f,
                            0.15f,
                            -0.3f,
                            0.4f,
                            6,
                            { { 0.0f, 0.006f },
                              { 100.0f, 0.064f },
                              { 220.0f, 0.1255f },
                              { 260.0f, 0.0804f },
                              { 300.0f, 0.056f },
                              { 330.0f, 0.0725f } } };
}

static void test_the_growth_curve_passes_every_measured_length(void **state)
{
    (void)state;
    const struct growth conger = conger_growth();
    for (uint32_t i = 0; i < conger.point_count; i++) {
        const struct growth_point *point = &conger.points[i];
        assert_float_equal(growth_length_m(&conger, point->age_days), point->length_m, 1e-7f);
    }
}

static void test_the_growth_curve_stays_between_measured_lengths(void **state)
{
    (void)state;
    const struct growth conger = conger_growth();
    for (uint32_t i = 0; i + 1 < conger.point_count; i++) {
        const struct growth_point *from = &conger.points[i], *to = from + 1;
        for (int step = 0; step <= 1000; step++) {
            const float age_days = f_lerp(from->age_days, to->age_days, (float)step / 1000.0f);
            const float length_m = growth_length_m(&conger, age_days);
            assert_true(length_m >= f_min(from->length_m, to->length_m) - 1e-7f);
            assert_true(length_m <= f_max(from->length_m, to->length_m) + 1e-7f);
        }
    }
}

static void test_the_table_joins_the_curve_without_a_corner(void **state)
{
    (void)state;
    const struct growth conger = conger_growth();
    const float before = growth_length_m(&conger, 330.0f) - growth_length_m(&conger, 329.5f);
    const float after = growth_length_m(&conger, 330.5f) - growth_length_m(&conger, 330.0f);
    assert_true(before > 0.0f);
    assert_float_equal(after / before, 1.0f, 0.1f);
    assert_float_equal(growth_length_m(&conger, 10.0f * 365.25f), 1.10f, 0.02f);
}

/* After the last measured length, the growth curve is much higher and rises steeply. An
 * interpolation with this steep slope at its end would first fall below the last but one measured
 * length. */
static void test_a_table_does_not_fall_before_it_joins_a_steep_curve(void **state)
{
    (void)state;
    const struct growth lean = {
        1.0f, 2.0f, -2.0f, 0.05f, 3, { { 0.0f, 0.010f }, { 50.0f, 0.020f }, { 150.0f, 0.021f } }
    };
    float before = growth_length_m(&lean, 0.0f);
    for (int step = 1; step <= 1600; step++) {
        const float now = growth_length_m(&lean, 0.1f * (float)step);
        assert_true(now >= before);
        before = now;
    }
    assert_true(before > 0.05f);
}

static void test_a_length_at_three_ages_gives_the_youngest(void **state)
{
    (void)state;
    const struct growth conger = conger_growth();
    const float age_days = growth_age_days(&conger, 0.07f);
    assert_true(age_days > 100.0f && age_days < 220.0f);
    assert_float_equal(growth_length_m(&conger, age_days), 0.07f, 1e-5f);
    const float shrinking = growth_age_between(&conger, 220.0f, 300.0f, 0.07f);
    assert_true(shrinking > 260.0f && shrinking < 300.0f);
    assert_float_equal(growth_length_m(&conger, shrinking), 0.07f, 1e-5f);
    assert_true(growth_age_between(&conger, 220.0f, 300.0f, 0.05f) < 0.0f);
    assert_true(growth_age_between(&conger, 220.0f, 300.0f, 0.13f) < 0.0f);
    assert_true(growth_age_between(&conger, 220.0f, 300.0f, 0.1255f) == 220.0f);
}

static void test_growth_reports_where_it_is_monotonic(void **state)
{
    (void)state;
    const struct growth conger = conger_growth();
    assert_true(growth_is_one_way(&conger, 0.0f, 220.0f));
    assert_false(growth_is_one_way(&conger, 0.0f, 221.0f));
    assert_true(growth_is_one_way(&conger, 220.0f, 300.0f));
    assert_false(growth_is_one_way(&conger, 220.0f, 301.0f));
    assert_true(growth_is_one_way(&conger, 301.0f, 4000.0f));
    assert_false(growth_is_one_way(&conger, 50.0f, 50.0f));
}

/* At the last age of the table, the measured length is above the growth curve. The length must then
 * stay constant until the growth curve reaches it. The length must not fall to the growth curve. */
static void test_a_fish_ahead_of_its_curve_pauses_and_does_not_shrink(void **state)
{
    (void)state;
    const struct growth early = { 0.5f, 0.2f, 0.0f, 0.3f, 2, { { 0.0f, 0.01f }, { 50.0f, 0.1f } } };
    float before = 0.0f;
    for (float age_days = 0.0f; age_days < 5000.0f; age_days += 1.0f) {
        const float length_m = growth_length_m(&early, age_days);
        assert_true(length_m >= before);
        before = length_m;
    }
    assert_float_equal(growth_length_m(&early, 100.0f), 0.1f, 1e-6f);
    assert_float_equal(before, 0.5f * (1.0f - f_exp(-0.2f * 4999.0f / 365.25f)), 1e-3f);
}

static void test_a_fish_never_shrinks(void **state)
{
    (void)state;
    float before = 0.0f;
    for (float age_days = 0.0f; age_days < 15000.0f; age_days += 0.5f) {
        const float length_m = growth_length_m(wakin, age_days);
        assert_true(length_m >= before);
        before = length_m;
    }
}

static void test_age_and_length_are_inverse_functions(void **state)
{
    (void)state;
    for (float length_m = 0.006f; length_m < 0.24f; length_m *= 1.03f) {
        const float age_days = growth_age_days(wakin, length_m);
        assert_float_equal(growth_length_m(wakin, age_days), length_m, 1e-5f);
    }
    for (float age_days = 1.0f; age_days < 3000.0f; age_days *= 1.3f) {
        const float length_m = growth_length_m(wakin, age_days);
        assert_float_equal(growth_age_days(wakin, length_m), age_days, 0.1f);
    }
}

static void test_impossible_lengths_give_the_ends_of_life(void **state)
{
    (void)state;
    assert_float_equal(growth_age_days(wakin, 0.001f), 0.0f, 0.0f);
    assert_float_equal(growth_age_days(wakin, -1.0f), 0.0f, 0.0f);
    assert_float_equal(growth_age_days(wakin, 1.0f), 40.0f * 365.25f, 1.0f);
}

static void test_an_age_before_hatching_fails_an_assertion(void **state)
{
    (void)state;
    expect_assert_failure(growth_length_m(wakin, -1.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_hatchling_has_its_true_length),
        cmocka_unit_test(test_an_adult_fit_is_corrected_at_hatching_and_kept_for_adults),
        cmocka_unit_test(test_a_goldfish_of_three_months_has_the_length_of_stall_fish),
        cmocka_unit_test(test_the_growth_curve_passes_every_measured_length),
        cmocka_unit_test(test_the_growth_curve_stays_between_measured_lengths),
        cmocka_unit_test(test_the_table_joins_the_curve_without_a_corner),
        cmocka_unit_test(test_a_table_does_not_fall_before_it_joins_a_steep_curve),
        cmocka_unit_test(test_a_length_at_three_ages_gives_the_youngest),
        cmocka_unit_test(test_growth_reports_where_it_is_monotonic),
        cmocka_unit_test(test_a_fish_ahead_of_its_curve_pauses_and_does_not_shrink),
        cmocka_unit_test(test_a_fish_never_shrinks),
        cmocka_unit_test(test_age_and_length_are_inverse_functions),
        cmocka_unit_test(test_impossible_lengths_give_the_ends_of_life),
        cmocka_unit_test(test_an_age_before_hatching_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
