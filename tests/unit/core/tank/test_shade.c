/* test_shade.c -- checks shadows on the water: for how long they rest, how they attract fish (2013
 * thesis, section 3.5), and how they startle fish. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/tank.h"

#define DT CORE_TICK_S

static const struct behavior_params *law_of(enum tank_preset_id preset)
{
    return &tank_preset((uint8_t)preset)->params;
}

static struct shade_cast fan_at(float x_m, float z_m)
{
    return (struct shade_cast){ 1, x_m, z_m, 0.10f, SHADE_FAN_DARK };
}

/* Returns the shadow of a fan that has been held still for `still_s` seconds. */
static struct shade still_fan(float still_s)
{
    const struct shade_cast cast = fan_at(0.0f, 0.0f);
    struct shade shade = { 0 };
    for (float t = 0.0f; t < still_s + 1.5f * DT; t += DT) {
        shade_tick(&shade, &cast, DT);
    }
    return shade;
}

static float pull_cm_s(const struct shade *shade, enum tank_preset_id preset, float distance_cm)
{
    return 100.0f * shade_pull_m_s(shade, law_of(preset), 0.01f * distance_cm);
}

static int near(float a, float b, float tolerance)
{
    return f_abs(a - b) <= tolerance;
}

/* ---- The pull of a shadow on fish ----------------------------------------------------------- */

/* Compares the pull with equation 3.5 of the thesis, whose factor S is 0.01 per frame. A tank of
 * 200 fish had 60 frames per second (table 4.2), so S is 0.6 per second. */
static void test_the_pull_is_equation_3_5_per_second(void **state)
{
    (void)state;
    const struct shade shade = still_fan(0.0f);
    for (float r_cm = 5.0f; r_cm <= 20.0f; r_cm += 0.5f) {
        const float pull = pull_cm_s(&shade, TANK_PRESET_THESIS, r_cm);
        assert_true(near(pull, 0.6f * (20.0f - r_cm), 1e-4f));
    }
}

/* The pull of a fan's shadow must end at twice the radius of the fan (figure 3.7 of the thesis). At
 * greater distances, equation 3.5 would give a negative pull, which would push fish away. */
static void test_a_shade_has_no_pull_beyond_twice_its_radius(void **state)
{
    (void)state;
    const struct shade shade = still_fan(9.0f);
    for (float r_cm = 20.001f; r_cm < 200.0f; r_cm += 3.0f) {
        assert_true(pull_cm_s(&shade, TANK_PRESET_THESIS, r_cm) == 0.0f);
        assert_true(pull_cm_s(&shade, TANK_PRESET_FESTIVAL, r_cm) == 0.0f);
    }
}

/* In area A of figure 3.7, closer than 3 to 5 cm, the fan has no pull. In the thesis the pull ends
 * abruptly, but in this game it fades out from 5 to 3 cm. */
static void test_the_pull_fades_to_none_between_5_and_3_cm(void **state)
{
    (void)state;
    const struct shade shade = still_fan(0.0f);
    assert_true(near(pull_cm_s(&shade, TANK_PRESET_THESIS, 4.0f), 0.5f * 0.6f * 16.0f, 1e-4f));
    for (float r_cm = 0.0f; r_cm <= 3.0f; r_cm += 0.25f) {
        assert_true(pull_cm_s(&shade, TANK_PRESET_THESIS, r_cm) <= 1e-5f);
    }
}

/* The distance must be measured horizontally, because a three-dimensional distance would let the
 * shadow pull fish upward. */
static void test_the_pull_ignores_depth(void **state)
{
    (void)state;
    const struct shade shade = still_fan(0.0f);
    assert_true(near(shade_distance_m(&shade.cast, v3(0.06f, -0.18f, 0.08f)), 0.10f, 1e-6f));
    assert_true(shade_covers(&shade.cast, v3(0.0f, -0.19f, 0.099f)));
    assert_false(shade_covers(&shade.cast, v3(0.0f, -0.01f, 0.101f)));
}

static void test_the_pull_acts_immediately_on_thesis_fish_and_else_after_the_dwell(void **state)
{
    (void)state;
    const struct shade fresh = still_fan(0.0f);
    assert_true(pull_cm_s(&fresh, TANK_PRESET_THESIS, 10.0f) > 5.9f);
    for (int preset = TANK_PRESET_FESTIVAL; preset < TANK_PRESET_COUNT; preset++) {
        const float dwell_s = law_of((enum tank_preset_id)preset)->shade_dwell_s;
        const struct shade early = still_fan(dwell_s - 0.1f);
        const struct shade late = still_fan(dwell_s + 0.1f);
        assert_true(preset == TANK_PRESET_THESIS ? dwell_s == 0.0f
                                                 : dwell_s >= 2.0f && dwell_s <= 3.0f);
        assert_true(preset == TANK_PRESET_THESIS ||
                    pull_cm_s(&early, (enum tank_preset_id)preset, 10.0f) == 0.0f);
        assert_true(pull_cm_s(&late, (enum tank_preset_id)preset, 10.0f) > 5.9f);
    }
}

/* ---- The pull and the fish's own course ----------------------------------------------------- */

static int draw(struct shade_course *course, vec3 at_m, float yaw_rad)
{
    const struct shade shade = still_fan(0.0f);
    const struct fish fish = {
        .position_m = at_m, .angles = { .yaw_rad = yaw_rad }, .length_m = 0.05f, .stamina = 1.0f
    };
    return shade_draw(&shade, 1, law_of(TANK_PRESET_THESIS), &fish, course);
}

/* By section 3.3 of the thesis, a swimming fish is never faster than 7.5 cm/s, even while a shadow
 * pulls it. */
static void test_a_fish_with_the_pull_keeps_to_7_5_cm_s(void **state)
{
    (void)state;
    for (float r_m = 0.03f; r_m < 0.2f; r_m += 0.005f) {
        for (float yaw_rad = -3.0f; yaw_rad < 3.0f; yaw_rad += 0.2f) {
            struct shade_course course = { .heading_rad = yaw_rad, .speed_m_s = 0.0525f };
            draw(&course, v3(r_m, -0.1f, 0.0f), course.heading_rad);
            assert_true(course.speed_m_s <= 0.0750001f);
        }
    }
    struct shade_course inward = { .heading_rad = 0.5f * F_PI, .speed_m_s = 0.0525f };
    /* Swimming (5.25 cm/s) and the pull (6 cm/s) would add up to 11.25 cm/s, so the speed is
     * limited to 7.5 cm/s. */
    assert_true(draw(&inward, v3(0.10f, -0.1f, 0.0f), 0.5f * F_PI));
    assert_true(near(inward.speed_m_s, 0.075f, 1e-5f));
}

static void test_course_and_pull_add_up_as_velocities(void **state)
{
    (void)state;
    /* At 13 cm from the shadow, the pull is 4.2 cm/s toward -x. The fish swims at 3 cm/s toward -z.
     * The new heading must be the direction of the sum of both. */
    const float want_rad = f_atan2(0.042f, 0.03f);
    struct shade_course course = { .heading_rad = 0.0f, .speed_m_s = 0.03f };
    assert_true(draw(&course, v3(0.13f, -0.1f, 0.0f), want_rad));
    assert_true(near(course.heading_rad, want_rad, 1e-3f));
    assert_true(near(course.speed_m_s, f_sqrt(0.03f * 0.03f + 0.042f * 0.042f), 1e-4f));
}

static void test_a_fish_turns_toward_the_shade_before_it_swims_there(void **state)
{
    (void)state;
    struct shade_course course = { .heading_rad = 0.0f, .speed_m_s = 0.0f };
    /* The fish faces away from the shadow. It must therefore first turn on the spot. */
    assert_true(draw(&course, v3(0.10f, -0.1f, 0.0f), -0.5f * F_PI));
    assert_true(near(course.heading_rad, 0.5f * F_PI, 1e-3f));
    assert_true(course.speed_m_s == 0.0f);
}

static void test_a_shade_does_not_change_a_course_outside_its_field(void **state)
{
    (void)state;
    struct shade_course course = { .heading_rad = 1.25f, .speed_m_s = 0.04f };
    assert_false(draw(&course, v3(0.21f, -0.1f, 0.0f), 0.0f));
    assert_false(draw(&course, v3(0.02f, -0.1f, 0.0f), 0.0f));
    assert_true(course.heading_rad == 1.25f && course.speed_m_s == 0.04f);
}

/* ---- How long a shadow rests ---------------------------------------------------------------- */

static void glide(struct shade *shade, float speed_m_s, float seconds)
{
    struct shade_cast cast = shade->cast;
    for (float t = 0.0f; t < seconds; t += DT) {
        cast.x_m += speed_m_s * DT;
        shade_tick(shade, &cast, DT);
    }
}

static void test_a_moved_shadow_restarts_its_dwell(void **state)
{
    (void)state;
    struct shade shade = still_fan(4.0f);
    assert_true(near(shade.still_s, 4.0f, 2.0f * DT));
    glide(&shade, 0.08f, 0.5f);
    assert_true(shade.still_s == 0.0f);
    assert_true(near(shade.edge_m_s, 0.08f, 0.002f));
    assert_true(pull_cm_s(&shade, TANK_PRESET_FESTIVAL, 10.0f) == 0.0f);
}

static void test_a_slowly_moving_shadow_keeps_its_fish(void **state)
{
    (void)state;
    struct shade shade = still_fan(4.0f);
    glide(&shade, 0.035f, 2.0f);
    assert_true(near(shade.still_s, 4.0f, 0.1f));
    assert_true(pull_cm_s(&shade, TANK_PRESET_FESTIVAL, 10.0f) > 5.9f);
    assert_true(shade_alarm(&shade, law_of(TANK_PRESET_FESTIVAL), v3(shade.cast.x_m, -0.05f, 0),
                            DT) == 0.0f);
}

/* A slow mouse moves the shadow in steps of one pixel (0.85 mm), and the shadow rests between the
 * steps. The mean speed must decide whether the shadow counts as resting. */
static void test_the_steps_of_a_slow_mouse_do_not_restart_the_dwell(void **state)
{
    (void)state;
    struct shade shade = still_fan(1.0f);
    struct shade_cast cast = shade.cast;
    for (int i = 0; i < 240; i++) {
        /* Moves the shadow by 0.85 mm in every 30th tick, which is 3.4 mm/s on average. */
        cast.x_m += i % 30 == 0 ? 0.00085f : 0.0f;
        shade_tick(&shade, &cast, DT);
        assert_true(shade.edge_m_s < SHADE_MOVES_M_S);
    }
    assert_true(shade.still_s > 2.0f);
}

static void test_a_growing_shadow_has_a_moving_edge(void **state)
{
    (void)state;
    struct shade shade = still_fan(3.0f);
    struct shade_cast cast = shade.cast;
    for (int i = 0; i < 60; i++) {
        cast.radius_m += 0.10f * DT;
        shade_tick(&shade, &cast, DT);
    }
    assert_true(near(shade.edge_m_s, 0.10f, 0.005f));
    assert_true(shade.still_s == 0.0f);
}

static void test_a_removed_shadow_leaves_no_state(void **state)
{
    (void)state;
    struct shade shade = still_fan(5.0f);
    const struct shade_cast none = { 0 };
    const struct shade zero = { 0 };
    shade_tick(&shade, &none, DT);
    assert_memory_equal(&shade, &zero, sizeof zero);
}

static void test_a_shadow_without_a_valid_position_fails_an_assertion(void **state)
{
    (void)state;
    struct shade shade = { 0 };
    struct shade_cast lost = fan_at(0.0f, 0.0f);
    lost.x_m = 1.0f / 0.0f;
    expect_assert_failure(shade_tick(&shade, &lost, DT));
    lost = fan_at(0.0f, f_sqrt(-1.0f));
    expect_assert_failure(shade_tick(&shade, &lost, DT));
    lost = fan_at(0.0f, 0.0f);
    lost.radius_m = 0.0f;
    expect_assert_failure(shade_tick(&shade, &lost, DT));
}

/* ---- Startling by shadows ------------------------------------------------------------------- */

static float alarm(const struct shade *shade, enum tank_preset_id preset, float r_m)
{
    return shade_alarm(shade, law_of(preset), v3(shade->cast.x_m, -0.05f, r_m), DT);
}

static void test_a_new_shadow_startles_the_fish_that_it_covers(void **state)
{
    (void)state;
    const struct shade fresh = still_fan(0.0f);
    const struct shade old = still_fan(0.5f);
    assert_true(alarm(&fresh, TANK_PRESET_FESTIVAL, 0.05f) > 0.0f);
    assert_true(alarm(&fresh, TANK_PRESET_OFFICIAL, 0.05f) > 0.0f);
    assert_true(alarm(&fresh, TANK_PRESET_FESTIVAL, 0.15f) == 0.0f);
    assert_true(alarm(&old, TANK_PRESET_FESTIVAL, 0.05f) == 0.0f);
}

static void test_an_edge_faster_than_5_cm_s_startles(void **state)
{
    (void)state;
    struct shade slow = still_fan(2.0f), fast = slow;
    glide(&slow, 0.045f, 1.0f);
    glide(&fast, 0.055f, 1.0f);
    assert_true(alarm(&slow, TANK_PRESET_FESTIVAL, 0.05f) == 0.0f);
    assert_true(alarm(&fast, TANK_PRESET_FESTIVAL, 0.05f) > 0.0f);
}

/* In the thesis, only a resting shadow has an effect (section 3.5), so a moving shadow must not
 * startle fish. */
static void test_shadows_do_not_startle_thesis_fish(void **state)
{
    (void)state;
    struct shade shade = still_fan(0.0f);
    assert_true(alarm(&shade, TANK_PRESET_THESIS, 0.0f) == 0.0f);
    glide(&shade, 1.0f, 0.3f);
    assert_true(alarm(&shade, TANK_PRESET_THESIS, 0.0f) == 0.0f);
    assert_true(pull_cm_s(&shade, TANK_PRESET_THESIS, 10.0f) > 5.9f);
}

/* Thin paper casts a weak shadow. The alarm of the fish must rise only a twentieth as fast as under
 * a fan. */
static void test_thin_paper_alarms_a_twentieth_as_much_as_a_fan(void **state)
{
    (void)state;
    struct shade fan = still_fan(0.0f), paper = fan;
    paper.cast.dark = 0.34f;
    const float ratio =
        alarm(&paper, TANK_PRESET_FESTIVAL, 0.0f) / alarm(&fan, TANK_PRESET_FESTIVAL, 0.0f);
    assert_true(ratio > 0.03f && ratio < 0.07f);
    paper.cast.dark = SHADE_SUDDEN_DARK;
    assert_true(alarm(&paper, TANK_PRESET_FESTIVAL, 0.0f) == 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_pull_is_equation_3_5_per_second),
        cmocka_unit_test(test_a_shade_has_no_pull_beyond_twice_its_radius),
        cmocka_unit_test(test_the_pull_fades_to_none_between_5_and_3_cm),
        cmocka_unit_test(test_the_pull_ignores_depth),
        cmocka_unit_test(test_the_pull_acts_immediately_on_thesis_fish_and_else_after_the_dwell),
        cmocka_unit_test(test_a_fish_with_the_pull_keeps_to_7_5_cm_s),
        cmocka_unit_test(test_course_and_pull_add_up_as_velocities),
        cmocka_unit_test(test_a_fish_turns_toward_the_shade_before_it_swims_there),
        cmocka_unit_test(test_a_shade_does_not_change_a_course_outside_its_field),
        cmocka_unit_test(test_a_moved_shadow_restarts_its_dwell),
        cmocka_unit_test(test_a_slowly_moving_shadow_keeps_its_fish),
        cmocka_unit_test(test_the_steps_of_a_slow_mouse_do_not_restart_the_dwell),
        cmocka_unit_test(test_a_growing_shadow_has_a_moving_edge),
        cmocka_unit_test(test_a_removed_shadow_leaves_no_state),
        cmocka_unit_test(test_a_shadow_without_a_valid_position_fails_an_assertion),
        cmocka_unit_test(test_a_new_shadow_startles_the_fish_that_it_covers),
        cmocka_unit_test(test_an_edge_faster_than_5_cm_s_startles),
        cmocka_unit_test(test_shadows_do_not_startle_thesis_fish),
        cmocka_unit_test(test_thin_paper_alarms_a_twentieth_as_much_as_a_fan),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
