/* test_swim.c -- checks the motion of a single fish: limited turns, glides, depth, falls and the
 * tail beat. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/swim.h"
#include "tests/unit/support/pond.h"

static struct fish swimmer(void)
{
    return pond_fish(0.05f, GAIT_SWIM);
}

static void swim_one_tick(struct fish *fish)
{
    const vec3 before = fish->position_m;
    swim_move(fish, pond_params());
    swim_settle(fish, v3_sub(fish->position_m, before), fish_forward(fish));
}

/* Lets the fish swim at the speed `speed_m_s` for `ticks` ticks, with a continuous tail beat. */
static void swim_ticks(struct fish *fish, uint32_t ticks, float speed_m_s)
{
    for (uint32_t tick = 0; tick < ticks; tick++) {
        swim_resolve(fish, pond_at(1, tick));
        fish->speed_goal_m_s = speed_m_s;
        fish->beats = 1;
        swim_one_tick(fish);
    }
}

static void test_a_fish_swims_along_its_nose(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    swim_ticks(&fish, 5 * CORE_TICK_HZ, 0.05f);
    /* In 5 s at 5 cm/s the fish swims 25 cm. At yaw 0 it swims toward -z. */
    assert_float_equal(fish.position_m.z, -0.25f, 0.01f);
    assert_float_equal(fish.position_m.x, 0.0f, 1e-4f);
}

static void test_a_fish_reaches_95_percent_of_its_speed_after_the_run_up(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    fish.gait = GAIT_BURST;
    const vec3 start = fish.position_m;
    uint32_t ticks = 0;
    while (v3_length(fish.velocity_m_s) < 0.95f * 0.15f && ticks < 100) {
        swim_ticks(&fish, 1, 0.15f);
        ticks++;
    }
    /* The acceleration takes 0.1639 s (19.7 ticks), so the fish must reach the speed in tick 20. */
    assert_int_equal(ticks, 20);
    /* With the law v (1 - exp(-3 t / T)), the fish has swum 1.72 cm after 0.167 s. At a constant 15
     * cm/s it would have needed 0.052 s less for this distance. */
    assert_float_equal(v3_length(v3_sub(fish.position_m, start)), 0.0172f, 0.0007f);
}

static void test_a_glide_loses_speed_slowly(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    swim_ticks(&fish, CORE_TICK_HZ, 0.1f);
    swim_ticks(&fish, CORE_TICK_HZ / 2u, 0.0f);
    assert_true(fish.speed_m_s > 0.03f && fish.speed_m_s < 0.05f);
}

/* Lets the fish swim for a minute, with alternating tail beats and glides. Returns the mean speed
 * in lengths per second. */
static float swim_a_minute(struct fish *fish, float *fastest)
{
    const uint32_t ticks = 60u * CORE_TICK_HZ;
    float sum_m = 0.0f;
    *fastest = 0.0f;
    for (uint32_t tick = 0; tick < ticks + CORE_TICK_HZ; tick++) {
        const vec3 before = fish->position_m;
        if (tick % FISH_BEHAVIOR_TICKS == 0) {
            swim_resolve(fish, pond_at(1, tick));
        }
        swim_one_tick(fish);
        const vec3 moved = v3_sub(fish->position_m, before);
        if (tick >= CORE_TICK_HZ) {
            const float flat_m = v3_length(v3(moved.x, 0.0f, moved.z));
            sum_m += flat_m;
            *fastest = f_max(*fastest, flat_m * (float)CORE_TICK_HZ / fish->length_m);
        }
    }
    return sum_m / (60.0f * fish->length_m);
}

static void test_a_fish_that_swims_a_minute_keeps_the_preferred_speed(void **state)
{
    (void)state;
    float worst = 0.0f, fastest = 0.0f;
    for (uint32_t rhythm = 0; rhythm < 64; rhythm += 9) {
        for (float length_m = 0.033f; length_m < 0.085f; length_m += 0.01f) {
            float peak = 0.0f;
            struct fish fish = swimmer();
            fish.look = rhythm << 8;
            fish_grow(&fish, length_m, pond_params());
            worst = f_max(worst, f_abs(swim_a_minute(&fish, &peak) - 1.05f));
            fastest = f_max(fastest, peak);
        }
    }
    print_message("off 1.05 lengths/s by %.3f at most, fastest %.2f\n", (double)worst,
                  (double)fastest);
    assert_true(worst < 0.02f);
    /* Because tail beats and glides alternate, the highest speed of a fish must be above its mean
     * speed. */
    assert_true(fastest > 1.1f && fastest < 1.5f);
}

static void test_pushes_do_not_make_a_swimming_fish_faster_than_one_and_a_half_lengths(void **state)
{
    (void)state;
    for (int degrees = 0; degrees < 360; degrees += 30) {
        float fastest = 0.0f;
        struct fish fish = swimmer();
        fish.push_m_s = v3(0.0225f * f_sin((float)degrees * F_DEG), 0.0f,
                           0.0225f * f_cos((float)degrees * F_DEG));
        swim_a_minute(&fish, &fastest);
        assert_true(fastest < 1.501f);
    }
}

static void test_a_burst_slows_smoothly_within_half_a_second(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    fish.speed_m_s = 0.15f;
    float last_m_s = 0.15f;
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u; tick++) {
        swim_ticks(&fish, 1, 0.05f);
        const float now_m_s = v3_length(fish.velocity_m_s);
        /* The fish must slow down gradually. If it stopped abruptly, it would lose 7.5 cm/s in one
         * tick. */
        assert_true(last_m_s - now_m_s < 0.006f);
        last_m_s = now_m_s;
    }
    assert_true(last_m_s < 0.0751f);
}

/* Checks the highest yaw rate of a fish with the gait `gait`. `look` sets the phase of its cycle of
 * tail beats and glides. */
static void check_turn(uint8_t gait, uint32_t look, float rate_max_deg_s)
{
    struct fish fish = swimmer();
    fish.gait = gait;
    fish.look = look;
    fish.heading_rad = 170.0f * F_DEG;
    float last_rad = 0.0f;
    for (uint32_t tick = 0; tick < 8 * CORE_TICK_HZ; tick++) {
        swim_ticks(&fish, 1, 0.05f);
        const float rate =
            f_abs(f_wrap_angle(fish.angles.yaw_rad - last_rad)) * (float)CORE_TICK_HZ;
        assert_true(rate <= rate_max_deg_s * F_DEG + 1e-3f);
        last_rad = fish.angles.yaw_rad;
    }
    assert_float_equal(fish.angles.yaw_rad, fish.heading_rad, 0.02f);
}

static void test_turns_are_limited_by_the_gait_and_reach_their_goal(void **state)
{
    (void)state;
    check_turn(GAIT_REST, 0, 45.0f);
    /* In this phase of the cycle the fish glides, so it must turn slowly. */
    check_turn(GAIT_SWIM, 40u << 14, 180.0f);
    /* At phase 0 the fish beats its tail, so it may turn faster. */
    check_turn(GAIT_SWIM, 0, 500.0f);
    check_turn(GAIT_BURST, 0, 720.0f);
}

static void test_an_escape_turns_a_right_angle_within_a_tenth_of_a_second(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    fish.gait = GAIT_ESCAPE;
    fish.heading_rad = 110.0f * F_DEG;
    swim_ticks(&fish, 12, 0.4f);
    assert_true(fish.angles.yaw_rad > 90.0f * F_DEG);
    assert_true(fish.speed_m_s > 0.35f);
}

static void test_depth_is_kept_with_the_nose_nearly_level(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    /* A resting fish changes its depth with its swim bladder, so it must stay nearly level. */
    fish.gait = GAIT_REST;
    fish.depth_goal_m = -0.09f;
    for (uint32_t tick = 0; tick < 20 * CORE_TICK_HZ; tick++) {
        swim_ticks(&fish, 1, 0.002f);
        assert_true(f_abs(fish.angles.pitch_rad) < 25.0f * F_DEG);
        assert_true(f_abs(fish.velocity_m_s.y) <= 0.03f);
    }
    assert_float_equal(fish.position_m.y, -0.09f, 0.002f);
    assert_float_equal(fish.angles.pitch_rad, 0.0f, 0.02f);
}

static void check_beat(float lengths_per_s, float hz)
{
    struct fish fish = swimmer();
    fish.beats = 1;
    for (uint32_t tick = 0; tick < 3 * CORE_TICK_HZ; tick++) {
        swim_settle(&fish, v3(0.0f, 0.0f, -lengths_per_s * fish.length_m * CORE_TICK_S),
                    v3(0.0f, 0.0f, -1.0f));
        assert_true(fish.tail_phase_rad >= 0.0f && fish.tail_phase_rad < F_TAU);
    }
    assert_float_equal(fish.tail_beat_hz, hz, 0.01f * hz);
}

static void test_the_tail_beat_follows_the_true_speed(void **state)
{
    (void)state;
    check_beat(0.0f, 0.5f);
    check_beat(1.05f, 1.75f);
    check_beat(3.99f, 6.65f);
    /* There is one formula for slow fish and one for fast fish. Both must give the same tail beat
     * at four body lengths per second. */
    check_beat(4.01f, 6.68f);
    check_beat(9.0f, 13.333f);
}

/* By Bainbridge 1958, the amplitude of the tail grows with the frequency up to 5 Hz, and is
 * constant at higher frequencies. An amplitude of 1 means a fifth of the body length. */
static void test_the_stroke_widens_up_to_five_beats_a_second(void **state)
{
    (void)state;
    struct fish still = swimmer(), cruising = swimmer(), fast = swimmer(), fleeing = swimmer();
    cruising.beats = fast.beats = fleeing.beats = 1;
    for (uint32_t tick = 0; tick < 2 * CORE_TICK_HZ; tick++) {
        swim_settle(&still, v3(0.0f, 0.0f, 0.0f), v3(0.0f, 0.0f, -1.0f));
        swim_settle(&cruising, v3(0.0f, 0.0f, -0.08f * CORE_TICK_S), v3(0.0f, 0.0f, -1.0f));
        swim_settle(&fast, v3(0.0f, 0.0f, -0.15f * CORE_TICK_S), v3(0.0f, 0.0f, -1.0f));
        swim_settle(&fleeing, v3(0.0f, 0.0f, -0.45f * CORE_TICK_S), v3(0.0f, 0.0f, -1.0f));
    }
    assert_float_equal(still.tail_amplitude, 0.15f, 0.01f);
    /* At 2.7 beats per second, the amplitude must be below its maximum. */
    assert_float_equal(cruising.tail_amplitude, 0.61f, 0.01f);
    /* At 5 beats per second, the amplitude must reach its maximum. */
    assert_float_equal(fast.tail_amplitude, 1.0f, 0.01f);
    /* At 13 beats per second, the amplitude must still be at its maximum. Only the frequency is
     * higher. */
    assert_float_equal(fleeing.tail_amplitude, 1.0f, 0.01f);
}

static void test_the_body_bends_along_its_arc(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    /* Lets the fish turn to its left by 90 degrees. */
    fish.heading_rad = 90.0f * F_DEG;
    swim_ticks(&fish, CORE_TICK_HZ / 4u, 0.05f);
    /* In a turn to the left, the tail must bend to the left, which is a negative value. */
    assert_true(fish.bend_rad < -0.1f);
}

static void test_a_fish_turns_from_a_wall_before_it_touches_the_wall(void **state)
{
    (void)state;
    for (int degrees = -180; degrees < 180; degrees += 15) {
        struct fish fish = swimmer();
        fish.position_m = v3(0.25f, -0.06f, 0.10f);
        fish.angles.yaw_rad = fish.heading_rad = (float)degrees * F_DEG;
        const vec3 size_m = { 0.85f, 0.12f, 0.55f };
        float nearest = 1.0f;
        for (uint32_t tick = 0; tick < 30 * CORE_TICK_HZ; tick++) {
            struct swim_avoidance avoidance = { 0 };
            swim_avoid_walls(&avoidance, &fish, pond_params(), size_m);
            swim_avoid_turn(&fish, &avoidance, CORE_TICK_S);
            swim_ticks(&fish, 1, 0.0525f);
            const struct box box = fish_box(&fish);
            const vec3 extent = box_extent_m(&box);
            nearest = f_min(nearest, f_min(0.425f - f_abs(fish.position_m.x) - extent.x,
                                           0.275f - f_abs(fish.position_m.z) - extent.z));
        }
        assert_true(nearest > 0.0f);
    }
}

static void test_a_dropped_fish_falls_into_the_water_and_stays_there(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    fish.position_m.y = 0.10f;
    fish.gait = GAIT_ESCAPE;
    uint32_t ticks = 0;
    while (swim_fall(&fish)) {
        ticks++;
        assert_true(ticks < CORE_TICK_HZ);
    }
    /* A fall of 9 cm must take 0.135 s (16 ticks). */
    assert_true(ticks > 15);
    assert_true(fish.position_m.y < 0.0f && fish.position_m.y > -0.1f);
    assert_int_equal(swim_fall(&fish), 0);
}

static bool is_denormal(float x)
{
    return x != 0.0f && f_abs(x) < FLT_MIN;
}

static void test_fading_values_reach_zero(void **state)
{
    (void)state;
    struct fish fish = swimmer();
    fish.gait = GAIT_REST;
    fish.speed_m_s = 0.1f;
    fish.climb_m_s = 0.02f;
    fish.push_m_s = v3(0.02f, 0.01f, -0.02f);
    for (uint32_t tick = 0; tick < 60u * CORE_TICK_HZ; tick++) {
        swim_ticks(&fish, 1, 0.0f);
        fish.push_m_s = v3_scale(fish.push_m_s, 0.9f);
        assert_false(is_denormal(fish.speed_m_s) || is_denormal(fish.climb_m_s));
        assert_false(is_denormal(fish.push_m_s.x) || is_denormal(fish.push_m_s.y));
    }
    assert_true(fish.speed_m_s == 0.0f && v3_length(fish.push_m_s) == 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_swims_along_its_nose),
        cmocka_unit_test(test_a_fish_reaches_95_percent_of_its_speed_after_the_run_up),
        cmocka_unit_test(test_a_fish_that_swims_a_minute_keeps_the_preferred_speed),
        cmocka_unit_test(
            test_pushes_do_not_make_a_swimming_fish_faster_than_one_and_a_half_lengths),
        cmocka_unit_test(test_a_burst_slows_smoothly_within_half_a_second),
        cmocka_unit_test(test_a_glide_loses_speed_slowly),
        cmocka_unit_test(test_turns_are_limited_by_the_gait_and_reach_their_goal),
        cmocka_unit_test(test_an_escape_turns_a_right_angle_within_a_tenth_of_a_second),
        cmocka_unit_test(test_depth_is_kept_with_the_nose_nearly_level),
        cmocka_unit_test(test_the_tail_beat_follows_the_true_speed),
        cmocka_unit_test(test_the_stroke_widens_up_to_five_beats_a_second),
        cmocka_unit_test(test_the_body_bends_along_its_arc),
        cmocka_unit_test(test_a_fish_turns_from_a_wall_before_it_touches_the_wall),
        cmocka_unit_test(test_a_dropped_fish_falls_into_the_water_and_stays_there),
        cmocka_unit_test(test_fading_values_reach_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
