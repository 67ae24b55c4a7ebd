/* test_statistics.c -- tests the statistics that compare techniques. Their results are compared
 * with printed tables, textbook examples, and exhaustive counts of all patterns of signs. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/bench/statistics.h"

static void expect_near(double value, double expected, double within)
{
    if (!(fabs(value - expected) <= within)) {
        fail_msg("%.9g is not %.9g", value, expected);
    }
}

static void test_student_t_matches_the_printed_table(void **state)
{
    (void)state;
    expect_near(statistics_t_95(1), 12.706, 5e-4);
    expect_near(statistics_t_95(2), 4.303, 5e-4);
    expect_near(statistics_t_95(5), 2.571, 5e-4);
    expect_near(statistics_t_95(19), 2.093, 5e-4);
    expect_near(statistics_t_95(199), 1.972, 5e-4);
    expect_near(statistics_t_95(1999), 1.961, 5e-4);
}

/* Data of ten patients from Student's paper of 1908: the hours of sleep that each patient gained by
 * two drugs, here in tenths of an hour plus 20. The mean difference is 1.58 h, with a confidence
 * interval of 0.70 to 2.46 h. */
static void test_the_confidence_interval_matches_the_sleep_data_of_student(void **state)
{
    (void)state;
    static const uint32_t first[] = { 27, 4, 18, 8, 19, 54, 57, 28, 20, 40 };
    static const uint32_t second[] = { 39, 28, 31, 21, 19, 64, 75, 36, 66, 54 };
    const struct comparison found = statistics_compare(second, first, 10);
    expect_near(found.mean_a - found.mean_b, 15.8, 1e-9);
    expect_near(found.difference, 15.8, 1e-9);
    expect_near(found.low, 7.0011, 1e-3);
    expect_near(found.high, 24.5989, 1e-3);
}

/* Data of nine patients before and after a treatment (Hollander and Wolfe, Nonparametric
 * Statistical Methods, table 3.1). The ranks of one sign sum to 40 of 45. Of the 512 patterns of
 * signs, 10 are at least as extreme. */
static void test_signed_ranks_match_a_textbook_example(void **state)
{
    (void)state;
    static const double before[] = { 1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30 };
    static const double after[] = { 0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29 };
    double differences[9];
    for (uint32_t i = 0; i < 9; i++) {
        differences[i] = before[i] - after[i];
    }
    expect_near(statistics_signed_rank_p(differences, 9), 20.0 / 512.0, 1e-12);
}

/* Returns the p value by trying all patterns of signs and counting those that are at least as
 * extreme. The tests compare statistics.c with this reference. The ranks are doubled, as in
 * count_ways(). */
static double by_every_sign(const uint32_t *ranks, uint32_t positive, uint32_t count)
{
    uint32_t sum = 0, observed = 0, as_far = 0;
    for (uint32_t i = 0; i < count; i++) {
        sum += ranks[i];
        observed += positive >> i & 1u ? ranks[i] : 0;
    }
    const uint32_t far = 2u * observed > sum ? 2u * observed - sum : sum - 2u * observed;
    for (uint32_t signs = 0; signs < 1u << count; signs++) {
        uint32_t dealt = 0;
        for (uint32_t i = 0; i < count; i++) {
            dealt += signs >> i & 1u ? ranks[i] : 0;
        }
        const uint32_t off = 2u * dealt > sum ? 2u * dealt - sum : sum - 2u * dealt;
        as_far += off >= far;
    }
    return (double)as_far / (double)(1u << count);
}

/* Catches are small numbers, so many differences between them are equal or zero. */
static void test_ties_and_zeros_match_an_exhaustive_count_of_signs(void **state)
{
    (void)state;
    static const double sizes[] = { 1, 1, 1, 2, 2, 3, 3, 3, 3, 7 };
    static const uint32_t ranks[] = { 4, 4, 4, 9, 9, 15, 15, 15, 15, 20 };
    for (uint32_t signs = 0; signs < 1u << 10; signs += 7) {
        /* Places two zeros before and two zeros after the other differences. */
        double differences[14] = { 0 };
        for (uint32_t i = 0; i < 10; i++) {
            differences[i + 2] = signs >> i & 1u ? sizes[i] : -sizes[i];
        }
        expect_near(statistics_signed_rank_p(differences, 14), by_every_sign(ranks, signs, 10),
                    1e-12);
    }
}

static void test_equal_catches_show_no_difference(void **state)
{
    (void)state;
    static const uint32_t same[] = { 3, 0, 7, 7, 1 };
    const struct comparison found = statistics_compare(same, same, 5);
    expect_near(found.p, 1.0, 0.0);
    expect_near(found.low, 0.0, 0.0);
    expect_near(found.high, 0.0, 0.0);
}

static void test_one_pair_is_not_significant(void **state)
{
    (void)state;
    const uint32_t many = 9, none = 0;
    const struct comparison found = statistics_compare(&many, &none, 1);
    expect_near(found.difference, 9.0, 0.0);
    assert_true(isinf(found.low) && isinf(found.high));
    expect_near(found.p, 1.0, 0.0);
}

/* All 200 differences have the same sign. Of the 2^200 patterns of signs, only 2 are as extreme. */
static void test_the_probability_of_two_hundred_equal_signs_is_exact(void **state)
{
    (void)state;
    uint32_t a[200], b[200];
    for (uint32_t i = 0; i < 200; i++) {
        a[i] = 5u + i % 3u;
        b[i] = 2u;
    }
    expect_near(log2(statistics_compare(a, b, 200).p), -199.0, 1e-6);
    expect_near(statistics_compare(b, a, 200).p, statistics_compare(a, b, 200).p, 0.0);
}

/* Compares the same catches again with the two samples exchanged. */
static void test_exchanging_the_samples_reverses_the_difference(void **state)
{
    (void)state;
    static const uint32_t more[] = { 5, 4, 6, 5, 7, 3, 5, 6 }, less[] = { 2, 2, 3, 1, 5, 2, 1, 2 };
    struct comparison found = statistics_compare(more, less, 8);
    assert_int_equal(statistics_verdict(&found), VERDICT_PAYS);
    found = statistics_compare(less, more, 8);
    assert_int_equal(statistics_verdict(&found), VERDICT_WRONG_WAY);
    /* All five differences have the same sign. The result is still not significant, because 2 of
     * only 32 patterns of signs are as extreme. */
    found = statistics_compare(more, less, 5);
    assert_int_equal(statistics_verdict(&found), VERDICT_NOT_SHOWN);
}

/* Nearly all values of the first sample are slightly larger, but one value of the second sample is
 * much larger. The ranks and the mean therefore disagree. */
static void test_disagreement_of_mean_and_ranks_is_not_significant(void **state)
{
    (void)state;
    static const uint32_t a[] = { 4, 5, 6, 7, 8, 9, 10, 11, 12, 0 };
    static const uint32_t b[] = { 3, 4, 5, 6, 7, 8, 9, 10, 11, 40 };
    const struct comparison found = statistics_compare(a, b, 10);
    assert_true(found.low < 0.0 && found.high > 0.0);
    assert_int_equal(statistics_verdict(&found), VERDICT_NOT_SHOWN);
    const struct comparison opposed = { .difference = 1.0, .low = -1.0, .high = 3.0, .p = 0.01 };
    assert_int_equal(statistics_verdict(&opposed), VERDICT_NOT_SHOWN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_student_t_matches_the_printed_table),
        cmocka_unit_test(test_the_confidence_interval_matches_the_sleep_data_of_student),
        cmocka_unit_test(test_signed_ranks_match_a_textbook_example),
        cmocka_unit_test(test_ties_and_zeros_match_an_exhaustive_count_of_signs),
        cmocka_unit_test(test_equal_catches_show_no_difference),
        cmocka_unit_test(test_one_pair_is_not_significant),
        cmocka_unit_test(test_exchanging_the_samples_reverses_the_difference),
        cmocka_unit_test(test_disagreement_of_mean_and_ranks_is_not_significant),
        cmocka_unit_test(test_the_probability_of_two_hundred_equal_signs_is_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
