/* test_frame_pacer.c -- Tests the conversion of elapsed time into ticks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "platform/kiosk/frame_pacer.h"

#define MS 1000000ull
#define S 1000000000ull

/* Returns a frame pacer whose first frame was at 1 s. */
static struct frame_pacer running(void)
{
    struct frame_pacer pace = { 0 };
    frame_pacer_ticks_due(&pace, S);
    return pace;
}

static void test_the_first_frame_has_a_tick(void **state)
{
    (void)state;
    struct frame_pacer pace = { 0 };
    assert_int_equal(frame_pacer_ticks_due(&pace, 123456789), 2);
    assert_int_equal(pace.dropped, 0);
}

static void test_a_60_hz_frame_has_two_ticks_at_any_jitter(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    uint64_t now = S;
    for (uint32_t i = 0; i < 600; i++) {
        now += 16666667ull + (i % 3) * 1300000ull - 1300000ull;
        assert_int_equal(frame_pacer_ticks_due(&pace, now), 2);
    }
}

static void test_frame_jitter_of_three_milliseconds_causes_no_judder(void **state)
{
    (void)state;
    static const int64_t early_ms[] = { 0, 3, -3, 2, -2, 1, 3, 0, -3, -1, 3, -3 };
    struct frame_pacer pace = running();
    for (uint32_t i = 0; i < 1200; i++) {
        const uint64_t even = S + (i + 1) * 16666667ull;
        const uint64_t now = even - (uint64_t)(early_ms[i % 12] * (int64_t)MS / 2);
        assert_int_equal(frame_pacer_ticks_due(&pace, now), 2);
    }
    pace = running();
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 18300000), 2);
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 18300000 + 15 * MS), 2);
}

static void test_a_display_of_nearly_60_hz_never_judders(void **state)
{
    (void)state;
    static const uint64_t frame_ns[] = { 16683350, 16650000, 16400000, 16950000 };
    for (uint32_t k = 0; k < 4; k++) {
        struct frame_pacer pace = running();
        for (uint64_t i = 1; i <= 36000; i++) {
            assert_int_equal(frame_pacer_ticks_due(&pace, S + i * frame_ns[k]), 2);
        }
    }
}

static void test_ticks_at_75_and_50_hz_match_the_clock_over_a_minute(void **state)
{
    (void)state;
    static const uint64_t frame_ns[] = { 13333333, 20000000 };
    for (uint32_t k = 0; k < 2; k++) {
        struct frame_pacer pace = running();
        uint64_t ticks = 0;
        const uint64_t count = 60 * S / frame_ns[k];
        for (uint64_t i = 1; i <= count; i++) {
            ticks += frame_pacer_ticks_due(&pace, S + i * frame_ns[k]);
        }
        assert_in_range(ticks, 7199, 7201);
    }
}

static void test_a_frame_far_from_60_hz_is_not_rounded(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    /* 12 ms are 1.44 ticks of 1/120 s, so one tick is due and 0.44 ticks remain. */
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 12 * MS), 1);
    /* The remaining 0.44 ticks and 22 ms (2.64 ticks) are three whole ticks. */
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 12 * MS + 22 * MS), 3);
}

/* ---- Tests of the sleep time after a frame -------------------------------------------------- */

/* Returns the sleep time in ns after the last of `count` frames that each take `took_ns`. */
static uint64_t rest_after(struct frame_pacer_sleep *rest, uint32_t count, uint64_t took_ns)
{
    uint64_t rest_ns = 0;
    for (uint32_t i = 0; i < count; i++) {
        rest_ns = frame_pacer_sleep_ns(rest, took_ns);
    }
    return rest_ns;
}

static void test_frames_without_vsync_are_limited_to_60_a_second(void **state)
{
    (void)state;
    struct frame_pacer_sleep rest = { 0 };
    assert_int_equal(rest_after(&rest, 60, 6 * MS), 16666666 - 6 * MS);
    assert_int_equal(rest_after(&rest, 1, 20 * MS), 0);
}

static void test_frames_paced_by_vsync_do_not_sleep(void **state)
{
    (void)state;
    struct frame_pacer_sleep rest = { 0 };
    for (uint32_t i = 0; i < 1000; i++) {
        assert_int_equal(frame_pacer_sleep_ns(&rest, 16600000 + (i % 2 ? 900000 : -900000)), 0);
    }
}

static void test_irregular_frames_match_the_clock_over_a_minute(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    uint64_t now = S;
    uint64_t ticks = 0;
    for (uint32_t i = 0; i < 60000 / 7; i++) {
        now += 7 * MS;
        ticks += frame_pacer_ticks_due(&pace, now);
    }
    const uint64_t expected = (now - S) * CORE_TICK_HZ / S;
    assert_in_range(ticks, expected - 1, expected);
}

static void test_a_fast_display_has_frames_without_ticks(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 4 * MS), 0);
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 8 * MS), 0);
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 12 * MS), 1);
}

static void test_a_delayed_frame_runs_60_ticks_and_counts_the_rest_as_dropped(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    assert_int_equal(frame_pacer_ticks_due(&pace, 2 * S), 60);
    assert_int_equal(pace.dropped, 60);
    assert_int_equal(frame_pacer_ticks_due(&pace, 2 * S + 25 * MS), 3);
    assert_int_equal(pace.dropped, 60);
}

static void test_a_frame_of_exactly_the_tick_limit_drops_nothing(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    assert_int_equal(frame_pacer_ticks_due(&pace, S + 500 * MS), 60);
    assert_int_equal(pace.dropped, 0);
}

static void test_a_stopped_or_reversed_clock_gives_no_ticks(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    assert_int_equal(frame_pacer_ticks_due(&pace, S), 0);
    assert_int_equal(frame_pacer_ticks_due(&pace, S / 2), 0);
    assert_int_equal(frame_pacer_ticks_due(&pace, S / 2 + 25 * MS), 3);
}

static void test_a_large_clock_jump_does_not_overflow(void **state)
{
    (void)state;
    struct frame_pacer pace = running();
    assert_int_equal(frame_pacer_ticks_due(&pace, UINT64_MAX), 60);
    assert_int_equal(pace.dropped, 3600u * CORE_TICK_HZ - 60u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_first_frame_has_a_tick),
        cmocka_unit_test(test_a_60_hz_frame_has_two_ticks_at_any_jitter),
        cmocka_unit_test(test_frame_jitter_of_three_milliseconds_causes_no_judder),
        cmocka_unit_test(test_a_display_of_nearly_60_hz_never_judders),
        cmocka_unit_test(test_ticks_at_75_and_50_hz_match_the_clock_over_a_minute),
        cmocka_unit_test(test_a_frame_far_from_60_hz_is_not_rounded),
        cmocka_unit_test(test_frames_without_vsync_are_limited_to_60_a_second),
        cmocka_unit_test(test_frames_paced_by_vsync_do_not_sleep),
        cmocka_unit_test(test_irregular_frames_match_the_clock_over_a_minute),
        cmocka_unit_test(test_a_fast_display_has_frames_without_ticks),
        cmocka_unit_test(test_a_delayed_frame_runs_60_ticks_and_counts_the_rest_as_dropped),
        cmocka_unit_test(test_a_frame_of_exactly_the_tick_limit_drops_nothing),
        cmocka_unit_test(test_a_stopped_or_reversed_clock_gives_no_ticks),
        cmocka_unit_test(test_a_large_clock_jump_does_not_overflow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
