/* test_timing.c -- Tests the histogram that counts durations, for example of frames. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/kiosk/frame_pacer.h"

#define MS 1000000ull

static struct frame_timing timing;

static int clear(void **state)
{
    (void)state;
    memset(&timing, 0, sizeof timing);
    return 0;
}

static void test_an_empty_histogram_has_zero_quantiles(void **state)
{
    (void)state;
    assert_int_equal(frame_timing_quantile_ns(&timing, 0.5), 0);
}

static void test_the_median_and_p99_of_100_values_are_the_50th_and_99th(void **state)
{
    (void)state;
    for (uint64_t i = 1; i <= 100; i++) {
        frame_timing_add(&timing, i * MS);
    }
    assert_in_range(frame_timing_quantile_ns(&timing, 0.5), 50 * MS, 50 * MS + TIMING_BIN_NS);
    assert_in_range(frame_timing_quantile_ns(&timing, 0.99), 99 * MS, 99 * MS + TIMING_BIN_NS);
}

static void test_a_value_beyond_the_bins_is_reported_as_the_maximum(void **state)
{
    (void)state;
    frame_timing_add(&timing, 5 * MS);
    frame_timing_add(&timing, 11000 * MS);
    frame_timing_add(&timing, 12000 * MS);
    assert_int_equal(frame_timing_quantile_ns(&timing, 0.99), 12000 * MS);
    assert_in_range(frame_timing_quantile_ns(&timing, 0.3), 5 * MS, 5 * MS + TIMING_BIN_NS);
}

static void test_slow_frame_times_are_accurate_to_20_ms(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < 100; i++) {
        frame_timing_add(&timing, 400 * MS + i * 50 * MS);
    }
    assert_in_range(frame_timing_quantile_ns(&timing, 0.5), 2840 * MS, 2870 * MS);
    assert_in_range(frame_timing_quantile_ns(&timing, 0.01), 400 * MS, 420 * MS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_an_empty_histogram_has_zero_quantiles, clear),
        cmocka_unit_test_setup(test_the_median_and_p99_of_100_values_are_the_50th_and_99th, clear),
        cmocka_unit_test_setup(test_a_value_beyond_the_bins_is_reported_as_the_maximum, clear),
        cmocka_unit_test_setup(test_slow_frame_times_are_accurate_to_20_ms, clear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
