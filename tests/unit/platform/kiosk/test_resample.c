/* test_resample.c -- Tests how the poses of a controller are resampled to one pose per tick. No
 * reported pose may be used twice. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/kiosk/sampler.h"

#define MS 1000000ull

static struct poi_sample at(uint64_t ms, float x)
{
    return (struct poi_sample){ .time_ns = ms * MS, .target.position_m.x = x };
}

static struct sampler_path with(const struct poi_sample *samples, uint32_t count)
{
    struct sampler_path resampler;
    memset(&resampler, 0, sizeof resampler);
    for (uint32_t i = 0; i < count; i++) {
        assert_int_equal(sampler_path_push(&resampler, &samples[i]), 1);
    }
    return resampler;
}

static void test_the_newest_tick_uses_the_newest_reading_unchanged(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(7, 0.3f), at(16, 0.1f) };
    const struct sampler_path resampler = with(samples, 3);
    assert_true(sampler_path_at(&resampler, 1, 2).position_m.x == 0.1f);
}

static void test_ticks_between_readings_are_interpolated(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(8, 0.08f), at(16, 0.0f) };
    const struct sampler_path resampler = with(samples, 3);
    assert_float_equal(sampler_path_at(&resampler, 0, 4).position_m.x, 0.04f, 1e-6f);
    assert_float_equal(sampler_path_at(&resampler, 1, 4).position_m.x, 0.08f, 1e-6f);
    assert_float_equal(sampler_path_at(&resampler, 2, 4).position_m.x, 0.04f, 1e-6f);
}

/* The core has 120 ticks per second. A controller with 60 reports per second has a new position
 * only in every second tick. The resampled speed must be constant instead of alternating between
 * twice the true speed and 0. */
static void test_a_constant_speed_is_constant_at_every_tick(void **state)
{
    (void)state;
    struct sampler_path resampler;
    memset(&resampler, 0, sizeof resampler);
    float last = 0.0f;
    for (uint32_t frame = 0; frame < 60; frame++) {
        const struct poi_sample sample = at(16 * frame, 0.004f * (float)frame);
        sampler_path_push(&resampler, &sample);
        for (uint32_t tick = 0; tick < 2; tick++) {
            const float x = sampler_path_at(&resampler, tick, 2).position_m.x;
            if (frame > 1) {
                assert_float_equal(x - last, 0.002f, 1e-6f);
            }
            last = x;
        }
        sampler_path_end(&resampler);
    }
}

static void test_readings_of_frames_without_ticks_are_used_at_the_next_tick(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(4, 0.1f), at(8, 0.2f) };
    struct sampler_path resampler = with(samples, 3);
    assert_float_equal(sampler_path_at(&resampler, 0, 1).position_m.x, 0.2f, 0.0f);
    sampler_path_end(&resampler);
    const struct poi_sample next = at(16, 0.4f);
    sampler_path_push(&resampler, &next);
    assert_float_equal(sampler_path_at(&resampler, 0, 2).position_m.x, 0.3f, 1e-6f);
}

static void test_angles_are_interpolated_along_the_shorter_arc(void **state)
{
    (void)state;
    struct poi_sample samples[] = { at(0, 0.0f), at(10, 0.0f) };
    samples[0].target.angles.yaw_rad = 3.0f;
    samples[1].target.angles.yaw_rad = -3.0f;
    const struct sampler_path resampler = with(samples, 2);
    const float middle = sampler_path_at(&resampler, 0, 2).angles.yaw_rad;
    assert_float_equal(fabsf(middle), 3.14159265f, 1e-5f);
}

static void test_a_non_finite_reading_is_reported_and_passed_on_unchanged(void **state)
{
    (void)state;
    const float wrong[] = { NAN, INFINITY, -INFINITY, 3e38f, 1001.0f };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        const struct poi_sample good = at(0, 0.5f);
        struct sampler_path resampler = with(&good, 1);
        struct poi_sample bad = at(16, 0.5f);
        bad.target.angles.roll_rad = wrong[i];
        assert_int_equal(sampler_path_push(&resampler, &bad), 0);
        const struct poi_target before = sampler_path_at(&resampler, 0, 2);
        /* The valid pose must not be interpolated with the non-finite pose that follows. */
        assert_memory_equal(&before, &good.target, sizeof before);
        const struct poi_target newest = sampler_path_at(&resampler, 1, 2);
        assert_memory_equal(&newest, &bad.target, sizeof newest);
        sampler_path_end(&resampler);
        const struct poi_sample again = at(33, 0.51f);
        assert_int_equal(sampler_path_push(&resampler, &again), 1);
        for (uint32_t tick = 0; tick < 2; tick++) {
            const struct poi_target after = sampler_path_at(&resampler, tick, 2);
            assert_memory_equal(&after, &again.target, sizeof after);
        }
    }
}

static void test_a_jump_is_not_interpolated(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(16, 1.0f) };
    const struct sampler_path resampler = with(samples, 2);
    assert_float_equal(sampler_path_at(&resampler, 0, 4).position_m.x, 0.0f, 0.0f);
    assert_float_equal(sampler_path_at(&resampler, 2, 4).position_m.x, 0.0f, 0.0f);
    assert_float_equal(sampler_path_at(&resampler, 3, 4).position_m.x, 1.0f, 0.0f);
}

/* The poi moves by 0.4 m in one frame. For a controller with an orientation sensor, this is a jump,
 * because an arm cannot move so fast. For a mouse it is a normal motion. */
static void test_the_jump_threshold_depends_on_the_orientation_sensor(void **state)
{
    (void)state;
    struct poi_sample samples[] = { at(0, 0.0f), at(16, 0.4f) };
    struct sampler_path resampler = with(samples, 2);
    assert_float_equal(sampler_path_at(&resampler, 0, 2).position_m.x, 0.2f, 1e-6f);
    samples[0].has_wrist = samples[1].has_wrist = 1;
    resampler = with(samples, 2);
    assert_float_equal(sampler_path_at(&resampler, 0, 2).position_m.x, 0.0f, 0.0f);
}

static void test_reversed_reading_times_keep_the_newest_reading(void **state)
{
    (void)state;
    const struct poi_sample samples[] = { at(0, 0.0f), at(9, 0.9f), at(3, 0.3f), at(3, 0.4f) };
    const struct sampler_path resampler = with(samples, 4);
    assert_float_equal(sampler_path_at(&resampler, 0, 1).position_m.x, 0.4f, 0.0f);
    for (uint32_t tick = 0; tick < 24; tick++) {
        assert_true(isfinite(sampler_path_at(&resampler, tick, 24).position_m.x));
    }
}

static void test_readings_with_equal_times_cause_no_division_by_zero(void **state)
{
    (void)state;
    struct poi_sample samples[] = { at(1, 0.0f), at(1, 0.5f), at(1, 1.0f) };
    samples[2].time_ns += 1;
    const struct sampler_path resampler = with(samples, 3);
    for (uint32_t tick = 0; tick < 24; tick++) {
        assert_in_range((int)(1000.0f * sampler_path_at(&resampler, tick, 24).position_m.x), 0,
                        1000);
    }
}

static void test_a_full_reading_queue_keeps_its_first_and_last_reading(void **state)
{
    (void)state;
    struct sampler_path resampler;
    memset(&resampler, 0, sizeof resampler);
    for (uint32_t i = 0; i <= 1000; i++) {
        const struct poi_sample sample = at(i, 0.001f * (float)i);
        assert_int_equal(sampler_path_push(&resampler, &sample), 1);
    }
    assert_int_equal(resampler.count, SAMPLER_PATH_MAX);
    assert_float_equal(resampler.path[0].target.position_m.x, 0.0f, 0.0f);
    assert_float_equal(sampler_path_at(&resampler, 0, 1).position_m.x, 1.0f, 1e-6f);
    assert_float_equal(sampler_path_at(&resampler, 0, 2).position_m.x, 0.5f, 1e-5f);
}

/* The frame loop was delayed by one second. The next frame has two ticks and gets all reports of
 * that second. Only the newest pose may be used, and only the first tick reports the gap. */
static void test_motion_of_a_delay_is_flagged_and_not_interpolated(void **state)
{
    (void)state;
    struct poi_sampler sampler = { .link = POI_SOURCE_LIVE, .was_seen = 1 };
    for (uint32_t i = 0; i <= 10; i++) {
        const struct poi_sample sample = at(100u * i, 0.1f * (float)i);
        sampler_path_push(&sampler.path, &sample);
    }
    for (uint32_t index = 0; index < 2; index++) {
        struct poi_input input = { 0 };
        sampler_poi_at(&sampler, index, 2, sampler.newest_ns, &input);
        assert_int_equal(input.has_gap, index == 0);
        assert_float_equal(input.target.position_m.x, 1.0f, 1e-6f);
        assert_int_equal(input.age_ticks, 0);
    }
    sampler_path_end(&sampler.path);
    const struct poi_sample next = at(1016, 1.01f);
    struct poi_input input = { 0 };
    sampler_path_push(&sampler.path, &next);
    sampler_poi_at(&sampler, 0, 2, sampler.newest_ns, &input);
    assert_int_equal(input.has_gap, 0);
    assert_float_equal(input.target.position_m.x, 1.005f, 1e-5f);
}

static void test_resampling_without_a_reading_fails_an_assertion(void **state)
{
    (void)state;
    struct sampler_path resampler;
    memset(&resampler, 0, sizeof resampler);
    expect_assert_failure(sampler_path_at(&resampler, 0, 1));
    const struct poi_sample sample = at(0, 0.0f);
    sampler_path_push(&resampler, &sample);
    expect_assert_failure(sampler_path_at(&resampler, 1, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_newest_tick_uses_the_newest_reading_unchanged),
        cmocka_unit_test(test_ticks_between_readings_are_interpolated),
        cmocka_unit_test(test_a_constant_speed_is_constant_at_every_tick),
        cmocka_unit_test(test_readings_of_frames_without_ticks_are_used_at_the_next_tick),
        cmocka_unit_test(test_angles_are_interpolated_along_the_shorter_arc),
        cmocka_unit_test(test_a_non_finite_reading_is_reported_and_passed_on_unchanged),
        cmocka_unit_test(test_a_jump_is_not_interpolated),
        cmocka_unit_test(test_the_jump_threshold_depends_on_the_orientation_sensor),
        cmocka_unit_test(test_reversed_reading_times_keep_the_newest_reading),
        cmocka_unit_test(test_readings_with_equal_times_cause_no_division_by_zero),
        cmocka_unit_test(test_a_full_reading_queue_keeps_its_first_and_last_reading),
        cmocka_unit_test(test_motion_of_a_delay_is_flagged_and_not_interpolated),
        cmocka_unit_test(test_resampling_without_a_reading_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
