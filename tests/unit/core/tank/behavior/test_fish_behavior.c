/* test_fish_behavior.c -- checks in which ticks a fish updates its behavior. Each update must cover
 * the time since the update before. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/swim.h"
#include "core/tank/collision/obstacle.h"
#include "tests/unit/support/pond.h"

static struct fish calm(void)
{
    struct fish fish = { .position_m = { 0.0f, -0.06f, 0.0f },
                         .stamina = 0.8f,
                         .brake = 1.0f,
                         .room = 1.0f,
                         .gait_left_s = 1e6f,
                         .depth_goal_m = -0.06f };
    fish_grow(&fish, 0.05f, pond_params());
    return fish;
}

/* Returns a poi that moves at 40 cm/s. Its distance from the fish is `beside_m`. */
static struct obstacle rushing(float beside_m)
{
    return (struct obstacle){ .kind = OBSTACLE_DISC,
                              .centre_m = { beside_m, -0.06f, 0.0f },
                              .normal = { 0.0f, 1.0f, 0.0f },
                              .velocity_m_s = { 0.0f, 0.0f, 0.4f },
                              .radius_m = 0.0465f };
}

/* Returns the number of updates of a fish in `ticks` ticks. Writes the total time that the updates
 * cover to `covered_s`. */
static uint32_t count_updates(struct fish *fish, uint32_t index, uint32_t ticks,
                              const struct obstacle *poi, float *covered_s)
{
    uint32_t count = 0;
    *covered_s = 0.0f;
    for (uint32_t tick = 0; tick < ticks; tick++) {
        struct perception around = *pond_at(1, tick);
        around.obstacles = poi;
        around.obstacle_count = poi ? 1u : 0u;
        if (fish_behavior_is_due(fish, index, &around)) {
            around.dt_s = fish_behavior_dt_s(fish, tick);
            *covered_s += around.dt_s;
            fish->thought_tick = (uint8_t)tick;
            count++;
        }
    }
    return count;
}

static void test_a_calm_fish_updates_in_every_fourth_tick_by_its_index(void **state)
{
    (void)state;
    for (uint32_t tick = 0; tick < 8; tick++) {
        uint32_t thinking = 0;
        for (uint32_t index = 0; index < 100; index++) {
            const struct fish fish = calm();
            thinking += (uint32_t)fish_behavior_is_due(&fish, index, pond_at(1, tick));
        }
        assert_int_equal(thinking, 25);
    }
}

static void test_behavior_updates_cover_the_whole_time(void **state)
{
    (void)state;
    for (uint32_t index = 0; index < 4; index++) {
        struct fish fish = calm();
        float covered_s = 0.0f;
        assert_int_equal(count_updates(&fish, index, 1200, NULL, &covered_s), 300);
        /* The tolerance allows for an update that is up to four ticks after the 10 s. */
        assert_float_equal(covered_s, 10.0f, 4.5f * CORE_TICK_S);
    }
}

static void test_a_fish_beside_a_fast_poi_updates_in_every_tick(void **state)
{
    (void)state;
    const struct obstacle near = rushing(0.08f), far = rushing(0.30f);
    struct fish fish = calm();
    float covered_s = 0.0f;
    assert_int_equal(count_updates(&fish, 1, 120, &near, &covered_s), 120);
    assert_float_equal(covered_s, 1.0f, 0.01f);
    assert_int_equal(count_updates(&fish, 1, 120, &far, &covered_s), 30);
}

static void test_a_fleeing_falling_or_gulping_fish_updates_in_every_tick(void **state)
{
    (void)state;
    float covered_s = 0.0f;
    struct fish fish = calm();
    fish.gait = GAIT_ESCAPE;
    assert_int_equal(count_updates(&fish, 2, 40, NULL, &covered_s), 40);
    fish = calm();
    fish.falls = 1;
    assert_int_equal(count_updates(&fish, 2, 40, NULL, &covered_s), 40);
    fish = calm();
    /* The fish is 1 cm wide, and its centre is only 4 mm below the surface. It therefore touches
     * the surface, and must be updated in every tick. */
    fish.position_m.y = -0.004f;
    assert_int_equal(count_updates(&fish, 2, 40, NULL, &covered_s), 40);
}

static void test_a_released_fish_does_not_repeat_skipped_updates(void **state)
{
    (void)state;
    struct fish fish = calm();
    fish.thought_tick = 10;
    assert_float_equal(fish_behavior_dt_s(&fish, 11), CORE_TICK_S, 1e-9f);
    assert_float_equal(fish_behavior_dt_s(&fish, 13), 3.0f * CORE_TICK_S, 1e-9f);
    for (uint32_t tick = 14; tick < 1000; tick++) {
        assert_true(fish_behavior_dt_s(&fish, tick) >= CORE_TICK_S);
        assert_true(fish_behavior_dt_s(&fish, tick) <=
                    (float)FISH_BEHAVIOR_TICKS * CORE_TICK_S + 1e-9f);
    }
}

/* The stamina, the random turns and the depth of a fish must not depend on the rate of the
 * updates. */
static void test_behavior_is_the_same_at_30_and_120_updates_a_second(void **state)
{
    (void)state;
    struct fish often = calm(), seldom = calm();
    often.gait = seldom.gait = GAIT_SWIM;
    often.depth_goal_m = seldom.depth_goal_m = -0.04f;
    for (uint32_t tick = 0; tick < 5u * CORE_TICK_HZ; tick++) {
        struct perception around = *pond_at(3, tick);
        /* Makes the tank so large (20 m) that no wall influences the fish. */
        around.size_m = v3(20.0f, 0.12f, 20.0f);
        fish_behavior_tick(&often, 0, &around);
        if (tick % FISH_BEHAVIOR_TICKS == 0) {
            around.dt_s = fish_behavior_dt_s(&seldom, tick);
            fish_behavior_tick(&seldom, 0, &around);
        }
        swim_move(&often, around.params);
        swim_move(&seldom, around.params);
    }
    assert_float_equal(seldom.stamina, often.stamina, 1e-4f);
    assert_float_equal(seldom.position_m.y, often.position_m.y, 0.001f);
    assert_true(f_abs(f_wrap_angle(seldom.angles.yaw_rad - often.angles.yaw_rad)) < 0.05f);
    assert_true(v3_length(v3_sub(seldom.position_m, often.position_m)) < 0.01f);
}

/* Between two updates the fish must move smoothly, so the yaw rate may change only a little in each
 * tick. The test uses the thesis' preset, because fish of the other presets turn abruptly with each
 * kick of the tail. */
static void test_the_path_between_updates_is_a_smooth_arc(void **state)
{
    (void)state;
    float roughest = 0.0f, fastest = 0.0f;
    struct fish fish = calm();
    fish.gait = GAIT_SWIM;
    for (uint32_t tick = 0; tick < 60u * CORE_TICK_HZ; tick++) {
        struct perception around = *pond_at(9, tick);
        around.params = &tank_preset(TANK_PRESET_THESIS)->params;
        around.size_m = v3(0.40f, 0.12f, 0.30f);
        const float rate = fish.yaw_rate_rad_s;
        if (fish_behavior_is_due(&fish, 0, &around)) {
            around.dt_s = fish_behavior_dt_s(&fish, tick);
            fish_behavior_tick(&fish, 0, &around);
        }
        swim_move(&fish, around.params);
        /* Keeps the fish between the walls, because swim_move() alone does not stop it. */
        fish.position_m.x = f_clamp(fish.position_m.x, -0.175f, 0.175f);
        fish.position_m.z = f_clamp(fish.position_m.z, -0.125f, 0.125f);
        roughest = f_max(roughest, f_abs(fish.yaw_rate_rad_s - rate));
        fastest = f_max(fastest, f_abs(fish.yaw_rate_rad_s));
    }
    print_message("turns by %.1f rad/s at most, and changes that by %.2f a tick\n", (double)fastest,
                  (double)roughest);
    assert_true(fastest > 0.5f && roughest < 0.25f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_calm_fish_updates_in_every_fourth_tick_by_its_index),
        cmocka_unit_test(test_behavior_updates_cover_the_whole_time),
        cmocka_unit_test(test_a_fish_beside_a_fast_poi_updates_in_every_tick),
        cmocka_unit_test(test_a_fleeing_falling_or_gulping_fish_updates_in_every_tick),
        cmocka_unit_test(test_a_released_fish_does_not_repeat_skipped_updates),
        cmocka_unit_test(test_behavior_is_the_same_at_30_and_120_updates_a_second),
        cmocka_unit_test(test_the_path_between_updates_is_a_smooth_arc),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
