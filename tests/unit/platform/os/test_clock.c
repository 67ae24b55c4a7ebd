/* test_clock.c -- Tests the day number and the minute of the day, which the core gets from the
 * calendar. Also tests the monotonic clock. */
#define _DEFAULT_SOURCE /* For timegm(). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/os/clock.h"

#define DAY_S 86400
#define SECONDS_TO_2000 946684800

static void test_the_date_of_every_day_of_150_years_matches_the_c_library(void **state)
{
    (void)state;
    const time_t first = SECONDS_TO_2000 + (time_t)DAY_S * 9497; /* 2026-01-01 */
    for (time_t at = first; at < first + (time_t)150 * 365 * DAY_S; at += DAY_S + 61) {
        struct tm date;
        uint16_t day, minute;
        gmtime_r(&at, &date);
        clock_civil(&date, &day, &minute);
        assert_int_equal(day, (at - SECONDS_TO_2000) / DAY_S);
        assert_int_equal(minute, at % DAY_S / 60);
    }
}

static void test_an_unset_clock_gives_no_date(void **state)
{
    static const int years[] = { 70, 100, 125, 279 };
    (void)state;
    for (size_t i = 0; i < sizeof years / sizeof years[0]; i++) {
        const struct tm date = { .tm_year = years[i], .tm_mon = 11, .tm_mday = 31, .tm_hour = 23 };
        uint16_t day = 9, minute = 9;
        clock_civil(&date, &day, &minute);
        assert_int_equal(day, 0);
        assert_int_equal(minute, 0);
    }
}

static void test_the_first_and_the_last_day_have_a_number(void **state)
{
    (void)state;
    uint16_t day, minute;
    const struct tm first = { .tm_year = 126, .tm_mon = 0, .tm_mday = 1 };
    const struct tm last = {
        .tm_year = 278, .tm_mon = 11, .tm_mday = 31, .tm_hour = 23, .tm_min = 59
    };
    clock_civil(&first, &day, &minute);
    assert_int_equal(day, 9497);
    assert_int_equal(minute, 0);
    clock_civil(&last, &day, &minute);
    assert_int_equal(day, 65378); /* Days are stored in 16 bits, and this last day still fits. */
    assert_int_equal(minute, 1439);
}

static void test_the_monotonic_clock_never_goes_back(void **state)
{
    (void)state;
    const struct hal_clock clock = clock_device();
    uint64_t before_ns = 0;
    for (uint32_t i = 0; i < 1000; i++) {
        const uint64_t now_ns = clock.ops->now_ns(clock.self);
        assert_true(now_ns >= before_ns);
        before_ns = now_ns;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_date_of_every_day_of_150_years_matches_the_c_library),
        cmocka_unit_test(test_an_unset_clock_gives_no_date),
        cmocka_unit_test(test_the_first_and_the_last_day_have_a_number),
        cmocka_unit_test(test_the_monotonic_clock_never_goes_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
