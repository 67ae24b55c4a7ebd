/* test_escape.c -- measures the C-start, which is the escape response of a startled fish, over many
 * fish. The measurements are the turn, the share of fish that turn away from the stimulus, the
 * acceleration, the distance and the speed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/behavior/swim.h"
#include "tests/unit/support/pond.h"

#define TRIALS 4000u
#define LENGTH_M 0.05f

/* Measurements of one C-start. In this escape response, the body bends into a C and then
 * straightens. */
struct trial {
    /* Largest turn of the head in stage 1 (the bend into a C), positive to the left. */
    float head_turn_rad;
    /* Side of the fish that is away from the stimulus: +1 is left and -1 is right. */
    float away_side;
    float way_lengths;  /* Distance that the fish moves in 100 ms. */
    float away_lengths; /* Component of `way_lengths` away from the stimulus. */
    /* Highest speed of the fish, and highest acceleration over 17 ms. */
    float peak_lengths_s, push_m_s2;
    /* Time of the highest speed, and time of the last tick in which the fish was faster than 4 body
     * lengths per second. */
    float peak_s, slow_s;
    float bend_rad; /* Largest bend into the C (absolute value). */
    float back_rad; /* Largest bend to the opposite side. */
    float stage_s;  /* Time of the largest bend into the C. */
};

static struct fish still_fish(uint32_t seed)
{
    struct fish fish = pond_fish(LENGTH_M, GAIT_REST);
    fish.look = rng_u32((struct rng_key){ seed, 0, 0, RNG_TEST });
    return fish;
}

/* Runs one tick of a fish in the same way as the tank, but without other fish. */
static void tick_alone(struct fish *fish, uint32_t index, const struct perception *around)
{
    const vec3 before_m = fish->position_m;
    gait_tick(fish, index, around);
    if (fish->gait == GAIT_ESCAPE) {
        escape_tick(fish, around);
    }
    swim_resolve(fish, around);
    swim_move(fish, around->params);
    swim_settle(fish, v3_sub(fish->position_m, before_m), fish_forward(fish));
}

/* Returns the direction of the head, which also turns when the front part of the body bends. */
static float head_rad(const struct fish *fish)
{
    return fish->angles.yaw_rad - 0.38f * fish->bend_rad;
}

static struct trial start(struct fish fish, vec3 from_m, uint32_t index, uint32_t ticks)
{
    const vec3 at_m = fish.position_m;
    const float yaw_rad = fish.angles.yaw_rad;
    const vec3 away = v3_normalize_or(v3(at_m.x - from_m.x, 0.0f, at_m.z - from_m.z), at_m);
    const float side_rad = f_wrap_angle(f_atan2(-away.x, -away.z) - yaw_rad);
    struct trial trial = { .away_side = side_rad < 0.0f ? -1.0f : 1.0f };
    float speed_m_s[4] = { 0 };
    escape_start(&fish, from_m, index, pond_at(11, 0));
    for (uint32_t tick = 1; tick <= ticks; tick++) {
        const float s = (float)tick * CORE_TICK_S;
        tick_alone(&fish, index, pond_at(11, tick));
        const vec3 flat = v3(fish.velocity_m_s.x, 0.0f, fish.velocity_m_s.z);
        speed_m_s[tick % 4u] = v3_length(flat);
        const float gained_m_s = speed_m_s[tick % 4u] - speed_m_s[(tick + 2u) % 4u];
        trial.push_m_s2 = f_max(trial.push_m_s2, gained_m_s / (2.0f * CORE_TICK_S));
        if (f_abs(fish.bend_rad) > trial.bend_rad && tick <= 4u) {
            trial.bend_rad = f_abs(fish.bend_rad);
            trial.head_turn_rad = f_wrap_angle(head_rad(&fish) - yaw_rad);
            trial.stage_s = s;
        }
        const float turned = trial.head_turn_rad < 0.0f ? -1.0f : 1.0f;
        trial.back_rad = f_max(trial.back_rad, turned * fish.bend_rad);
        if (speed_m_s[tick % 4u] / LENGTH_M > trial.peak_lengths_s) {
            trial.peak_lengths_s = speed_m_s[tick % 4u] / LENGTH_M;
            trial.peak_s = s;
        }
        trial.slow_s = speed_m_s[tick % 4u] > 4.0f * LENGTH_M ? s : trial.slow_s;
        /* The distance is measured after 12 ticks (100 ms). */
        if (tick == 12u) {
            const vec3 way = v3_sub(fish.position_m, at_m);
            trial.way_lengths = v3_length(way) / LENGTH_M;
            trial.away_lengths = v3_dot(way, away) / LENGTH_M;
        }
    }
    return trial;
}

/* Startles one fish in the middle of the tank from a random direction. */
static struct trial trial_of(uint32_t i)
{
    const float around_rad = rng_range((struct rng_key){ 5, i, 0, RNG_TEST }, -F_PI, F_PI);
    const vec3 from_m = { 0.06f * f_sin(around_rad), -0.06f, 0.06f * f_cos(around_rad) };
    return start(still_fish(i), from_m, i, CORE_TICK_HZ);
}

static void test_three_of_four_starts_turn_and_move_away_from_the_stimulus(void **state)
{
    (void)state;
    uint32_t turned = 0, led = 0;
    for (uint32_t i = 0; i < TRIALS; i++) {
        const struct trial trial = trial_of(i);
        turned += trial.head_turn_rad * trial.away_side > 0.0f;
        led += trial.away_lengths > 0.0f;
    }
    print_message("turned away %.3f, led away %.3f\n", (double)turned / TRIALS,
                  (double)led / TRIALS);
    /* By measurements of Mirjany et al. 2011, 77 % of the fish turn away from the stimulus. */
    assert_float_equal((float)turned / TRIALS, 0.77f, 0.02f);
    assert_true((float)led / TRIALS > 0.70f && (float)led / TRIALS < 0.90f);
}

static void test_stage_1_turns_the_head_60_to_120_degrees_within_17_ms(void **state)
{
    (void)state;
    float least = 1e3f, most = 0.0f, mean = 0.0f, latest_s = 0.0f;
    for (uint32_t i = 0; i < TRIALS; i++) {
        const struct trial trial = trial_of(i);
        const float turn = f_abs(trial.head_turn_rad) / F_DEG;
        least = f_min(least, turn);
        most = f_max(most, turn);
        mean += turn / (float)TRIALS;
        latest_s = f_max(latest_s, trial.stage_s);
    }
    print_message("stage 1 turns the head %.0f degrees (%.0f .. %.0f), done after %.1f ms\n",
                  (double)mean, (double)least, (double)most, (double)(1e3f * latest_s));
    assert_true(least > 59.5f && most < 120.5f);
    assert_float_equal(mean, 90.0f, 1.5f);
    /* Two ticks are 17 ms. By measurements of Eaton et al. 1977, stage 1 lasts about 20 ms. */
    assert_float_equal(latest_s, 2.0f * CORE_TICK_S, 1e-4f);
}

static void test_a_start_bends_into_a_c_and_then_beyond_straight(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < TRIALS; i++) {
        const struct trial trial = trial_of(i);
        assert_true(trial.bend_rad > 60.0f * F_DEG && trial.bend_rad < 160.0f * F_DEG);
        assert_true(trial.back_rad > 0.2f * trial.bend_rad);
    }
}

static void test_a_start_moves_the_fish_0_5_to_1_5_lengths_in_100_ms(void **state)
{
    (void)state;
    float least = 10.0f, most = 0.0f, mean = 0.0f;
    for (uint32_t i = 0; i < TRIALS; i++) {
        const struct trial trial = trial_of(i);
        least = f_min(least, trial.way_lengths);
        most = f_max(most, trial.way_lengths);
        mean += trial.way_lengths / (float)TRIALS;
    }
    print_message("after 100 ms %.2f lengths (%.2f .. %.2f)\n", (double)mean, (double)least,
                  (double)most);
    /* By measurements of Eaton et al. 1977, a fish moves by 0.5 to 1.5 body lengths in 100 ms. */
    assert_true(least >= 0.45f && most <= 1.5f);
    assert_float_equal(mean, 0.70f, 0.05f);
}

static void test_a_start_reaches_8_to_10_lengths_a_second_at_15_to_40_m_s2(void **state)
{
    (void)state;
    float least = 100.0f, most = 0.0f, weakest = 100.0f, strongest = 0.0f, latest_s = 0.0f;
    for (uint32_t i = 0; i < TRIALS; i++) {
        const struct trial trial = trial_of(i);
        least = f_min(least, trial.peak_lengths_s);
        most = f_max(most, trial.peak_lengths_s);
        weakest = f_min(weakest, trial.push_m_s2);
        strongest = f_max(strongest, trial.push_m_s2);
        latest_s = f_max(latest_s, trial.slow_s);
    }
    print_message("peak %.2f .. %.2f lengths/s, %.1f .. %.1f m/s2, above 4 for %.2f s\n",
                  (double)least, (double)most, (double)weakest, (double)strongest,
                  (double)latest_s);
    assert_true(least > 7.8f && most < 10.1f);
    assert_true(weakest > 15.0f && strongest < 40.0f);
    /* After one second, no fish may be faster than 4 body lengths per second. */
    assert_true(latest_s < 1.0f);
}

static void test_an_exhausted_fish_escapes_at_four_fifths_of_the_speed(void **state)
{
    (void)state;
    struct fish tired = still_fish(3);
    tired.stamina = 0.0f;
    const vec3 from_m = { 0.05f, -0.06f, 0.0f };
    const float fresh = start(still_fish(3), from_m, 3, CORE_TICK_HZ).peak_lengths_s;
    assert_float_equal(start(tired, from_m, 3, CORE_TICK_HZ).peak_lengths_s, 0.8f * fresh,
                       0.02f * fresh);
}

static void test_a_wall_behind_a_fish_gives_more_starts_toward_the_danger(void **state)
{
    (void)state;
    uint32_t away = 0;
    float into = 0.0f;
    for (uint32_t i = 0; i < TRIALS; i++) {
        struct fish fish = still_fish(i);
        /* Places the fish 3 cm from the right wall (x = 0.425 m). The stimulus comes from the
         * left. */
        fish.position_m.x = 0.425f - 0.03f;
        fish.angles.yaw_rad = fish.heading_rad = i % 2u ? 0.0f : F_PI;
        const vec3 from_m = { fish.position_m.x - 0.06f, -0.06f, 0.0f };
        const struct trial trial = start(fish, from_m, i, 12);
        away += trial.head_turn_rad * trial.away_side > 0.0f;
        into = f_max(into, trial.away_lengths);
    }
    print_message("turned away at a wall: %.3f, into it by %.2f lengths\n", (double)away / TRIALS,
                  (double)into);
    /* The wall is 0.6 body lengths (3 cm) away, and no fish may reach it within 100 ms. */
    assert_true(into < 0.6f);
    assert_true((float)away / TRIALS < 0.62f && (float)away / TRIALS > 0.45f);
}

static void test_an_escape_ends_within_a_second_costs_stamina_and_becomes_a_swim(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 200; i++) {
        struct fish fish = still_fish(i);
        uint32_t ticks = 0;
        escape_start(&fish, v3(0.05f, 0.0f, 0.0f), i, pond_at(11, 0));
        while (fish.gait == GAIT_ESCAPE) {
            ticks++;
            tick_alone(&fish, i, pond_at(11, ticks));
        }
        assert_in_range(ticks, CORE_TICK_HZ / 2u, CORE_TICK_HZ);
        assert_int_equal(fish.gait, GAIT_SWIM);
        assert_true(fish.stamina > 0.96f && fish.stamina < 0.98f);
        assert_true(fish.refractory_s > 0.3f);
    }
}

static void test_larger_fish_bend_slower(void **state)
{
    (void)state;
    assert_float_equal(escape_stage_s(0.033f), 2.0f * CORE_TICK_S, 1e-6f);
    assert_float_equal(escape_stage_s(0.05f), 2.0f * CORE_TICK_S, 1e-6f);
    assert_float_equal(escape_stage_s(0.08f), 3.0f * CORE_TICK_S, 1e-6f);
}

static void test_a_fish_that_falls_in_escapes_along_its_nose(void **state)
{
    (void)state;
    struct fish fish = still_fish(1);
    fish.angles.yaw_rad = 1.0f;
    escape_dash(&fish, 0, pond_at(1, 0));
    assert_int_equal(escape_stage(&fish), ESCAPE_DASH);
    for (uint32_t tick = 0; tick < 30; tick++) {
        tick_alone(&fish, 0, pond_at(1, tick));
        assert_float_equal(fish.angles.yaw_rad, 1.0f, 0.01f);
        assert_float_equal(fish.bend_rad, 0.0f, 0.01f);
    }
}

static void test_a_fish_scooped_during_its_start_straightens(void **state)
{
    (void)state;
    struct fish fish = still_fish(1);
    escape_start(&fish, v3(0.05f, 0.0f, 0.0f), 0, pond_at(1, 0));
    tick_alone(&fish, 0, pond_at(1, 0));
    tick_alone(&fish, 0, pond_at(1, 1));
    assert_true(f_abs(fish.bend_rad) > 1.0f);
    /* Sets the gait that a fish has when it falls off the paper in the middle of its bend. */
    fish.gait = GAIT_BURST;
    fish.gait_left_s = 1.0f;
    fish.heading_rad = fish.angles.yaw_rad;
    fish.yaw_rate_rad_s = 0.0f;
    for (uint32_t tick = 2; tick < 80; tick++) {
        tick_alone(&fish, 0, pond_at(1, tick));
    }
    assert_float_equal(fish.bend_rad, 0.0f, 0.05f);
}

static void test_a_shade_does_not_turn_an_escape_start(void **state)
{
    (void)state;
    struct fish fish = still_fish(1), drawn = fish;
    drawn.drawn_rad = 1.0f;
    escape_start(&fish, v3(0.05f, 0.0f, 0.0f), 0, pond_at(1, 0));
    escape_start(&drawn, v3(0.05f, 0.0f, 0.0f), 0, pond_at(1, 0));
    for (uint32_t tick = 0; tick < 12; tick++) {
        tick_alone(&fish, 0, pond_at(1, tick));
        tick_alone(&drawn, 0, pond_at(1, tick));
    }
    assert_float_equal(drawn.angles.yaw_rad, fish.angles.yaw_rad, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_three_of_four_starts_turn_and_move_away_from_the_stimulus),
        cmocka_unit_test(test_stage_1_turns_the_head_60_to_120_degrees_within_17_ms),
        cmocka_unit_test(test_a_start_bends_into_a_c_and_then_beyond_straight),
        cmocka_unit_test(test_a_start_moves_the_fish_0_5_to_1_5_lengths_in_100_ms),
        cmocka_unit_test(test_a_start_reaches_8_to_10_lengths_a_second_at_15_to_40_m_s2),
        cmocka_unit_test(test_an_exhausted_fish_escapes_at_four_fifths_of_the_speed),
        cmocka_unit_test(test_a_wall_behind_a_fish_gives_more_starts_toward_the_danger),
        cmocka_unit_test(test_an_escape_ends_within_a_second_costs_stamina_and_becomes_a_swim),
        cmocka_unit_test(test_larger_fish_bend_slower),
        cmocka_unit_test(test_a_fish_that_falls_in_escapes_along_its_nose),
        cmocka_unit_test(test_a_fish_scooped_during_its_start_straightens),
        cmocka_unit_test(test_a_shade_does_not_turn_an_escape_start),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
