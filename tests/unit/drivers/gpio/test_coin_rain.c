/* test_coin_rain.c -- a day of coins, contacts that bounce, and a kiosk that is busy elsewhere. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_signal.h" /* The shell is linked. */
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

/* Jams are told and so are knocks, but for the few that a late kernel makes sparks of; and pairs of
 * sparks where the reader was not run to see that they were no coin. */
static void assert_told(const struct rain_result *result)
{
    assert_in_range(result->faults - result->doubtful, result->jams + result->knocks * 9u / 10u,
                    result->jams + result->knocks);
    assert_in_range(result->doubtful, 1, result->sparks);
}

static void test_no_coin_is_lost_or_doubled_by_a_queue_of_64_with_numbers(void **state)
{
    (void)state;
    const struct rain_result result = rain(1);
    assert_exact(&result);
    assert_told(&result);
}

static void test_no_coin_is_lost_or_doubled_by_a_queue_of_16_without(void **state)
{
    (void)state;
    const struct rain_result result = rain(0);
    assert_exact(&result);
    assert_told(&result);
}

static void test_frames_take_seconds_and_the_reader_is_not_always_run(void **state)
{
    (void)state;
    const struct rain_result result = rain(1);
    assert_true(result.longest_frame_ns > 2500000000u);
    assert_true(result.longest_stall_ns > 90000000u);
    assert_true(result.blinks > COINS); /* The kernel was late again and again. */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_coin_is_lost_or_doubled_by_a_queue_of_64_with_numbers),
        cmocka_unit_test(test_no_coin_is_lost_or_doubled_by_a_queue_of_16_without),
        cmocka_unit_test(test_frames_take_seconds_and_the_reader_is_not_always_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
