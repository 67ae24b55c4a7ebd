/* test_growth.c -- how long wakin is at an age, and how old at a length. */
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

/* A fit to adults alone would have hatchlings of 32 cm: facts of the bigeye tuna, the thesis' own
 * example (L_inf 2.0834 m, k 0.1985 a year, t0 -0.839 years). */
static void test_an_adult_fit_is_mended_at_hatching_and_kept_for_adults(void **state)
{
    (void)state;
    const struct growth bigeye = { 2.0834f, 0.1985152f, -0.839f, 0.35f, 1, { { 0.0f, 0.003f } } };
    assert_float_equal(growth_length_m(&bigeye, 0.0f), 0.003f, 1e-6f);
    assert_float_equal(growth_length_m(&bigeye, 3.0f * 365.25f), 1.11f, 0.01f);
    assert_float_equal(growth_length_m(&bigeye, 10.0f * 365.25f), 1.84f, 0.01f);
}

static void test_a_goldfish_of_three_months_is_a_fish_of_the_stall(void **state)
{
    (void)state;
    assert_float_equal(growth_length_m(wakin, 91.3f), 0.039f, 0.0039f);
    assert_float_equal(growth_length_m(wakin, 30.4f), 0.017f, 0.003f);
    assert_float_equal(growth_length_m(wakin, 3.0f * 365.25f), 0.21f, 0.005f);
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

static void test_age_and_length_are_each_others_inverse(void **state)
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

static void test_ages_of_lengths_that_no_fish_has_are_the_ends_of_life(void **state)
{
    (void)state;
    assert_float_equal(growth_age_days(wakin, 0.001f), 0.0f, 0.0f);
    assert_float_equal(growth_age_days(wakin, -1.0f), 0.0f, 0.0f);
    assert_float_equal(growth_age_days(wakin, 1.0f), 40.0f * 365.25f, 1.0f);
}

static void test_an_age_before_hatching_is_a_bug(void **state)
{
    (void)state;
    expect_assert_failure(growth_length_m(wakin, -1.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_hatchling_has_its_true_length),
        cmocka_unit_test(test_an_adult_fit_is_mended_at_hatching_and_kept_for_adults),
        cmocka_unit_test(test_a_goldfish_of_three_months_is_a_fish_of_the_stall),
        cmocka_unit_test(test_a_fish_never_shrinks),
        cmocka_unit_test(test_age_and_length_are_each_others_inverse),
        cmocka_unit_test(test_ages_of_lengths_that_no_fish_has_are_the_ends_of_life),
        cmocka_unit_test(test_an_age_before_hatching_is_a_bug),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
