/* test_resample.c -- one pose a tick, and none used twice. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/kiosk/resample.h"

#define MS 1000000ull

static struct poi_sample at(uint64_t ms, float x)
{
    return (struct poi_sample){ .time_ns = ms * MS, .target.position_m.x = x };
}

static struct resampler with(const struct poi_sample *samples, uint32_t count)
{
    struct resampler resampler;
    memset(&resampler, 0, sizeof resampler);
    for (uint32_t i = 0; i < count; i++) {
        assert_int_equal(resample_push(&resampler, &samples[i]), 1);
    }
    return resampler;
}

static void test_the_newest_tick_gets_the_newest_reading_exactly(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(7, 0.3f), at(16, 0.1f) };
    const struct resampler resampler = with(samples, 3);
    assert_true(resample_at(&resampler, 1, 2).position_m.x == 0.1f);
}

static void test_ticks_between_lie_on_the_path_between_readings(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(8, 0.8f), at(16, 0.0f) };
    const struct resampler resampler = with(samples, 3);
    assert_float_equal(resample_at(&resampler, 0, 4).position_m.x, 0.4f, 1e-6f);
    assert_float_equal(resample_at(&resampler, 1, 4).position_m.x, 0.8f, 1e-6f);
    assert_float_equal(resample_at(&resampler, 2, 4).position_m.x, 0.4f, 1e-6f);
}

/* The point of it all: 60 readings a second and 120 ticks a second must not make 2v, 0, 2v. */
static void test_a_steady_hand_has_a_steady_speed_at_every_tick(void **state)
{
    (void)state;
    struct resampler resampler;
    memset(&resampler, 0, sizeof resampler);
    float last = 0.0f;
    for (uint32_t frame = 0; frame < 60; frame++) {
        const struct poi_sample sample = at(16 * frame, 0.004f * (float)frame);
        resample_push(&resampler, &sample);
        for (uint32_t tick = 0; tick < 2; tick++) {
            const float x = resample_at(&resampler, tick, 2).position_m.x;
            if (frame > 1) {
                assert_float_equal(x - last, 0.002f, 1e-6f);
            }
            last = x;
        }
        resample_end(&resampler);
    }
}

static void test_readings_of_tickless_frames_wait_for_the_next_tick(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(4, 0.1f), at(8, 0.2f) };
    struct resampler resampler = with(samples, 3);
    assert_float_equal(resample_at(&resampler, 0, 1).position_m.x, 0.2f, 0.0f);
    resample_end(&resampler);
    const struct poi_sample next = at(16, 0.4f);
    resample_push(&resampler, &next);
    assert_float_equal(resample_at(&resampler, 0, 2).position_m.x, 0.3f, 1e-6f);
}

static void test_angles_turn_the_short_way_round(void **state)
{
    (void)state;
    struct poi_sample samples[] = { at(0, 0.0f), at(10, 0.0f) };
    samples[0].target.angles.yaw_rad = 3.0f;
    samples[1].target.angles.yaw_rad = -3.0f;
    const struct resampler resampler = with(samples, 2);
    const float middle = resample_at(&resampler, 0, 2).angles.yaw_rad;
    assert_float_equal(fabsf(middle), 3.14159265f, 1e-5f);
}

static void test_a_reading_that_is_no_number_is_refused(void **state)
{
    (void)state;
    const struct poi_sample good = at(0, 0.5f);
    struct resampler resampler = with(&good, 1);
    struct poi_sample bad = at(5, 0.0f);
    bad.target.position_m.y = NAN;
    assert_int_equal(resample_push(&resampler, &bad), 0);
    bad = at(5, INFINITY);
    assert_int_equal(resample_push(&resampler, &bad), 0);
    bad = at(5, 0.0f);
    bad.target.angles.roll_rad = NAN;
    assert_int_equal(resample_push(&resampler, &bad), 0);
    assert_float_equal(resample_at(&resampler, 0, 1).position_m.x, 0.5f, 0.0f);
}

static void test_a_reading_from_where_no_hand_is_is_refused(void **state)
{
    (void)state;
    const struct poi_sample good = at(0, 0.5f);
    struct resampler resampler = with(&good, 1);
    const struct poi_sample edge = at(5, 1000.0f);
    assert_int_equal(resample_push(&resampler, &edge), 1);
    struct poi_sample bad = at(6, -3e38f); /* its difference to 3e38 would be no number */
    assert_int_equal(resample_push(&resampler, &bad), 0);
    bad = at(6, 0.0f);
    bad.target.angles.yaw_rad = 1001.0f;
    assert_int_equal(resample_push(&resampler, &bad), 0);
}

static void test_time_that_goes_back_keeps_the_newest_reading(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(9, 0.9f), at(3, 0.3f), at(3, 0.4f) };
    const struct resampler resampler = with(samples, 4);
    assert_float_equal(resample_at(&resampler, 0, 1).position_m.x, 0.4f, 0.0f);
    for (uint32_t tick = 0; tick < 24; tick++) {
        assert_true(isfinite(resample_at(&resampler, tick, 24).position_m.x));
    }
}

static void test_a_path_of_no_length_in_time_divides_by_nothing(void **state)
{
    (void)state;
    struct poi_sample samples[] = { at(1, 0.0f), at(1, 0.5f), at(1, 1.0f) };
    samples[2].time_ns += 1;
    const struct resampler resampler = with(samples, 3);
    for (uint32_t tick = 0; tick < 24; tick++) {
        assert_in_range((int)(1000.0f * resample_at(&resampler, tick, 24).position_m.x), 0, 1000);
    }
}

static void test_too_many_readings_lose_the_oldest_and_keep_both_ends(void **state)
{
    (void)state;
    struct resampler resampler;
    memset(&resampler, 0, sizeof resampler);
    for (uint32_t i = 0; i <= 1000; i++) {
        const struct poi_sample sample = at(i, (float)i);
        assert_int_equal(resample_push(&resampler, &sample), 1);
    }
    assert_int_equal(resampler.count, RESAMPLE_MAX);
    assert_float_equal(resampler.path[0].target.position_m.x, 0.0f, 0.0f);
    assert_float_equal(resample_at(&resampler, 0, 1).position_m.x, 1000.0f, 0.0f);
    assert_float_equal(resample_at(&resampler, 0, 2).position_m.x, 500.0f, 1e-2f);
}

static void test_asking_before_any_reading_is_a_bug(void **state)
{
    (void)state;
    struct resampler resampler;
    memset(&resampler, 0, sizeof resampler);
    expect_assert_failure(resample_at(&resampler, 0, 1));
    const struct poi_sample sample = at(0, 0.0f);
    resample_push(&resampler, &sample);
    expect_assert_failure(resample_at(&resampler, 1, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_newest_tick_gets_the_newest_reading_exactly),
        cmocka_unit_test(test_ticks_between_lie_on_the_path_between_readings),
        cmocka_unit_test(test_a_steady_hand_has_a_steady_speed_at_every_tick),
        cmocka_unit_test(test_readings_of_tickless_frames_wait_for_the_next_tick),
        cmocka_unit_test(test_angles_turn_the_short_way_round),
        cmocka_unit_test(test_a_reading_that_is_no_number_is_refused),
        cmocka_unit_test(test_a_reading_from_where_no_hand_is_is_refused),
        cmocka_unit_test(test_time_that_goes_back_keeps_the_newest_reading),
        cmocka_unit_test(test_a_path_of_no_length_in_time_divides_by_nothing),
        cmocka_unit_test(test_too_many_readings_lose_the_oldest_and_keep_both_ends),
        cmocka_unit_test(test_asking_before_any_reading_is_a_bug),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
