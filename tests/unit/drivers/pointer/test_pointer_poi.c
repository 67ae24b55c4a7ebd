/* test_pointer_poi.c -- a pointer held as a hand would hold the poi. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/pointer/pointer_poi.h"
#include "tests/unit/support/pointer.h"

#define DOWN_MS ((uint64_t)(POINTER_DOWN_S * 1000.0f))
#define UP_MS ((uint64_t)(POINTER_UP_S * 1000.0f))

static struct pointer_poi fresh(void)
{
    struct pointer_poi pointer;
    pointer_poi_init(&pointer, stall_view());
    return pointer;
}

static void give(struct pointer_poi *pointer, struct pointer_report given)
{
    assert_int_equal(pointer_poi_report(pointer, &given), 1);
}

static struct poi_target after(struct pointer_poi *pointer, uint64_t ms)
{
    return pointer_poi_target(pointer, ms * MS);
}

/* Where a world point lies on the screen, in pixels: the renderer's projection, the other way
 * round. */
static void project(const struct pointer_poi *pointer, vec3 point, float *x_px, float *y_px)
{
    const struct basis axes = view_basis(&pointer->view);
    const vec3 body = vec_basis_to_body(&axes, v3_sub(point, pointer->view.eye_m));
    const float tan_y = view_half_height_tan(&pointer->view, (float)WIDTH / (float)HEIGHT);
    const float ndc_x = body.x / -body.z / (tan_y * (float)WIDTH / (float)HEIGHT);
    const float ndc_y = body.y / -body.z / tan_y;
    *x_px = 0.5f * (ndc_x + 1.0f) * (float)WIDTH;
    *y_px = 0.5f * (1.0f - ndc_y) * (float)HEIGHT;
}

static void test_the_ring_hovers_until_the_button_is_held(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(10, 640.0f, 360.0f, 0));
    const struct poi_target target = after(&pointer, 500);
    assert_float_equal(target.position_m.y, POINTER_HOVER_M, 1e-6f);
    assert_float_equal(target.angles.pitch_rad, 0.0f, 1e-6f);
}

static void test_holding_dips_and_letting_go_lifts_in_their_times(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(100, 640.0f, 360.0f, POINTER_DIP));
    assert_true(after(&pointer, 100 + DOWN_MS - 10).position_m.y > POINTER_DIP_M);
    assert_float_equal(after(&pointer, 100 + DOWN_MS + 1).position_m.y, POINTER_DIP_M, 1e-5f);
    give(&pointer, report(1000, 640.0f, 360.0f, 0));
    assert_true(after(&pointer, 1000 + UP_MS - 20).position_m.y < POINTER_HOVER_M - 1e-5f);
    assert_float_equal(after(&pointer, 1000 + UP_MS + 1).position_m.y, POINTER_HOVER_M, 1e-5f);
}

static void test_the_pointer_stays_over_the_rings_centre_at_every_height(void **state)
{
    (void)state;
    static const float places[][2] = {
        { 640.0f, 360.0f },
        { 300.0f, 250.0f },
        { 1000.0f, 600.0f },
    };
    for (size_t i = 0; i < 3; i++) {
        struct pointer_poi pointer = fresh();
        give(&pointer, report(0, places[i][0], places[i][1], POINTER_DIP));
        for (uint64_t ms = 0; ms <= 300; ms += 10) {
            float x_px;
            float y_px;
            project(&pointer, after(&pointer, ms).position_m, &x_px, &y_px);
            assert_float_equal(x_px, places[i][0], 0.1f);
            assert_float_equal(y_px, places[i][1], 0.1f);
        }
    }
}

/* Height, and speed and acceleration by differences, of a stroke that is broken off and resumed. */
static void test_a_stroke_that_changes_its_mind_is_still_smooth(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    float height = POINTER_HOVER_M;
    float speed = 0.0f;
    for (uint64_t ms = 0; ms <= 520 + UP_MS; ms++) {
        if (ms == 10 || ms == 250) {
            give(&pointer, report(ms, 640.0f, 360.0f, POINTER_DIP));
        }
        if (ms == 120 || ms == 520) {
            give(&pointer, report(ms, 640.0f, 360.0f, 0));
        }
        const float now = after(&pointer, ms).position_m.y;
        const float speed_now = (now - height) / 0.001f;
        assert_true(fabsf(speed_now) < 0.8f);
        assert_true(fabsf(speed_now - speed) < 0.03f); /* Below 30 m/s^2: no jerk of the hand. */
        assert_true(now < POINTER_HOVER_M + 0.01f && now > POINTER_DIP_M - 0.02f);
        height = now;
        speed = speed_now;
    }
    assert_float_equal(height, POINTER_HOVER_M, 1e-5f);
}

static void test_the_wheel_tilts_by_notches_smoothly_and_to_a_limit(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    struct pointer_report turn = report(10, 640.0f, 360.0f, 0);
    turn.wheel_notches = 2.0f;
    give(&pointer, turn);
    const float soon = after(&pointer, 30).angles.pitch_rad;
    assert_true(soon > 0.0f && soon < 1.5f * POINTER_TILT_STEP_RAD);
    assert_float_equal(after(&pointer, 1000).angles.pitch_rad, 2.0f * POINTER_TILT_STEP_RAD, 1e-4f);
    turn.time_ns = 1001 * MS;
    turn.wheel_notches = -100.0f;
    give(&pointer, turn);
    assert_float_equal(after(&pointer, 3000).angles.pitch_rad, -POINTER_TILT_MAX_RAD, 1e-4f);
}

static void test_the_right_button_levels_the_ring(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    struct pointer_report turn = report(10, 640.0f, 360.0f, 0);
    turn.wheel_notches = 4.0f;
    give(&pointer, turn);
    after(&pointer, 1000);
    give(&pointer, report(1001, 640.0f, 360.0f, POINTER_LEVEL));
    assert_float_equal(after(&pointer, 2000).angles.pitch_rad, 0.0f, 1e-4f);
}

static void test_a_stroke_slants_the_far_edge_down_and_ends_level(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(0, 640.0f, 360.0f, POINTER_DIP));
    assert_true(after(&pointer, DOWN_MS / 2).angles.pitch_rad < -0.1f);
    assert_float_equal(after(&pointer, DOWN_MS + 1).angles.pitch_rad, 0.0f, 1e-4f);
}

/* Across the screen in `step_px` every 16 ms, for half a second. */
static struct angles angles_while_sweeping(float step_px)
{
    struct pointer_poi pointer = fresh();
    struct poi_target target = { 0 };
    for (uint64_t i = 1; i <= 30; i++) {
        give(&pointer, report(16 * i, 640.0f + step_px * (float)i, 360.0f, POINTER_DIP));
        target = after(&pointer, 16 * i);
    }
    return target.angles;
}

static void test_a_hurried_hand_leans_the_ring_into_its_way(void **state)
{
    (void)state;
    const float glide = angles_while_sweeping(2.0f).roll_rad; /* About 0.1 m/s. */
    const float rush = angles_while_sweeping(20.0f).roll_rad; /* About 1 m/s. */
    assert_true(glide < 0.0f && glide > -4.0f * F_DEG);
    assert_true(rush < -15.0f * F_DEG && rush > -21.0f * F_DEG);
    assert_true(angles_while_sweeping(-20.0f).roll_rad > 15.0f * F_DEG);
}

static void test_a_hand_that_stops_is_level_again(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    for (uint64_t i = 1; i <= 30; i++) {
        give(&pointer, report(16 * i, 300.0f + 20.0f * (float)i, 360.0f, 0));
        after(&pointer, 16 * i);
    }
    struct poi_target target = { 0 };
    for (uint64_t i = 31; i <= 61; i++) {
        target = after(&pointer, 16 * i);
    }
    assert_true(fabsf(target.angles.roll_rad) < 0.5f * F_DEG);
}

static void test_what_is_no_report_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(10, 300.0f, 300.0f, 0));
    const vec3 before = after(&pointer, 20).position_m;
    struct pointer_report bad[] = {
        report(30, NAN, 0.0f, 0),
        report(30, 0.0f, INFINITY, 0),
        report(30, 0.0f, 0.0f, POINTER_DIP),
        report(30, 0.0f, 0.0f, POINTER_DIP),
        report(30, 0.0f, 0.0f, 0),
    };
    bad[2].width_px = 0;
    bad[3].height_px = 0;
    bad[4].wheel_notches = NAN;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(pointer_poi_report(&pointer, &bad[i]), 0);
        assert_true(after(&pointer, 40).position_m.x == before.x);
        assert_true(after(&pointer, 40).position_m.y == before.y);
    }
}

static void test_any_pixel_and_any_time_give_a_finite_hand(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    static const float wild[] = { -1e30f, -5.0f, 0.0f, 1280.0f, 1e30f };
    for (size_t i = 0; i < 5; i++) {
        for (size_t j = 0; j < 5; j++) {
            struct pointer_report given =
                report(1000 - 100 * i, wild[i], wild[j], (uint32_t)(i + j));
            given.wheel_notches = wild[j];
            given.width_px = j == 2 ? 1u : UINT32_MAX;
            pointer_poi_report(&pointer, &given);
            const struct poi_target target = after(&pointer, 100 * j);
            assert_true(v3_is_finite(target.position_m));
            assert_true(f_is_finite(target.angles.pitch_rad));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_ring_hovers_until_the_button_is_held),
        cmocka_unit_test(test_holding_dips_and_letting_go_lifts_in_their_times),
        cmocka_unit_test(test_the_pointer_stays_over_the_rings_centre_at_every_height),
        cmocka_unit_test(test_a_stroke_that_changes_its_mind_is_still_smooth),
        cmocka_unit_test(test_the_wheel_tilts_by_notches_smoothly_and_to_a_limit),
        cmocka_unit_test(test_the_right_button_levels_the_ring),
        cmocka_unit_test(test_a_stroke_slants_the_far_edge_down_and_ends_level),
        cmocka_unit_test(test_a_hurried_hand_leans_the_ring_into_its_way),
        cmocka_unit_test(test_a_hand_that_stops_is_level_again),
        cmocka_unit_test(test_what_is_no_report_is_refused_and_changes_nothing),
        cmocka_unit_test(test_any_pixel_and_any_time_give_a_finite_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
