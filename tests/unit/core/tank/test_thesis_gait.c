/* test_thesis_gait.c -- checks sections 2.1, 3.2 and 3.3 of the 2013 thesis: gaits, stamina and
 * speeds of a fish. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/gait.h"
#include "tests/unit/support/thesis.h"

static struct fish rested(uint8_t gait)
{
    return (struct fish){ .length_m = 0.05f,
                          .height_m = 0.02f,
                          .width_m = 0.01f,
                          .gait = gait,
                          .stamina = 1.0f,
                          .brake = 1.0f,
                          .room = 1.0f,
                          .gait_left_s = 1.0f };
}

/* Returns the surroundings of a fish in water with enough oxygen. The fish does not gulp there
 * (section 3.6), so that gulping does not disturb the test. */
static const struct perception *at(uint32_t tick)
{
    static struct behavior_params params;
    static struct perception around;
    params = *thesis_params();
    /* In these surroundings, only a lack of oxygen may cause gulping, and the water has enough
     * oxygen. */
    params.air_by_oxygen = 1;
    around = *thesis_at(7, tick);
    around.params = &params;
    around.oxygen_mg_l = 8.0f;
    return &around;
}

static void test_3_3_speeds_are_half_of_the_value_of_eq_2_1(void **state)
{
    (void)state;
    /* Distance that a fish moves with one tail beat, in body lengths (equation 2.2). */
    const float stride = 0.6f, length_m = 0.05f;
    const struct fish burst = rested(GAIT_BURST), swim = rested(GAIT_SWIM);
    assert_float_equal(gait_speed_m_s(&burst, at(0)), 0.5f * stride * 10.0f * length_m, 1e-6f);
    assert_float_equal(gait_speed_m_s(&swim, at(0)), 0.5f * stride * 3.5f * length_m, 1e-6f);
    assert_float_equal(gait_speed_max_m_s(&swim, thesis_params()), 0.5f * stride * 5.0f * length_m,
                       1e-6f);
}

/* The thesis prints s = d (0.8 + H / 5) with a stamina H from 0 to 100. This would give 20.8 d at H
 * = 100. The code therefore uses H as a fraction from 0 to 1, so that the speed is 0.8 d at H = 0
 * and d at H = 1. */
static void test_3_3_both_speeds_fall_to_four_fifths_with_stamina(void **state)
{
    (void)state;
    for (int h = 0; h <= 100; h += 10) {
        struct fish fish = rested(GAIT_SWIM);
        fish.stamina = 0.01f * (float)h;
        const float s = 0.8f + 0.01f * (float)h / 5.0f;
        assert_float_equal(gait_speed_m_s(&fish, at(0)), 0.0525f * s, 1e-6f);
        assert_float_equal(gait_speed_max_m_s(&fish, thesis_params()), 0.075f * s, 1e-6f);
        fish.gait = GAIT_BURST;
        assert_float_equal(gait_speed_m_s(&fish, at(0)), 0.15f * s, 1e-6f);
    }
}

/* The thesis computes a time of 0.1639 s from equation 2.3, and truncates it to 0.163. The equation
 * gives this value only with the decadic logarithm and a length in cm. */
static void test_eq_2_3_the_acceleration_time_at_5_cm_is_0_1639_s(void **state)
{
    (void)state;
    assert_float_equal(3.0f * gait_run_up_s(0.05f), 0.1639f, 0.0005f);
    assert_float_equal(3.0f * gait_run_up_s(0.04f), 0.1467f, 0.0005f);
}

/* By section 2.1, a fish reaches "95 % of the burst speed" after the time T_d. This is the law v =
 * v_t (1 - exp(-3 t / T_d)). Section 3.3 uses the same law for swimming. */
static void check_run_up(uint8_t gait, float goal_m_s)
{
    const struct tank_stage start = { .position_m = { 0.0f, -0.18f, 0.2f },
                                      .stamina = 1.0f,
                                      .gait = gait };
    struct tank *tank = thesis_stage(&start, 1, 3);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u; tick++) {
        tank_tick(tank, tick, NULL, 0);
        const float t_s = (float)(tick + 1u) * CORE_TICK_S;
        const float law_m_s = goal_m_s * (1.0f - f_exp(-3.0f * t_s / 0.1639f));
        assert_float_equal(tank->fish[0].speed_m_s, law_m_s, 0.02f * goal_m_s);
    }
}

static void test_2_1_bursts_and_swims_accelerate_by_the_same_law(void **state)
{
    (void)state;
    check_run_up(GAIT_BURST, 0.15f);
    check_run_up(GAIT_SWIM, 0.0525f);
}

/* The top speed must limit the whole motion. A fish that dives, climbs or is pushed must not be
 * faster. */
static void check_top_speed(uint8_t gait, float push_m_s, float most_m_s, float least_m_s)
{
    const struct tank_stage start = { .position_m = { 0.0f, -0.05f, 0.25f },
                                      .stamina = 1.0f,
                                      .speed_m_s = 0.99f * most_m_s,
                                      .gait = gait };
    struct tank *tank = thesis_stage(&start, 1, 3);
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ / 2u; tick++) {
        tank->fish[0].push_m_s = v3(0.0f, 0.0f, -push_m_s);
        tank_tick(tank, tick, NULL, 0);
        const float speed_m_s = v3_length(tank->fish[0].velocity_m_s);
        assert_true(speed_m_s < most_m_s + 1e-5f && speed_m_s > least_m_s);
    }
    assert_true(tank->fish[0].climb_m_s < -0.02f);
}

static void test_3_3_climbs_and_pushes_do_not_raise_the_top_speed(void **state)
{
    (void)state;
    check_top_speed(GAIT_BURST, 0.0f, 0.15f, 0.144f);
    check_top_speed(GAIT_BURST, 0.0225f, 0.15f, 0.10f);
    check_top_speed(GAIT_SWIM, 0.0225f, 0.075f, 0.06f);
}

static void check_choice(float stamina, float burst, float swim)
{
    uint32_t count[GAIT_COUNT] = { 0 };
    const uint32_t draws = 20000;
    for (uint32_t i = 0; i < draws; i++) {
        struct fish fish = rested(GAIT_REST);
        fish.stamina = stamina;
        fish.gait_left_s = 0.0f;
        gait_tick(&fish, i % 600u, at(i));
        count[fish.gait]++;
    }
    assert_float_equal((float)count[GAIT_BURST] / (float)draws, burst, 0.008f);
    assert_float_equal((float)count[GAIT_SWIM] / (float)draws, swim, 0.012f);
    assert_int_equal(count[GAIT_BURST] + count[GAIT_SWIM] + count[GAIT_REST], draws);
}

static void test_eqs_3_1_to_3_3_choose_the_gait_by_stamina(void **state)
{
    (void)state;
    check_choice(1.00f, 0.100f, 0.50f);
    check_choice(0.70f, 0.070f, 0.38f);
    check_choice(0.25f, 0.025f, 0.20f);
}

/* Equation 3.2 gives a fish without stamina (H = 0) a probability of 0.1 to swim, but the text of
 * the thesis excludes this. The code follows the text. */
static void test_3_2_a_fish_without_stamina_always_rests(void **state)
{
    (void)state;
    check_choice(-1.0f, 0.0f, 0.0f);
    assert_float_equal(gait_chance(0.0f).rest, 1.0f, 0.0f);
    assert_float_equal(gait_chance(0.001f).swim, 0.1004f, 1e-5f);
}

static void check_duration(uint8_t gait, float low_s, float high_s)
{
    static float drawn[4000];
    for (uint32_t i = 0; i < 4000; i++) {
        struct fish fish = rested(GAIT_REST);
        gait_enter(&fish, gait, i % 600u, at(i));
        drawn[i] = fish.gait_left_s;
    }
    assert_true(uniform_misfit(drawn, 4000, low_s, high_s) < UNIFORM_MISFIT_MAX(4000));
}

static void test_3_2_a_burst_lasts_1_to_3_s_a_swim_or_a_rest_5_to_20(void **state)
{
    (void)state;
    check_duration(GAIT_BURST, 1.0f, 3.0f);
    check_duration(GAIT_SWIM, 5.0f, 20.0f);
    check_duration(GAIT_REST, 5.0f, 20.0f);
}

static void check_cost(uint8_t gait, float per_s)
{
    struct fish fish = rested(gait);
    fish.stamina = 0.5f;
    fish.gait_left_s = 100.0f;
    for (uint32_t tick = 0; tick < 10u * CORE_TICK_HZ; tick++) {
        gait_tick(&fish, 0, at(tick));
    }
    assert_float_equal(100.0f * (fish.stamina - 0.5f), 10.0f * per_s, 0.01f);
}

static void test_3_2_of_100_a_burst_takes_1_a_second_a_swim_0_2_and_rest_gives_0_1(void **state)
{
    (void)state;
    check_cost(GAIT_BURST, -1.0f);
    check_cost(GAIT_SWIM, -0.2f);
    check_cost(GAIT_REST, 0.1f);
}

/* Tests equations 3.1 to 3.3 alone, so gulping (section 3.6), which would restore the stamina, is
 * disabled. The 200 fish start with a stamina of 30 to 100. They run for half an hour and are then
 * sampled for an hour. In equilibrium, the equations give 0.80 % bursts, 30.4 % swimming, 68.8 %
 * rest and a mean stamina of 47.9. */
static void test_3_2_the_long_run_has_0_8_percent_burst_31_swim_68_rest_and_h_48(void **state)
{
    (void)state;
    /* Number of behavior updates per second. As in the tank, a fish is updated in one of four
     * ticks. */
    const uint32_t hz = 30;
    float spent[GAIT_COUNT] = { 0.0f }, stamina = 0.0f;
    for (uint32_t i = 0; i < 200; i++) {
        struct fish fish = rested(GAIT_REST);
        fish.stamina = 0.3f + 0.7f * (float)i / 199.0f;
        struct perception around = *at(0);
        around.dt_s = 1.0f / (float)hz;
        float mine = 0.0f;
        uint32_t ticks[GAIT_COUNT] = { 0 };
        for (uint32_t tick = 0; tick < 5400u * hz; tick++) {
            around.tick = tick;
            gait_tick(&fish, i, &around);
            if (tick >= 1800u * hz) {
                ticks[fish.gait]++;
                mine += fish.stamina;
            }
        }
        for (uint32_t gait = 0; gait < GAIT_COUNT; gait++) {
            spent[gait] += (float)ticks[gait] / (float)(3600u * hz * 200u);
        }
        stamina += mine / (float)(3600u * hz * 200u);
    }
    print_message("burst %.4f, swim %.3f, rest %.3f, H %.1f\n", (double)spent[GAIT_BURST],
                  (double)spent[GAIT_SWIM], (double)spent[GAIT_REST], 100.0 * (double)stamina);
    assert_float_equal(spent[GAIT_BURST], 0.008f, 0.0005f);
    assert_float_equal(spent[GAIT_SWIM], 0.31f, 0.01f);
    assert_float_equal(spent[GAIT_REST], 0.68f, 0.01f);
    assert_float_equal(stamina, 0.48f, 0.01f);
}

/* Section 3.3 gives no angles. In the code, a new heading is drawn from a normal distribution
 * around the old one with a deviation of 45 degrees. A burst begins with a sharp turn to either
 * side. */
static void test_3_3_the_heading_changes_with_the_gait(void **state)
{
    (void)state;
    const uint8_t gaits[] = { GAIT_SWIM, GAIT_REST };
    for (uint32_t g = 0; g < 2; g++) {
        float sum = 0.0f, squares = 0.0f;
        for (uint32_t i = 0; i < 4000; i++) {
            struct fish fish = rested(GAIT_REST);
            gait_enter(&fish, gaits[g], i % 600u, at(i));
            sum += fish.heading_rad;
            squares += fish.heading_rad * fish.heading_rad;
        }
        assert_float_equal(sum / 4000.0f, 0.0f, 3.0f * F_DEG);
        assert_float_equal(f_sqrt(squares / 4000.0f), 45.0f * F_DEG, 2.0f * F_DEG);
    }
    uint32_t left = 0;
    for (uint32_t i = 0; i < 4000; i++) {
        struct fish fish = rested(GAIT_REST);
        gait_enter(&fish, GAIT_BURST, i % 600u, at(i));
        assert_true(f_abs(fish.heading_rad) >= 59.9f * F_DEG);
        assert_true(f_abs(fish.heading_rad) <= 120.1f * F_DEG);
        left += fish.heading_rad > 0.0f;
    }
    assert_in_range(left, 1900, 2100);
}

/* By section 3.2, a resting fish "stands still". In the code, the fish first glides until it is
 * slow, and then drifts at up to 0.5 cm/s. */
static void test_3_2_a_fish_that_comes_to_rest_glides_down_and_holds_its_depth(void **state)
{
    (void)state;
    const struct tank_stage start = {
        .position_m = { 0.0f, -0.13f, 0.2f }, .stamina = 0.6f, .speed_m_s = 0.05f, .gait = GAIT_REST
    };
    for (uint32_t seed = 1; seed <= 20; seed++) {
        struct tank *tank = thesis_stage(&start, 1, seed);
        float before_m_s = 0.05f;
        for (uint32_t tick = 0; tick < 5u * CORE_TICK_HZ; tick++) {
            tank_tick(tank, tick, NULL, 0);
            assert_true(tank->fish[0].speed_m_s <= before_m_s + 1e-6f);
            assert_float_equal(tank->fish[0].position_m.y, -0.13f, 0.001f);
            before_m_s = tank->fish[0].speed_m_s;
        }
        assert_true(before_m_s <= 0.0051f);
    }
}

static void test_3_3_a_swimming_fish_goes_straight_evenly_and_level(void **state)
{
    (void)state;
    const struct tank_stage start = { .position_m = { 0.0f, -0.13f, 0.25f },
                                      .stamina = 0.6f,
                                      .speed_m_s = 0.0525f * 0.92f,
                                      .gait = GAIT_SWIM };
    struct tank *tank = thesis_stage(&start, 1, 5);
    for (uint32_t tick = 0; tick < 4u * CORE_TICK_HZ; tick++) {
        tank_tick(tank, tick, NULL, 0);
        const struct fish *fish = &tank->fish[0];
        assert_float_equal(fish->angles.yaw_rad, 0.0f, 1e-4f);
        assert_float_equal(fish->angles.roll_rad, 0.0f, 1e-6f);
        assert_float_equal(fish->speed_m_s, 0.0525f * (0.8f + 0.2f * fish->stamina), 1e-4f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_3_3_speeds_are_half_of_the_value_of_eq_2_1),
        cmocka_unit_test(test_3_3_both_speeds_fall_to_four_fifths_with_stamina),
        cmocka_unit_test(test_eq_2_3_the_acceleration_time_at_5_cm_is_0_1639_s),
        cmocka_unit_test(test_2_1_bursts_and_swims_accelerate_by_the_same_law),
        cmocka_unit_test(test_3_3_climbs_and_pushes_do_not_raise_the_top_speed),
        cmocka_unit_test(test_eqs_3_1_to_3_3_choose_the_gait_by_stamina),
        cmocka_unit_test(test_3_2_a_fish_without_stamina_always_rests),
        cmocka_unit_test(test_3_2_a_burst_lasts_1_to_3_s_a_swim_or_a_rest_5_to_20),
        cmocka_unit_test(test_3_2_of_100_a_burst_takes_1_a_second_a_swim_0_2_and_rest_gives_0_1),
        cmocka_unit_test(test_3_2_the_long_run_has_0_8_percent_burst_31_swim_68_rest_and_h_48),
        cmocka_unit_test(test_3_3_the_heading_changes_with_the_gait),
        cmocka_unit_test(test_3_2_a_fish_that_comes_to_rest_glides_down_and_holds_its_depth),
        cmocka_unit_test(test_3_3_a_swimming_fish_goes_straight_evenly_and_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
