/* test_gait.c -- checks the gaits of the 2013 thesis (burst, swim and rest): probabilities,
 * durations, cost of stamina, and speeds. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/gait.h"
#include "tests/unit/support/pond.h"

#define WATER_M POND_WATER_M

static struct fish rested(void)
{
    return (struct fish){ WAKIN(0.05f), .stamina = 1.0f, .brake = 1.0f, .gait_left_s = 1.0f };
}

static void test_gait_probabilities_follow_the_equations_and_lie_between_0_and_1(void **state)
{
    (void)state;
    const struct gait_chance full = gait_chance(1.0f), half = gait_chance(0.5f);
    assert_float_equal(full.burst, 0.1f, 1e-6f);
    assert_float_equal(full.swim, 0.5f, 1e-6f);
    assert_float_equal(full.rest, 0.4f, 1e-6f);
    assert_float_equal(half.burst, 0.05f, 1e-6f);
    assert_float_equal(half.swim, 0.3f, 1e-6f);
    for (float h = 0.0f; h <= 1.0f; h += 0.01f) {
        const struct gait_chance chance = gait_chance(h);
        assert_true(chance.burst >= 0.0f && chance.burst <= 1.0f);
        assert_true(chance.swim >= 0.0f && chance.swim <= 1.0f);
        assert_true(chance.rest >= 0.0f && chance.rest <= 1.0f);
    }
}

static void test_an_exhausted_fish_can_only_rest(void **state)
{
    (void)state;
    assert_float_equal(gait_chance(0.0f).rest, 1.0f, 0.0f);
    assert_float_equal(gait_chance(0.0f).swim, 0.0f, 0.0f);
    for (uint32_t i = 0; i < 200; i++) {
        struct fish fish = rested();
        /* The stamina is already 0, and the end of the burst must not make it negative. */
        fish.gait = GAIT_BURST;
        fish.stamina = 0.0f;
        fish.gait_left_s = 0.0f;
        gait_tick(&fish, i, pond_at(1, i));
        assert_int_equal(fish.gait, GAIT_REST);
    }
}

static void check_stamina(uint8_t gait, float from, float per_s)
{
    struct fish fish = rested();
    fish.gait = gait;
    fish.stamina = from;
    fish.gait_left_s = 100.0f;
    for (uint32_t tick = 0; tick < 10 * CORE_TICK_HZ; tick++) {
        gait_tick(&fish, 0, pond_at(1, tick));
    }
    assert_float_equal(fish.stamina, from + 10.0f * per_s, 1e-4f);
}

static void test_burst_and_swim_cost_1_and_0_2_stamina_a_second_and_rest_gains_0_1(void **state)
{
    (void)state;
    check_stamina(GAIT_BURST, 0.8f, -0.01f);
    check_stamina(GAIT_SWIM, 0.8f, -0.002f);
    check_stamina(GAIT_REST, 0.5f, 0.001f);
}

static void test_gaits_have_the_durations_of_the_thesis(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2000; i++) {
        struct fish fish = rested();
        gait_enter(&fish, GAIT_BURST, 0, pond_at(3, i));
        assert_true(fish.gait_left_s >= 1.0f && fish.gait_left_s < 3.0f);
        gait_enter(&fish, i % 2u ? GAIT_SWIM : GAIT_REST, 1, pond_at(3, i));
        assert_true(fish.gait_left_s >= 5.0f && fish.gait_left_s < 20.0f);
        assert_true(fish.depth_goal_m < 0.0f && fish.depth_goal_m > -WATER_M);
    }
}

/* Measures the gaits of 60 fish for one hour each. */
static void test_a_fish_rests_two_thirds_of_its_time_in_the_long_run(void **state)
{
    (void)state;
    uint32_t ticks[GAIT_COUNT] = { 0 };
    for (uint32_t i = 0; i < 60; i++) {
        struct fish fish = rested();
        /* Sets the mean stamina of section 3.2 of the thesis, so that the fish is in equilibrium
         * from the beginning. */
        fish.stamina = 0.48f;
        for (uint32_t tick = 0; tick < 3600u * CORE_TICK_HZ; tick++) {
            gait_tick(&fish, i, pond_at(9, tick));
            ticks[fish.gait]++;
        }
    }
    const float all = (float)(ticks[GAIT_BURST] + ticks[GAIT_SWIM] + ticks[GAIT_REST]);
    print_message("burst %.4f, swim %.3f, rest %.3f\n", (double)((float)ticks[GAIT_BURST] / all),
                  (double)((float)ticks[GAIT_SWIM] / all), (double)((float)ticks[GAIT_REST] / all));
    assert_float_equal((float)ticks[GAIT_BURST] / all, 0.008f, 0.002f);
    assert_float_equal((float)ticks[GAIT_SWIM] / all, 0.31f, 0.02f);
    assert_float_equal((float)ticks[GAIT_REST] / all, 0.68f, 0.02f);
}

static void test_a_5_cm_fish_reaches_95_percent_of_its_speed_in_164_ms(void **state)
{
    (void)state;
    assert_float_equal(3.0f * gait_run_up_s(0.05f), 0.1639f, 0.001f);
    assert_true(gait_run_up_s(0.001f) > 0.0f);
}

static void test_speeds_are_halved_and_scale_with_length_and_stamina(void **state)
{
    (void)state;
    struct fish fish = rested();
    fish.gait = GAIT_BURST;
    assert_float_equal(gait_speed_m_s(&fish, pond_at(1, 0)), 0.15f, 1e-5f);
    fish.stamina = 0.0f;
    assert_float_equal(gait_speed_m_s(&fish, pond_at(1, 0)), 0.12f, 1e-5f);
    fish_grow(&fish, 0.04f, pond_params());
    assert_float_equal(gait_speed_m_s(&fish, pond_at(1, 0)), 0.096f, 1e-5f);
    fish.gait = GAIT_REST;
    assert_true(gait_speed_m_s(&fish, pond_at(1, 0)) <= 0.005f);
}

static void test_a_swimming_fish_beats_a_little_under_half_its_time(void **state)
{
    (void)state;
    struct fish fish = rested();
    fish.gait = GAIT_SWIM;
    uint32_t beats = 0;
    for (uint32_t tick = 0; tick < 8400; tick++) {
        beats += (uint32_t)gait_beats(&fish, pond_at(1, tick));
    }
    assert_in_range(beats, 3600, 4000);
}

static void test_fish_with_high_stamina_keep_low_and_tired_fish_keep_high(void **state)
{
    (void)state;
    assert_float_equal(gait_depth_m(0.9f, 0.2f), -0.18f, 1e-6f);
    assert_float_equal(gait_depth_m(0.6f, 0.2f), -0.13f, 1e-6f);
    assert_float_equal(gait_depth_m(0.3f, 0.2f), -0.08f, 1e-6f);
    assert_float_equal(gait_depth_m(0.1f, 0.2f), -0.03f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gait_probabilities_follow_the_equations_and_lie_between_0_and_1),
        cmocka_unit_test(test_an_exhausted_fish_can_only_rest),
        cmocka_unit_test(test_burst_and_swim_cost_1_and_0_2_stamina_a_second_and_rest_gains_0_1),
        cmocka_unit_test(test_gaits_have_the_durations_of_the_thesis),
        cmocka_unit_test(test_a_fish_rests_two_thirds_of_its_time_in_the_long_run),
        cmocka_unit_test(test_a_5_cm_fish_reaches_95_percent_of_its_speed_in_164_ms),
        cmocka_unit_test(test_speeds_are_halved_and_scale_with_length_and_stamina),
        cmocka_unit_test(test_a_swimming_fish_beats_a_little_under_half_its_time),
        cmocka_unit_test(test_fish_with_high_stamina_keep_low_and_tired_fish_keep_high),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
