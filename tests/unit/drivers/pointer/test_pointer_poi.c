/* test_pointer_poi.c -- Tests the pose of a poi that is moved with a mouse. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/pointer/pointer_poi.h"
#include "tests/unit/support/pointer.h"

#define DOWN_MS ((uint64_t)(DIP_DOWN_S * 1000.0f))
#define UP_MS ((uint64_t)(DIP_UP_S * 1000.0f))

static struct pointer_poi fresh(void)
{
    struct pointer_poi pointer;
    pointer_poi_init(&pointer, festival_view());
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

/* Projects a world point to the screen in pixels, as the renderer does. */
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

static void test_the_ring_hovers_unless_the_button_is_held(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(10, 640.0f, 360.0f, 0));
    const struct poi_target target = after(&pointer, 500);
    assert_float_equal(target.position_m.y, DIP_HOVER_M, 1e-6f);
    assert_float_equal(target.angles.pitch_rad, 0.0f, 1e-6f);
}

static void test_press_lowers_and_release_lifts_the_ring_in_the_set_times(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(100, 640.0f, 360.0f, POINTER_DIP));
    assert_true(after(&pointer, 100 + DOWN_MS - 10).position_m.y > DIP_DEPTH_M);
    assert_float_equal(after(&pointer, 100 + DOWN_MS + 1).position_m.y, DIP_DEPTH_M, 1e-5f);
    give(&pointer, report(1000, 640.0f, 360.0f, 0));
    assert_true(after(&pointer, 1000 + UP_MS - 20).position_m.y < DIP_HOVER_M - 1e-5f);
    assert_float_equal(after(&pointer, 1000 + UP_MS + 1).position_m.y, DIP_HOVER_M, 1e-5f);
}

/* The acceleration must continue at the start of a stroke that interrupts another stroke. */
static void test_the_acceleration_of_a_stroke_is_the_change_of_its_speed(void **state)
{
    (void)state;
    struct dip dip;
    pointer_dip_init(&dip);
    pointer_dip_begin(&dip, 0, true);
    assert_float_equal(pointer_dip_at(&dip, 0).acceleration_m_s2, -6.0f, 1e-4f);
    for (uint64_t ms = 0; ms + 1u < DOWN_MS; ms++) {
        const float from_m_s = pointer_dip_at(&dip, ms * MS).speed_m_s;
        const float to_m_s = pointer_dip_at(&dip, (ms + 1u) * MS).speed_m_s;
        const float middle_m_s2 = pointer_dip_at(&dip, ms * MS + MS / 2u).acceleration_m_s2;
        assert_float_equal((to_m_s - from_m_s) * 1000.0f, middle_m_s2, 0.05f);
    }
}

static const float places[][2] = {
    { 640.0f, 360.0f },
    { 300.0f, 250.0f },
    { 1000.0f, 600.0f },
};

/* Checks that the pointer at this pixel is over the centre of the ring. */
static void assert_is_under_pointer(const struct pointer_poi *pointer, vec3 ring_m, float x_px,
                                    float y_px)
{
    float ring_x_px;
    float ring_y_px;
    project(pointer, ring_m, &ring_x_px, &ring_y_px);
    assert_float_equal(ring_x_px, x_px, 0.1f);
    assert_float_equal(ring_y_px, y_px, 0.1f);
}

/* Returns how much nearer to the player the ring is than the point of the water below the pointer,
 * in m. */
static float nearer_m(vec3 ring_m, float x_px, float y_px)
{
    const vec3 below_m = view_point_on_plane(festival_view(), (float)WIDTH / (float)HEIGHT,
                                             2.0f * x_px / (float)WIDTH - 1.0f,
                                             1.0f - 2.0f * y_px / (float)HEIGHT, ring_m.y);
    assert_float_equal(ring_m.x, below_m.x, 1e-4f);
    return ring_m.z - below_m.z;
}

static void test_the_pointer_stays_over_the_rings_centre_while_the_ring_rises(void **state)
{
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        struct pointer_poi pointer = fresh();
        give(&pointer, report(0, places[i][0], places[i][1], POINTER_DIP));
        give(&pointer, report(1000, places[i][0], places[i][1], 0));
        for (uint64_t ms = 1000; ms <= 1000 + UP_MS + 10; ms += 10) {
            const vec3 ring_m = after(&pointer, ms).position_m;
            assert_is_under_pointer(&pointer, ring_m, places[i][0], places[i][1]);
        }
    }
}

static void test_the_ring_sinks_nearer_to_the_player_and_ends_under_the_pointer(void **state)
{
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        struct pointer_poi pointer = fresh();
        give(&pointer, report(0, places[i][0], places[i][1], POINTER_DIP));
        float most_m = 0.0f;
        for (uint64_t ms = 0; ms <= DOWN_MS; ms++) {
            const vec3 ring_m = after(&pointer, ms).position_m;
            const float now_m = nearer_m(ring_m, places[i][0], places[i][1]);
            assert_true(now_m > -1e-4f && now_m < DIP_NEAR_M + 1e-4f);
            most_m = f_max(most_m, now_m);
        }
        assert_float_equal(most_m, DIP_NEAR_M, 1e-3f);
        const vec3 end_m = after(&pointer, DOWN_MS + 1).position_m;
        assert_is_under_pointer(&pointer, end_m, places[i][0], places[i][1]);
    }
}

/* On a page such as a menu, a press must act exactly at the pointer, so the ring must not move
 * sideways. */
static void test_on_a_page_the_ring_sinks_straight_below_the_pointer(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    pointer.dip.scoops = false;
    give(&pointer, report(0, places[0][0], places[0][1], POINTER_DIP));
    for (uint64_t ms = 0; ms <= DOWN_MS; ms++) {
        const vec3 ring_m = after(&pointer, ms).position_m;
        assert_is_under_pointer(&pointer, ring_m, places[0][0], places[0][1]);
    }
}

/* After a click of only 20 ms, the dip must still reach its full depth. */
static void test_a_short_press_completes_the_downward_stroke(void **state)
{
    (void)state;
    struct pointer_poi held = fresh();
    struct pointer_poi clicked = fresh();
    give(&held, report(100, 640.0f, 360.0f, POINTER_DIP));
    give(&clicked, report(100, 640.0f, 360.0f, POINTER_DIP));
    give(&clicked, report(120, 640.0f, 360.0f, 0));
    for (uint64_t ms = 120; ms <= 100 + DOWN_MS; ms += 5) {
        const struct poi_target a = after(&held, ms);
        const struct poi_target b = after(&clicked, ms);
        assert_float_equal(v3_length(v3_sub(a.position_m, b.position_m)), 0.0f, 1e-6f);
        assert_float_equal(a.angles.pitch_rad, b.angles.pitch_rad, 1e-6f);
    }
    assert_true(after(&clicked, 100 + DOWN_MS + UP_MS / 2).position_m.y > DIP_DEPTH_M + 0.02f);
    assert_true(after(&clicked, 100 + DOWN_MS + UP_MS - 20).position_m.y < DIP_HOVER_M - 1e-5f);
    assert_float_equal(after(&clicked, 100 + DOWN_MS + UP_MS + 2).position_m.y, DIP_HOVER_M, 1e-5f);
}

/* The next pose is read only long after the button was released. The lift must nevertheless start
 * at the release. */
static void test_a_pause_without_samples_does_not_delay_the_lift(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(100, 640.0f, 360.0f, POINTER_DIP));
    give(&pointer, report(120, 640.0f, 360.0f, 0));
    assert_float_equal(after(&pointer, 100 + DOWN_MS + UP_MS + 2).position_m.y, DIP_HOVER_M, 1e-5f);
    give(&pointer, report(2000, 640.0f, 360.0f, POINTER_DIP));
    assert_float_equal(after(&pointer, 2000).position_m.y, DIP_HOVER_M, 1e-5f);
    assert_float_equal(after(&pointer, 2000 + DOWN_MS + 2).position_m.y, DIP_DEPTH_M, 1e-5f);
}

static void test_a_second_press_during_the_stroke_keeps_the_ring_down(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(100, 640.0f, 360.0f, POINTER_DIP));
    give(&pointer, report(180, 640.0f, 360.0f, 0));
    give(&pointer, report(260, 640.0f, 360.0f, POINTER_DIP));
    for (uint64_t ms = 100 + DOWN_MS + 1; ms <= 3000; ms += 50) {
        assert_float_equal(after(&pointer, ms).position_m.y, DIP_DEPTH_M, 1e-5f);
    }
    give(&pointer, report(3000, 640.0f, 360.0f, 0));
    assert_float_equal(after(&pointer, 3000 + UP_MS + 1).position_m.y, DIP_HOVER_M, 1e-5f);
}

/* If the player presses again while the ring is still under water, the ring must go down again
 * without a sideways motion. */
static void test_a_press_under_water_does_not_move_the_ring_sideways(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(0, 640.0f, 360.0f, POINTER_DIP));
    give(&pointer, report(1000, 640.0f, 360.0f, 0));
    uint64_t ms = 1000;
    while (after(&pointer, ms).position_m.y < 0.5f * DIP_DEPTH_M) {
        ms++;
    }
    give(&pointer, report(ms, 640.0f, 360.0f, POINTER_DIP));
    for (uint64_t i = 0; i <= DOWN_MS + 1; i++) {
        const vec3 ring_m = after(&pointer, ms + i).position_m;
        assert_is_under_pointer(&pointer, ring_m, 640.0f, 360.0f);
    }
}

/* A stroke is a dip or a lift. The button is pressed during a lift, and released and pressed again
 * during a dip. The position and the velocity of the ring must stay continuous. */
static void test_interrupted_strokes_have_no_jump_in_position_or_velocity(void **state)
{
    (void)state;
    static const uint64_t changes_ms[] = { 10, 120, 300, 800, 950, 1000, 1400 };
    struct pointer_poi pointer = fresh();
    uint32_t buttons = 0;
    size_t next = 0;
    vec3 position_m = v3(0.0f, 0.0f, 0.0f);
    vec3 velocity_m_s = v3(0.0f, 0.0f, 0.0f);
    for (uint64_t ms = 0; ms <= 3000; ms++) {
        if (next < sizeof changes_ms / sizeof changes_ms[0] && ms == changes_ms[next]) {
            buttons ^= POINTER_DIP;
            next++;
            give(&pointer, report(ms, 640.0f, 360.0f, buttons));
        }
        if (ms == 2000) {
            give(&pointer, report(ms, 640.0f, 360.0f, 0));
        }
        const vec3 now_m = after(&pointer, ms).position_m;
        if (ms > 1) {
            const vec3 now_m_s = v3_scale(v3_sub(now_m, position_m), 1000.0f);
            assert_true(v3_length(now_m_s) < 0.8f);
            /* The velocity changes by less than 0.03 m/s in 1 ms, so the acceleration is below
             * 30 m/s^2. */
            assert_true(v3_length(v3_sub(now_m_s, velocity_m_s)) < 0.03f);
            velocity_m_s = now_m_s;
        }
        assert_true(now_m.y < DIP_HOVER_M + 0.01f && now_m.y > DIP_DEPTH_M - 0.005f);
        position_m = now_m;
    }
    assert_float_equal(position_m.y, DIP_HOVER_M, 1e-5f);
}

static void test_each_wheel_notch_tilts_the_ring_smoothly_up_to_a_limit(void **state)
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

static void test_a_stroke_lowers_the_far_edge_and_ends_level(void **state)
{
    (void)state;
    struct pointer_poi pointer = fresh();
    give(&pointer, report(0, 640.0f, 360.0f, POINTER_DIP));
    assert_float_equal(after(&pointer, DOWN_MS / 3).angles.pitch_rad, -DIP_SLANT_DOWN_RAD, 1e-4f);
    assert_float_equal(after(&pointer, DOWN_MS + 1).angles.pitch_rad, 0.0f, 1e-4f);
    give(&pointer, report(1000, 640.0f, 360.0f, 0));
    const float rising_rad = after(&pointer, 1000 + UP_MS / 2).angles.pitch_rad;
    assert_true(rising_rad < -0.1f && rising_rad > -DIP_SLANT_UP_RAD - 1e-4f);
    assert_float_equal(after(&pointer, 1000 + UP_MS + 1).angles.pitch_rad, 0.0f, 1e-4f);
}

/* Moves the pointer by `step_px` every 16 ms for half a second. Returns the angles of the ring. */
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

static void test_fast_motion_tilts_the_ring_in_the_direction_of_motion(void **state)
{
    (void)state;
    /* A step of 2 pixels is a speed of about 0.1 m/s. */
    const float glide = angles_while_sweeping(2.0f).roll_rad;
    /* A step of 20 pixels is a speed of about 1 m/s. */
    const float rush = angles_while_sweeping(20.0f).roll_rad;
    assert_true(glide < 0.0f && glide > -4.0f * F_DEG);
    assert_true(rush < -15.0f * F_DEG && rush > -21.0f * F_DEG);
    assert_true(angles_while_sweeping(-20.0f).roll_rad > 15.0f * F_DEG);
}

static void test_the_ring_is_level_again_after_the_motion_stops(void **state)
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

static void test_an_invalid_report_is_rejected_and_changes_nothing(void **state)
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

static void test_any_pixel_and_any_time_give_a_finite_pose(void **state)
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
        cmocka_unit_test(test_the_ring_hovers_unless_the_button_is_held),
        cmocka_unit_test(test_press_lowers_and_release_lifts_the_ring_in_the_set_times),
        cmocka_unit_test(test_the_acceleration_of_a_stroke_is_the_change_of_its_speed),
        cmocka_unit_test(test_the_pointer_stays_over_the_rings_centre_while_the_ring_rises),
        cmocka_unit_test(test_the_ring_sinks_nearer_to_the_player_and_ends_under_the_pointer),
        cmocka_unit_test(test_on_a_page_the_ring_sinks_straight_below_the_pointer),
        cmocka_unit_test(test_a_short_press_completes_the_downward_stroke),
        cmocka_unit_test(test_a_pause_without_samples_does_not_delay_the_lift),
        cmocka_unit_test(test_a_second_press_during_the_stroke_keeps_the_ring_down),
        cmocka_unit_test(test_a_press_under_water_does_not_move_the_ring_sideways),
        cmocka_unit_test(test_interrupted_strokes_have_no_jump_in_position_or_velocity),
        cmocka_unit_test(test_each_wheel_notch_tilts_the_ring_smoothly_up_to_a_limit),
        cmocka_unit_test(test_the_right_button_levels_the_ring),
        cmocka_unit_test(test_a_stroke_lowers_the_far_edge_and_ends_level),
        cmocka_unit_test(test_fast_motion_tilts_the_ring_in_the_direction_of_motion),
        cmocka_unit_test(test_the_ring_is_level_again_after_the_motion_stops),
        cmocka_unit_test(test_an_invalid_report_is_rejected_and_changes_nothing),
        cmocka_unit_test(test_any_pixel_and_any_time_give_a_finite_pose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
