/* test_announcements.c -- checks the announcements of the remaining time ("one minute left" and
 * others). Each must be made exactly once and at the right tick. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/game/phases.h"
#include "core/input.h"

#define SECONDS(s) ((s) * CORE_TICK_HZ)

static uint32_t count_calls(enum time_call call, uint32_t round_s)
{
    uint32_t count = 0;
    for (uint32_t tick = 0; tick <= SECONDS(round_s + 5u); tick++) {
        count += round_call_at(tick, SECONDS(round_s)) == call;
    }
    return count;
}

static void test_a_three_minute_round_has_the_announcements_of_the_championship(void **state)
{
    (void)state;
    const uint32_t total = SECONDS(180u);
    assert_int_equal(round_call_at(SECONDS(60u), total), CALL_ONE_MINUTE);
    assert_int_equal(round_call_at(SECONDS(120u), total), CALL_TWO_MINUTES);
    assert_int_equal(round_call_at(SECONDS(170u), total), CALL_TEN_SECONDS);
    for (uint32_t second = 175; second < 180; second++) {
        assert_int_equal(round_call_at(SECONDS(second), total), CALL_COUNTDOWN);
    }
    assert_int_equal(round_call_at(total, total), CALL_TIME);
}

static void test_each_announcement_is_made_once(void **state)
{
    (void)state;
    static const uint32_t counts[] = { [CALL_ONE_MINUTE] = 1,
                                       [CALL_TWO_MINUTES] = 1,
                                       [CALL_TEN_SECONDS] = 1,
                                       [CALL_COUNTDOWN] = 5,
                                       [CALL_TIME] = 1 };
    for (enum time_call call = CALL_ONE_MINUTE; call <= CALL_TIME; call++) {
        assert_int_equal(count_calls(call, 180), counts[call]);
    }
}

static void test_a_short_round_has_only_the_announcements_within_its_time(void **state)
{
    (void)state;
    assert_int_equal(count_calls(CALL_ONE_MINUTE, 60), 0);
    /* A round of 70 s has no announcement "one minute left", because it would follow only 10 s
     * after the start. */
    assert_int_equal(count_calls(CALL_ONE_MINUTE, 70), 0);
    assert_int_equal(count_calls(CALL_ONE_MINUTE, 71), 1);
    assert_int_equal(count_calls(CALL_TEN_SECONDS, 70), 1);
    assert_int_equal(count_calls(CALL_TWO_MINUTES, 120), 0);
    /* A round of 10 s begins with the announcement "ten seconds left". */
    assert_int_equal(count_calls(CALL_TEN_SECONDS, 10), 1);
    assert_int_equal(count_calls(CALL_COUNTDOWN, 10), 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_three_minute_round_has_the_announcements_of_the_championship),
        cmocka_unit_test(test_each_announcement_is_made_once),
        cmocka_unit_test(test_a_short_round_has_only_the_announcements_within_its_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
