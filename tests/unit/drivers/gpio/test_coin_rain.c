/* test_coin_rain.c -- tests that all coins of a simulated day are counted. The contacts bounce,
 * some frames are slow, and the GPIO thread sometimes stops for a while. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* This header makes tests.mk link the test with shell.a, the library of drivers and platform. */
#include "drivers/gpio/gpio_thread.h"
#include "tests/gpio/coin_rain.h"

#define COINS 20000u

static struct rain_result rain(uint8_t is_second)
{
    const struct rain_config config = { .coins = COINS, .seed = 77, .is_second = is_second };
    return coin_rain(&config);
}

static void assert_exact(const struct rain_result *result)
{
    assert_int_equal(result->coins, COINS);
    assert_int_equal(result->counted, COINS);
    assert_int_equal(result->early, 0);
    assert_int_equal(result->late, 0);
}

/* Asserts that all jams and at least 90 % of the short pulses were reported as faults. If the
 * kernel reads the level late, it takes some short pulses for glitches, which are not reported. Two
 * glitches can also be taken for a coin. Such a pair is reported as doubtful, unless the GPIO
 * thread polled the level between the glitches. */
static void assert_faults_reported(const struct rain_result *result)
{
    assert_in_range(result->faults - result->doubtful, result->jams + result->knocks * 9u / 10u,
                    result->jams + result->knocks);
    assert_in_range(result->doubtful, 1, result->sparks);
}

static void test_a_queue_of_64_numbered_edges_loses_and_doubles_no_coin(void **state)
{
    (void)state;
    const struct rain_result result = rain(1);
    assert_exact(&result);
    assert_faults_reported(&result);
}

static void test_a_queue_of_16_unnumbered_edges_loses_and_doubles_no_coin(void **state)
{
    (void)state;
    const struct rain_result result = rain(0);
    assert_exact(&result);
    assert_faults_reported(&result);
}

static void test_the_simulated_day_contains_long_frames_and_reader_stalls(void **state)
{
    (void)state;
    const struct rain_result result = rain(1);
    assert_true(result.longest_frame_ns > 2500000000u);
    assert_true(result.longest_stall_ns > 90000000u);
    /* The simulated kernel read the level of the line too late more often than once per coin. */
    assert_true(result.blinks > COINS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_queue_of_64_numbered_edges_loses_and_doubles_no_coin),
        cmocka_unit_test(test_a_queue_of_16_unnumbered_edges_loses_and_doubles_no_coin),
        cmocka_unit_test(test_the_simulated_day_contains_long_frames_and_reader_stalls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
