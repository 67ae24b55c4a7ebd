/* test_temper.c -- checks the operator's setting for calmer fish. A calm fish flees only from a
 * stronger stimulus. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/tank.h"
#include "tests/unit/support/open_tank.h"
#include "tests/unit/support/pond.h"

/* Length in metres above which a fish is never calm. */
#define LONG_M 0.06f

static void test_a_calm_fish_needs_a_stronger_stimulus(void **state)
{
    (void)state;
    struct perception around = *pond_at(1, 0);
    struct fish usual = pond_fish(LONG_M, GAIT_SWIM), calmer = usual;
    startle_alarm(&usual, STARTLE_PRESSURE, v3(0.0f, 0.0f, 0.0f), 0.5f, 0, &around);
    around.temper.threshold_gain = 1.0f;
    startle_alarm(&calmer, STARTLE_PRESSURE, v3(0.0f, 0.0f, 0.0f), 0.5f, 0, &around);
    assert_float_equal(calmer.alarm, 0.5f * usual.alarm, 1e-6f);
    assert_int_equal(usual.startle, STARTLE_PRESSURE);
    assert_int_equal(calmer.startle, STARTLE_NONE);
}

static void test_a_longer_latency_delays_the_escape(void **state)
{
    (void)state;
    struct perception around = *pond_at(1, 0);
    struct fish usual = pond_fish(LONG_M, GAIT_SWIM), calmer = usual;
    startle_alarm(&usual, STARTLE_LOOM, v3(0.0f, 0.0f, 0.0f), 1.0f, 0, &around);
    around.temper.latency_gain = 1.5f;
    startle_alarm(&calmer, STARTLE_LOOM, v3(0.0f, 0.0f, 0.0f), 1.0f, 0, &around);
    assert_float_equal(calmer.startle_s, 2.5f * usual.startle_s, 1e-6f);
}

static void test_a_shorter_reach_hides_a_distant_disc(void **state)
{
    (void)state;
    const struct obstacle disc = { .kind = OBSTACLE_DISC,
                                   .centre_m = { 0.2f, -0.06f, 0.0f },
                                   .normal = { 1.0f, 0.0f, 0.0f },
                                   .velocity_m_s = { -0.5f, 0.0f, 0.0f },
                                   .radius_m = 0.0465f };
    struct perception around = *pond_at(1, 0);
    const struct fish fish = pond_fish(LONG_M, GAIT_SWIM);
    around.obstacles = &disc;
    around.obstacle_count = 1;
    assert_true(startle_alert(&fish, &around));
    around.temper.reach_loss = 0.5f;
    assert_false(startle_alert(&fish, &around));
}

static void test_the_share_of_calm_fish_is_that_of_the_temper(void **state)
{
    (void)state;
    static struct tank tank;
    /* All fish of this tank are shorter than 4.5 cm, so none of them is too long to be calm. */
    open_tank(&tank, TANK_PRESET_OFFICIAL, 1000, 5);
    for (uint32_t percent = 0; percent <= 100; percent += 25) {
        const struct temper temper = { .calm_share = 0.01f * (float)percent };
        uint32_t count = 0;
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            count += fish_is_calm(&tank.fish[i], &temper);
        }
        assert_in_range(count + 40u, 10u * percent, 10u * percent + 80u);
    }
    const struct fish large = pond_fish(LONG_M, GAIT_SWIM);
    assert_false(fish_is_calm(&large, &(struct temper){ .calm_share = 1.0f }));
}

static void test_a_calm_fish_prefers_to_swim_below_the_surface(void **state)
{
    (void)state;
    struct perception around = *pond_at(1, 0);
    struct fish usual = pond_fish(0.04f, GAIT_SWIM), calm = usual;
    gait_enter(&usual, GAIT_SWIM, 0, &around);
    around.temper.calm_share = 1.0f;
    gait_enter(&calm, GAIT_SWIM, 0, &around);
    assert_true(calm.depth_goal_m > -0.035f && calm.depth_goal_m < -0.02f);
    assert_true(usual.depth_goal_m < -0.06f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_calm_fish_needs_a_stronger_stimulus),
        cmocka_unit_test(test_a_longer_latency_delays_the_escape),
        cmocka_unit_test(test_a_shorter_reach_hides_a_distant_disc),
        cmocka_unit_test(test_the_share_of_calm_fish_is_that_of_the_temper),
        cmocka_unit_test(test_a_calm_fish_prefers_to_swim_below_the_surface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
