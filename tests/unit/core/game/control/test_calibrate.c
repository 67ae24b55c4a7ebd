/* test_calibrate.c -- checks the calibration of a simulated poi that measures in its own coordinate
 * frame. After the calibration, the error must be at most 1 mm in the whole tank. Invalid marks
 * must be rejected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/game/control/input_pose.h"
#include "tests/unit/support/skewed_twin.h"

#define FRAMES 400u
#define WITHIN_M 0.001f
#define WITHIN_RAD 0.002f

static const vec3 tank_m = { 1.36f, 0.20f, 0.65f };

static float draw(uint32_t frame, uint32_t what, float from, float to)
{
    return rng_range((struct rng_key){ 11, frame, what, RNG_TEST }, from, to);
}

/* Returns a random coordinate frame of a sensor. The frame is rotated by any angle, scaled by 1/3
 * to 3, skewed, shifted by metres and tilted. */
static struct twin twin_of(uint32_t frame)
{
    const float turn = draw(frame, 0, -F_PI, F_PI), c = f_cos(turn), s = f_sin(turn);
    const float wide = draw(frame, 1, 0.34f, 3.0f), deep = draw(frame, 2, 0.34f, 3.0f);
    const float skew = draw(frame, 3, -0.5f, 0.5f);
    return (struct twin){
        .xx = wide * c,
        .xz = deep * (s + skew * c),
        .zx = -wide * s,
        .zz = deep * (c - skew * s),
        .shift_m = v3(draw(frame, 4, -2.0f, 2.0f), draw(frame, 5, -1.0f, 1.0f),
                      draw(frame, 6, -2.0f, 2.0f)),
        .pitch_rad = draw(frame, 7, -0.7f, 0.7f),
        .roll_rad = draw(frame, 8, -0.7f, 0.7f),
    };
}

static struct calibration_sample sample_of(const struct twin *twin)
{
    struct calibration_sample sample = { .has_wrist = 1 };
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        sample.corner_m[i] = seen_point(twin, input_calibration_mark(tank_m, i));
    }
    sample.water = seen(twin, (struct poi_target){ 0 });
    return sample;
}

/* ---- The calibration map -------------------------------------------------------------------- */

static void test_calibration_corrects_any_frame_within_1_mm(void **state)
{
    (void)state;
    float worst_m = 0.0f, worst_rad = 0.0f;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const struct twin twin = twin_of(frame);
        const struct calibration_sample sample = sample_of(&twin);
        int32_t value[CALIBRATION_VALUES];
        struct settings settings = { { 0 } };
        assert_int_equal(input_calibration_solve(&sample, tank_m, value), CALIBRATION_GOOD);
        for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
            assert_true(settings_allows(input_calibration_setting(2) + i, value[i]));
        }
        set_values(&settings, 2, value);
        for (uint32_t i = 0; i < 25u; i++) {
            const struct poi_target at = {
                { 0.34f * ((float)(i % 5u) - 2.0f), 0.01f * (float)i,
                  0.16f * ((float)(i / 5u) - 2.0f) },
                { 0.5f * ((float)(i % 11u) - 5.0f), 0.1f * (float)(i % 3u), -0.05f * (float)i },
            };
            struct poi_input poi = { .link = POI_SOURCE_LIVE,
                                     .has_wrist = 1,
                                     .target = seen(&twin, at) };
            input_calibration_apply(&settings, 2, &poi);
            worst_m = f_max(worst_m, v3_length(v3_sub(poi.target.position_m, at.position_m)));
            worst_rad = f_max(worst_rad, input_turn(poi.target.angles, at.angles));
        }
    }
    print_message("over %u frames: %.3f mm, %.4f rad at worst\n", FRAMES, (double)worst_m * 1000.0,
                  (double)worst_rad);
    assert_true(worst_m < WITHIN_M);
    assert_true(worst_rad < WITHIN_RAD);
}

/* The operator holds the poi with an error of up to 5 mm in each axis at each mark. The
 * calibration's error may be at most 1.5 times as large. */
static void test_calibration_averages_small_errors_at_the_marks(void **state)
{
    (void)state;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const struct twin twin = twin_of(frame);
        struct calibration_sample sample = sample_of(&twin);
        int32_t value[CALIBRATION_VALUES];
        struct settings settings = { { 0 } };
        for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
            const vec3 off_m = v3(draw(frame, 20u + i, -0.005f, 0.005f), 0.0f,
                                  draw(frame, 30u + i, -0.005f, 0.005f));
            sample.corner_m[i] =
                seen_point(&twin, v3_add(input_calibration_mark(tank_m, i), off_m));
        }
        assert_int_equal(input_calibration_solve(&sample, tank_m, value), CALIBRATION_GOOD);
        set_values(&settings, 0, value);
        for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
            const vec3 mark_m = input_calibration_mark(tank_m, i);
            struct poi_input poi = { .link = POI_SOURCE_LIVE,
                                     .target.position_m = seen_point(&twin, mark_m) };
            input_calibration_apply(&settings, 0, &poi);
            const vec3 off_m = v3_sub(poi.target.position_m, mark_m);
            assert_true(f_sqrt(off_m.x * off_m.x + off_m.z * off_m.z) < 0.0107f);
        }
    }
}

static void test_an_uncalibrated_pose_is_not_changed(void **state)
{
    (void)state;
    static const struct settings none = { { 0 } };
    struct settings other = { { 0 } };
    set_values(&other, 1, (int32_t[CALIBRATION_VALUES]){ [CALIBRATION_X0] = 100000 });
    struct poi_input poi = { .link = POI_SOURCE_LIVE,
                             .has_wrist = 1,
                             .target = { { 0.1f, -0.0f, 3e-9f }, { 900.1f, -0.2f, 0.3f } } };
    const struct poi_input before = poi;
    input_calibration_apply(&none, 0, &poi);
    input_calibration_apply(&other, 0, &poi);
    assert_memory_equal(&poi, &before, sizeof poi);
    /* Divides 0 by 0, so that the pose contains NaN. */
    poi.target.position_m.x = 0.0f / (poi.target.position_m.y * 0.0f);
    const struct poi_input broken = poi;
    input_calibration_apply(&other, 1, &poi);
    assert_memory_equal(&poi, &broken, sizeof poi);
}

/* ---- Rejected calibration marks ------------------------------------------------------------- */

static enum calibration_fault fault_of(const struct calibration_sample *sample)
{
    int32_t value[CALIBRATION_VALUES] = { 7, 7, 7, 7, 7, 7, 7, 7, 7 };
    const enum calibration_fault fault = input_calibration_solve(sample, tank_m, value);
    for (uint32_t i = 0; i < CALIBRATION_VALUES && fault != CALIBRATION_GOOD; i++) {
        assert_int_equal(value[i], 7);
    }
    return fault;
}

static void swap_corners(struct calibration_sample *sample, uint32_t a, uint32_t b)
{
    const vec3 kept_m = sample->corner_m[a];
    sample->corner_m[a] = sample->corner_m[b];
    sample->corner_m[b] = kept_m;
}

static void test_invalid_marks_are_rejected_with_a_reason(void **state)
{
    (void)state;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const struct twin twin = twin_of(frame);
        const struct calibration_sample good = sample_of(&twin);
        struct calibration_sample sample = good;
        sample.corner_m[2] = v3_add(sample.corner_m[1], v3(0.012f, 0.3f, 0.012f));
        assert_int_equal(fault_of(&sample), CALIBRATION_NEAR);
        sample = good;
        swap_corners(&sample, frame % 4u, (frame + 1u) % 4u);
        assert_int_equal(fault_of(&sample), CALIBRATION_CROSSED);
        sample = good;
        swap_corners(&sample, frame % 2u, frame % 2u + 2u);
        assert_int_equal(fault_of(&sample), CALIBRATION_MIRRORED);
        sample = good;
        /* Places all marks on one line. No calibration can be computed from such marks. */
        for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
            sample.corner_m[i] = v3_scale(v3(1.0f, 0.0f, 0.4f), (float)i);
        }
        assert_int_equal(fault_of(&sample), CALIBRATION_CROSSED);
        sample = good;
        sample.water.position_m.y = 10.5f;
        assert_int_equal(fault_of(&sample), CALIBRATION_FAR);
        sample = good;
        sample.corner_m[frame % 4u] =
            seen_point(&twin, v3_scale(input_calibration_mark(tank_m, frame % 4u), 0.85f));
        assert_int_equal(fault_of(&sample), CALIBRATION_UNEVEN);
        sample = good;
        sample.water.angles.roll_rad = frame % 2u ? 0.80f : -0.80f;
        assert_int_equal(fault_of(&sample), CALIBRATION_TILTED);
        sample.has_wrist = 0;
        assert_int_equal(fault_of(&sample), CALIBRATION_GOOD);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_calibration_corrects_any_frame_within_1_mm),
        cmocka_unit_test(test_calibration_averages_small_errors_at_the_marks),
        cmocka_unit_test(test_an_uncalibrated_pose_is_not_changed),
        cmocka_unit_test(test_invalid_marks_are_rejected_with_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
