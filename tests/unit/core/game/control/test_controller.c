/* test_controller.c -- checks which source (a controller or a bot) moves a poi, and how the poi's
 * position and speed are limited. */
#include "core/game/control/controller.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"

static void test_the_clock_pauses_while_the_poi_is_lost(void **state)
{
    (void)state;
    play_into_round();
    steps(100);
    const float before_s = game_seconds_left(&core.game, core.game.tick);
    input.poi[0].link = POI_SOURCE_LOST;
    steps(1000);
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), before_s, 0.001f);
    assert_int_equal(core.game.hints.shown, HINT_LOST_POI);
    hold_at(ABOVE_M);
    steps(INPUT_AGREE_TICKS - 1u);
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), before_s, 0.001f);
    steps(120);
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), before_s - 1.0f, 0.001f);
}

static void test_a_round_ends_when_the_controller_stays_lost(void **state)
{
    (void)state;
    play_into_round();
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_a_new_controller_moves_the_poi_without_a_jump(void **state)
{
    (void)state;
    /* A bot moves the poi during these ticks, because no player is present. */
    steps(200);
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.20f, 0.08f, 0.10f);
    press(INPUT_START);
    vec3 last = core.game.control[0].target_pose.position_m;
    for (uint32_t i = 0; i < 160; i++) {
        step();
        const vec3 now = core.game.control[0].target_pose.position_m;
        /* The speed limit is 1.4 m/s, which is 12 mm per tick. */
        assert_true(v3_length(v3_sub(now, last)) < 0.012f);
        last = now;
    }
    /* The poi has reached the player's position, and now follows the controller without delay. */
    assert_float_equal(last.x, 0.20f, 0.0f);
    assert_float_equal(last.z, 0.10f, 0.0f);
}

static void test_no_poi_enters_the_water_before_the_round(void **state)
{
    (void)state;
    dip();
    for (uint32_t i = 0; i < GAME_READY_TICKS - 1u; i++) {
        step();
        assert_true(core.game.control[0].target_pose.position_m.y > 0.0f || i < 60u);
    }
    step();
    float last_m = core.game.control[0].target_pose.position_m.y;
    /* In each tick, the poi's target must sink by less than 4 mm. */
    for (uint32_t i = 0; i < 150u; i++) {
        step();
        assert_true(last_m - core.game.control[0].target_pose.position_m.y < 0.004f);
        last_m = core.game.control[0].target_pose.position_m.y;
    }
    assert_float_equal(last_m, BELOW_M, 0.0f);
}

static void test_a_pose_beyond_the_reach_is_limited(void **state)
{
    (void)state;
    play_into_round();
    input.poi[0].target.position_m = v3(90.0f, -90.0f, -90.0f);
    steps(400);
    const vec3 hand = core.game.control[0].target_pose.position_m;
    assert_true(hand.x < core.world.tank.size_m.x);
    assert_float_equal(hand.y, -core.world.tank.size_m.y, 0.0f);
    assert_true(hand.z > -core.world.tank.size_m.z);
}

static void test_any_pose_is_limited_to_the_reach(void **state)
{
    (void)state;
    static const float wild[] = { 1e9f, -3e38f, 1.0f / 0.0f, 99.0f, -100.0f, 101.0f, 999.0f, 0.0f };
    play_into_round();
    for (size_t i = 0; i < sizeof wild / sizeof wild[0]; i++) {
        input.poi[0].target.position_m = v3(wild[i], wild[(i + 1) % 8], wild[(i + 2) % 8]);
        input.poi[0].target.angles = (struct angles){ wild[i], wild[(i + 3) % 8], -wild[i] };
        /* Within 400 ticks, the poi reaches its limited target. */
        for (uint32_t tick = 0; tick < 400; tick++) {
            core_tick(&core, &input, &output);
        }
        const struct angles hand = core.game.control[0].target_pose.angles;
        assert_true(f_abs(hand.yaw_rad) < 3.15f);
        assert_true(f_abs(hand.pitch_rad) < 3.15f);
        assert_true(f_abs(hand.roll_rad) < 3.15f);
        assert_true(v3_is_finite(core.world.poi[0].position_m));
    }
    input.poi[0].target = (struct poi_target){ .angles = { -F_TAU, F_TAU + 0.5f, 0.0f } };
    steps(400);
    assert_float_equal(core.game.control[0].target_pose.angles.yaw_rad, 0.0f, 1e-5f);
    assert_float_equal(core.game.control[0].target_pose.angles.pitch_rad, 0.5f, 1e-5f);
}

static void test_a_pose_turns_the_short_way_round(void **state)
{
    (void)state;
    input.poi[0].target.angles.yaw_rad = -3.1f;
    play_into_round();
    core.game.control[0].target_pose.angles.yaw_rad = 3.1f;
    core.game.control[0].grip_tick = core.game.tick;
    for (uint32_t i = 0; i < 160; i++) {
        step();
        assert_true(f_abs(core.game.control[0].target_pose.angles.yaw_rad) > 3.0f);
    }
    assert_float_equal(core.game.control[0].target_pose.angles.yaw_rad, -3.1f, 1e-5f);
}

static void test_only_a_poi_with_a_bowl_is_present(void **state)
{
    (void)state;
    static struct scene scene;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        input.poi[i].link = POI_SOURCE_LIVE;
        input.poi[i].target.position_m = v3(0.0f, 0.06f, 0.0f);
    }
    press(INPUT_START);
    core_scene(&core, &scene);
    assert_true(scene.poi[0].present);
    for (uint32_t i = 1; i < POI_MAX; i++) {
        assert_false(scene.poi[i].present);
    }
}

static void test_torn_paper_stays_visible_after_the_controller_is_removed(void **state)
{
    (void)state;
    play_into_round();
    tear_all(0);
    steps(GAME_GONE_TICKS / 2u);
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_GONE_TICKS / 2u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    steps(2);
    /* The player is out of the round, so the game does not pause to wait for the controller. */
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_a_nan_pose_is_a_lost_controller(void **state)
{
    (void)state;
    play_into_round();
    const float before_s = game_seconds_left(&core.game, core.game.tick);
    input.poi[0].target.position_m.x = 1.0f / 0.0f;
    steps(100);
    assert_true(controller_is_lost(&core.world, 0));
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), before_s, 0.001f);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_the_clock_pauses_while_the_poi_is_lost),
        TEST(test_a_round_ends_when_the_controller_stays_lost),
        TEST(test_a_new_controller_moves_the_poi_without_a_jump),
        TEST(test_no_poi_enters_the_water_before_the_round),
        TEST(test_a_pose_beyond_the_reach_is_limited),
        TEST(test_any_pose_is_limited_to_the_reach),
        TEST(test_a_pose_turns_the_short_way_round),
        TEST(test_only_a_poi_with_a_bowl_is_present),
        TEST(test_torn_paper_stays_visible_after_the_controller_is_removed),
        TEST(test_a_nan_pose_is_a_lost_controller),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
