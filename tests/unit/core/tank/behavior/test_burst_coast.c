/* test_burst_coast.c -- checks burst-and-coast swimming, in which a kick of the tail accelerates
 * and turns the fish, and drag slows the glide that follows. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/swim.h"
#include "tests/unit/support/pond.h"

static void swim(struct fish *fish, uint32_t tick)
{
    const vec3 before_m = fish->position_m;
    if (tick % FISH_BEHAVIOR_TICKS == 0) {
        swim_resolve(fish, pond_at(1, tick));
    }
    swim_move(fish, pond_params());
    swim_settle(fish, v3_sub(fish->position_m, before_m), fish_forward(fish));
}

/* Returns the first tick of a glide. Requires a fish whose `look` (the random bits of its
 * individual traits) is 0. For such a fish, a cycle of tail beats and one glide lasts 84 ticks. */
static uint32_t glide_tick(const struct fish *fish)
{
    uint32_t tick = 0;
    while (gait_cycle_beats(fish, tick)) {
        tick++;
    }
    return tick;
}

static void test_a_glide_decelerates_by_drag(void **state)
{
    (void)state;
    for (float length_m = 0.033f; length_m < 0.085f; length_m += 0.0155f) {
        struct fish fish = pond_fish(length_m, GAIT_SWIM);
        const uint32_t from = glide_tick(&fish);
        const float start_m_s = 1.3f * length_m, way_m = gait_glide_m(length_m);
        fish.speed_m_s = start_m_s;
        for (uint32_t tick = from; tick < 84u; tick++) {
            swim(&fish, tick);
            const float s = (float)(tick + 1u - from) * CORE_TICK_S;
            /* Speed that is expected with quadratic drag, which is the solution of dv/dt = -v^2 /
             * way_m. */
            const float wanted_m_s = start_m_s / (1.0f + start_m_s * s / way_m);
            assert_float_equal(fish.speed_m_s, wanted_m_s, 0.01f * start_m_s);
        }
        /* The glide distance must also follow from mass and drag: 2 m (1 + added mass) / (rho S C).
         * The mass m is that of fish_mass_kg(), which is also used for the oxygen consumption. */
        const float by_mass_m =
            2.0f * 1.1f * fish_mass_kg(length_m) / (1000.0f * 0.65f * length_m * length_m * 0.060f);
        assert_float_equal(way_m, by_mass_m, 0.04f * way_m);
    }
}

static void test_a_kick_turns_the_course_once_and_a_glide_never(void **state)
{
    (void)state;
    float sum2 = 0.0f;
    const uint32_t cycles = 4000;
    struct fish fish = pond_fish(0.05f, GAIT_SWIM);
    uint32_t turns = 0;
    for (uint32_t tick = 0; tick < cycles * 84u; tick += FISH_BEHAVIOR_TICKS) {
        struct perception around = *pond_at(1, tick);
        const float before_rad = fish.heading_rad;
        around.dt_s = (float)FISH_BEHAVIOR_TICKS * CORE_TICK_S;
        gait_cycle_turn(&fish, 7, &around);
        const float turn_rad = f_wrap_angle(fish.heading_rad - before_rad);
        assert_true(turn_rad == 0.0f || gait_cycle_beats(&fish, tick));
        turns += turn_rad != 0.0f;
        sum2 += turn_rad * turn_rad;
    }
    assert_int_equal(turns, cycles);
    assert_float_equal(f_sqrt(sum2 / (float)cycles), pond_params()->kick_rad, 0.02f);
}

static void test_a_behavior_update_in_every_tick_adds_no_turns(void **state)
{
    (void)state;
    struct fish often = pond_fish(0.05f, GAIT_SWIM), seldom = often;
    for (uint32_t tick = 0; tick < 840u; tick++) {
        struct perception around = *pond_at(1, tick);
        gait_cycle_turn(&often, 7, &around);
        /* Updates the fish `seldom` only in every fourth tick, which is never the tick in which a
         * kick (a tail beat that turns the fish) begins. The fish must not miss a kick in spite of
         * this. */
        if (tick % FISH_BEHAVIOR_TICKS == 2u) {
            around.dt_s = (float)FISH_BEHAVIOR_TICKS * CORE_TICK_S;
            gait_cycle_turn(&seldom, 7, &around);
        }
    }
    assert_float_equal(often.heading_rad, seldom.heading_rad, 1e-6f);
}

/* Measures one turn by `angle_rad`. Writes the duration of the middle 80 % of the turn, and the
 * smallest radius of the path in body lengths. */
static void turn(float angle_rad, float *lasts_s, float *radius_lengths)
{
    struct fish fish = pond_fish(0.05f, GAIT_SWIM);
    float first_s = 0.0f;
    fish.heading_rad = angle_rad;
    /* A fish has 0.9 body lengths per second at the end of a glide. */
    fish.speed_m_s = 0.9f * fish.length_m;
    *lasts_s = 0.0f;
    *radius_lengths = 100.0f;
    for (uint32_t tick = 0; tick < 84u; tick++) {
        swim(&fish, tick);
        const float s = (float)(tick + 1u) * CORE_TICK_S;
        first_s = fish.angles.yaw_rad < 0.1f * angle_rad ? s : first_s;
        *lasts_s = fish.angles.yaw_rad < 0.9f * angle_rad ? s - first_s : *lasts_s;
        const float radius_m = fish.speed_m_s / f_max(fish.yaw_rate_rad_s, 1e-3f);
        *radius_lengths = f_min(*radius_lengths, radius_m / fish.length_m);
    }
}

/* By measurements of Wu et al. 2007, the duration of a turn hardly depends on its angle, because
 * larger turns are faster. In a turn of 25 degrees or more, the smallest radius of the path must be
 * 0.1 to 0.2 body lengths. */
static void test_the_duration_of_a_turn_is_independent_of_its_angle(void **state)
{
    (void)state;
    float least_s = 1.0f, most_s = 0.0f;
    for (float degrees = 15.0f; degrees <= 60.0f; degrees += 5.0f) {
        float lasts_s = 0.0f, radius = 0.0f;
        turn(degrees * F_DEG, &lasts_s, &radius);
        print_message("%2.0f degrees in %.0f ms, radius %.2f lengths\n", (double)degrees,
                      (double)(1e3f * lasts_s), (double)radius);
        least_s = f_min(least_s, lasts_s);
        most_s = f_max(most_s, lasts_s);
        assert_true(degrees < 25.0f || (radius > 0.1f && radius < 0.2f));
    }
    assert_true(least_s > 0.08f && most_s < 0.17f && most_s < 1.4f * least_s);
}

static void test_parameters_without_kicks_turn_and_beat_evenly(void **state)
{
    (void)state;
    struct fish fish = pond_fish(0.05f, GAIT_SWIM);
    for (uint32_t tick = 0; tick < 840u; tick++) {
        struct perception around = *pond_at(1, tick);
        around.params = &tank_preset(TANK_PRESET_THESIS)->params;
        gait_cycle_turn(&fish, 7, &around);
        swim_resolve(&fish, &around);
        assert_true(fish.beats > 0.0f && fish.haste == 1.0f);
    }
    assert_float_equal(fish.heading_rad, 0.0f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_glide_decelerates_by_drag),
        cmocka_unit_test(test_a_kick_turns_the_course_once_and_a_glide_never),
        cmocka_unit_test(test_a_behavior_update_in_every_tick_adds_no_turns),
        cmocka_unit_test(test_the_duration_of_a_turn_is_independent_of_its_angle),
        cmocka_unit_test(test_parameters_without_kicks_turn_and_beat_evenly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
