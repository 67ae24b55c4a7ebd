/* test_pace.c -- time into ticks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "platform/kiosk/pace.h"

#define MS 1000000ull
#define S 1000000000ull

/* A pace whose first frame is over, at time 1 s. */
static struct pace running(void)
{
    struct pace pace = { 0 };
    pace_ticks_due(&pace, S);
    return pace;
}

static void test_the_first_frame_shows_something_at_once(void **state)
{
    (void)state;
    struct pace pace = { 0 };
    assert_int_equal(pace_ticks_due(&pace, 123456789), 2);
    assert_int_equal(pace.dropped, 0);
}

static void test_a_60_hz_frame_is_two_ticks_however_it_jitters(void **state)
{
    (void)state;
    struct pace pace = running();
    uint64_t now = S;
    for (uint32_t i = 0; i < 600; i++) {
        now += 16666667ull + (i % 3) * 1300000ull - 1300000ull;
        assert_int_equal(pace_ticks_due(&pace, now), 2);
    }
    assert_int_equal(pace.owed, 0);
}

static void test_a_frame_outside_the_snap_is_counted_as_it_is(void **state)
{
    (void)state;
    struct pace pace = running();
    assert_int_equal(pace_ticks_due(&pace, S + 15 * MS), 1);     /* 1.8 ticks */
    assert_int_equal(pace_ticks_due(&pace, S + 15 * MS + 19 * MS), 3); /* 0.8 + 2.28 */
}

static void test_odd_frames_lose_no_time_over_a_minute(void **state)
{
    (void)state;
    struct pace pace = running();
    uint64_t now = S;
    uint64_t ticks = 0;
    for (uint32_t i = 0; i < 60000 / 7; i++) {
        now += 7 * MS;
        ticks += pace_ticks_due(&pace, now);
    }
    const uint64_t expected = (now - S) * CORE_TICK_HZ / S;
    assert_in_range(ticks, expected - 1, expected);
}

static void test_a_fast_screen_gets_frames_without_ticks(void **state)
{
    (void)state;
    struct pace pace = running();
    assert_int_equal(pace_ticks_due(&pace, S + 4 * MS), 0);
    assert_int_equal(pace_ticks_due(&pace, S + 8 * MS), 0);
    assert_int_equal(pace_ticks_due(&pace, S + 12 * MS), 1);
}

static void test_a_stall_runs_24_ticks_and_counts_the_rest_as_dropped(void **state)
{
    (void)state;
    struct pace pace = running();
    assert_int_equal(pace_ticks_due(&pace, 2 * S), 24);
    assert_int_equal(pace.dropped, 96);
    assert_int_equal(pace_ticks_due(&pace, 2 * S + 25 * MS), 3);
    assert_int_equal(pace.dropped, 96);
}

static void test_exactly_the_cap_drops_nothing(void **state)
{
    (void)state;
    struct pace pace = running();
    assert_int_equal(pace_ticks_due(&pace, S + 200 * MS), 24);
    assert_int_equal(pace.dropped, 0);
}

static void test_a_clock_that_stands_or_goes_back_owes_nothing(void **state)
{
    (void)state;
    struct pace pace = running();
    assert_int_equal(pace_ticks_due(&pace, S), 0);
    assert_int_equal(pace_ticks_due(&pace, S / 2), 0);
    assert_int_equal(pace_ticks_due(&pace, S / 2 + 25 * MS), 3);
}

static void test_a_wild_clock_cannot_overflow(void **state)
{
    (void)state;
    struct pace pace = running();
    assert_int_equal(pace_ticks_due(&pace, UINT64_MAX), 24);
    assert_int_equal(pace.dropped, 3600u * CORE_TICK_HZ - 24u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_first_frame_shows_something_at_once),
        cmocka_unit_test(test_a_60_hz_frame_is_two_ticks_however_it_jitters),
        cmocka_unit_test(test_a_frame_outside_the_snap_is_counted_as_it_is),
        cmocka_unit_test(test_odd_frames_lose_no_time_over_a_minute),
        cmocka_unit_test(test_a_fast_screen_gets_frames_without_ticks),
        cmocka_unit_test(test_a_stall_runs_24_ticks_and_counts_the_rest_as_dropped),
        cmocka_unit_test(test_exactly_the_cap_drops_nothing),
        cmocka_unit_test(test_a_clock_that_stands_or_goes_back_owes_nothing),
        cmocka_unit_test(test_a_wild_clock_cannot_overflow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
