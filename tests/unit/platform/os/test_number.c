/* test_number.c -- Tests printing and parsing of numbers in any locale. */
#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "platform/os/number.h"

static double parse(const char *text)
{
    double value = -777.0;
    (void)number_parse_decimal(text, -1e9, 1e9, &value);
    return value;
}

static void test_decimals_are_parsed(void **state)
{
    static const struct {
        const char *text;
        double value;
    } right[] = {
        { "0", 0.0 },     { "-0.5", -0.5 },   { "+3", 3.0 },        { ".25", 0.25 },
        { "7.", 7.0 },    { "1e3", 1000.0 },  { "2.5E-3", 0.0025 }, { "1013.25", 1013.25 },
        { "5.25", 5.25 }, { "0007.50", 7.5 }, { "1e+2", 100.0 },
    };
    (void)state;
    for (size_t i = 0; i < sizeof right / sizeof right[0]; i++) {
        assert_true(parse(right[i].text) == right[i].value);
    }
}

static void test_an_invalid_decimal_does_not_change_the_value(void **state)
{
    static const char *const wrong[] = {
        "",    "-",     ".",     "e3",  "1e",   "1e+",
        "1,5", "0x10",  "nan",   "inf", "-inf", "1 ",
        " 1",  "1e999", "1.2.3", "--1", "1f",   "00000000000000000000000000000000000000000000",
    };
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_true(parse(wrong[i]) == -777.0);
    }
    assert_int_equal(number_parse_decimal(NULL, 0, 1, NULL), 0);
}

static void test_the_limits_of_a_range_are_included(void **state)
{
    double value = 0.0;
    (void)state;
    assert_true(number_parse_decimal("0", 0, 100, &value));
    assert_true(number_parse_decimal("100", 0, 100, &value));
    assert_false(number_parse_decimal("100.001", 0, 100, &value));
    assert_false(number_parse_decimal("-0.001", 0, 100, &value));
}

static void expect_print(double value, uint32_t decimals, const char *expected)
{
    char text[NUMBER_FIXED_MAX];
    const uint32_t length = number_print_fixed(text, value, decimals);
    assert_int_equal(length, strlen(expected));
    assert_memory_equal(text, expected, length);
}

static void test_fixed_decimals_round_half_away_from_zero(void **state)
{
    (void)state;
    expect_print(0.0, 4, "0.0000");
    expect_print(-0.00001, 4, "0.0000");
    expect_print(-18.5, 4, "-18.5000");
    expect_print(0.00005, 4, "0.0001");
    expect_print(9.99996, 4, "10.0000");
    expect_print(123456.0, 0, "123456");
    expect_print(-3.5, 0, "-4");
    expect_print(0.25, 6, "0.250000");
}

static void test_a_number_is_unchanged_by_printing_and_parsing(void **state)
{
    (void)state;
    for (int i = -2000; i <= 2000; i++) {
        const double value = (double)i * 0.0137;
        char text[NUMBER_FIXED_MAX + 1u];
        text[number_print_fixed(text, value, 4)] = '\0';
        assert_true(parse(text) - value < 0.0000501 && value - parse(text) < 0.0000501);
    }
}

int main(void)
{
    /* The locale of the user may have a decimal comma. The tests would then fail if the code
     * depended on the locale. */
    (void)setlocale(LC_ALL, "");
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_decimals_are_parsed),
        cmocka_unit_test(test_an_invalid_decimal_does_not_change_the_value),
        cmocka_unit_test(test_the_limits_of_a_range_are_included),
        cmocka_unit_test(test_fixed_decimals_round_half_away_from_zero),
        cmocka_unit_test(test_a_number_is_unchanged_by_printing_and_parsing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
