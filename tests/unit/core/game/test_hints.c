/* test_hints.c -- checks which hint the game shows after each action of a player. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/core.h"
#include "core/game/phases.h"

static struct core core;

static int setup(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 2 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    core.game.phase = PHASE_ROUND;
    core.world.poi[0].link = POI_SOURCE_LIVE;
    core.world.poi[0].position_m = v3(0.0f, 0.06f, 0.0f);
    for (uint32_t i = 0; i < core.world.tank.fish_count; i++) {
        core.world.tank.fish[i].gait = GAIT_SWIM;
        core.world.tank.fish[i].position_m = v3(0.3f, -0.05f, 0.1f * (float)i);
    }
    core.game.tick = 5000;
    return 0;
}

/* Calls only hints_tick() and not the whole core, for `ticks` ticks. Returns the hint that is shown
 * afterwards. */
static uint8_t hint_after(uint32_t ticks)
{
    for (uint32_t i = 0; i < ticks; i++) {
        core.game.tick++;
        hints_tick(&core.game.hints, &core.game, &core.world, &core.config);
    }
    return core.game.hints.shown;
}

static void learn(uint32_t hint)
{
    core.game.hints.learned |= 1u << hint;
}

static void dip_poi(void)
{
    core.world.poi[0].immersed = 1.0f;
    core.world.poi[0].position_m.y = -0.07f;
}

static void put_fish_over_the_poi(void)
{
    core.world.tank.fish[0].position_m = v3(0.01f, -0.04f, -0.01f);
}

static void put_fish_on_the_poi(void)
{
    core.world.poi[0].immersed = 0.0f;
    core.world.tank.fish[0].gait = GAIT_HELD;
    core.world.tank.fish[0].holder = 0;
}

static void test_attract_shows_the_start_hint(void **state)
{
    (void)state;
    core.game.phase = PHASE_ATTRACT;
    assert_int_equal(hint_after(300), HINT_START);
}

static void test_the_result_shows_the_start_hint_when_a_dip_counts(void **state)
{
    (void)state;
    core.game.phase = PHASE_RESULT;
    core.game.phase_tick = core.game.tick;
    assert_int_equal(hint_after(GAME_AGAIN_DIP_TICKS - 1u), HINT_NONE);
    assert_int_equal(hint_after(20), HINT_START);
}

static void test_a_resting_poi_gets_the_move_hint(void **state)
{
    (void)state;
    assert_int_equal(hint_after(300), HINT_MOVE);
}

static void test_the_move_hint_is_also_shown_before_the_round(void **state)
{
    (void)state;
    core.game.phase = PHASE_READY;
    assert_int_equal(hint_after(300), HINT_MOVE);
    learn(HINT_MOVE);
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_a_moved_poi_gets_the_dip_hint(void **state)
{
    (void)state;
    hint_after(300);
    core.world.poi[0].velocity_m_s = v3(0.3f, 0.0f, 0.0f);
    /* In these 24 ticks at 0.3 m/s, the poi moves by 6 cm. This distance is too short to count as a
     * movement. */
    assert_int_equal(hint_after(24), HINT_MOVE);
    assert_int_equal(hint_after(120), HINT_DIP);
}

static void test_a_fish_over_the_dipped_poi_gives_the_lift_hint(void **state)
{
    (void)state;
    hint_after(300);
    dip_poi();
    /* The poi is dipped, but no fish is over it, so HINT_LIFT is not shown. */
    assert_int_equal(hint_after(200), HINT_NONE);
    put_fish_over_the_poi();
    assert_int_equal(hint_after(200), HINT_LIFT);
}

static void test_a_fish_under_the_dipped_poi_gives_no_lift_hint(void **state)
{
    (void)state;
    dip_poi();
    put_fish_over_the_poi();
    core.world.tank.fish[0].position_m.y = -0.09f;
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_a_fish_on_the_lifted_poi_gives_the_bowl_hint(void **state)
{
    (void)state;
    put_fish_on_the_poi();
    assert_int_equal(hint_after(300), HINT_BOWL);
    core.world.tank.fish[0].gait = GAIT_BOWL;
    core.game.player[0].caught = 1;
    learn(HINT_TILT);
    learn(HINT_MOVE);
    learn(HINT_DIP);
    /* The player has already done everything that the hints explain, so no hint is shown. */
    assert_int_equal(hint_after(300), HINT_NONE);
    put_fish_on_the_poi();
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_the_tilt_hint_stays_until_the_player_tilts(void **state)
{
    (void)state;
    learn(HINT_MOVE);
    learn(HINT_DIP);
    core.game.player[0].caught = 1;
    assert_int_equal(hint_after(300), HINT_TILT);
    core.game.control[0].target_pose.angles.pitch_rad = -0.3f;
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_a_completed_lift_ends_the_lift_hint(void **state)
{
    (void)state;
    hint_after(300);
    dip_poi();
    put_fish_over_the_poi();
    assert_int_equal(hint_after(200), HINT_LIFT);
    core.world.poi[0].immersed = 0.0f;
    assert_int_not_equal(hint_after(12), HINT_LIFT);
}

static void test_unsuccessful_dips_give_the_technique_hint(void **state)
{
    (void)state;
    learn(HINT_MOVE);
    learn(HINT_DIP);
    core.world.poi[0].dips = 1;
    assert_int_equal(hint_after(300), HINT_NONE);
    core.world.poi[0].dips = 2;
    assert_int_equal(hint_after(300), HINT_GLIDE);
    core.game.player[0].caught = 1;
    learn(HINT_TILT);
    assert_int_equal(hint_after(300), HINT_NONE);
    core.world.poi[0].dips = 4;
    assert_int_equal(hint_after(300), HINT_GLIDE);
}

static void test_a_fast_motion_that_tears_gives_the_slow_hint(void **state)
{
    (void)state;
    hint_after(300);
    core.world.poi[0].velocity_m_s = v3(0.0f, 0.6f, 0.0f);
    core.world.poi[0].sheet.paper_cells -= 12u;
    assert_int_equal(hint_after(13), HINT_SLOWLY);
}

static void test_a_tear_in_slow_motion_gives_no_slow_hint(void **state)
{
    (void)state;
    hint_after(300);
    core.world.poi[0].velocity_m_s = v3(0.0f, 0.1f, 0.0f);
    core.world.poi[0].sheet.paper_cells -= 12u;
    assert_int_not_equal(hint_after(200), HINT_SLOWLY);
}

static void test_a_hint_stays_for_one_and_a_half_seconds(void **state)
{
    (void)state;
    core.game.tick = 5000;
    while (core.game.hints.shown != HINT_MOVE) {
        hint_after(1);
    }
    const uint32_t since = core.game.tick;
    learn(HINT_MOVE);
    while (core.game.hints.shown == HINT_MOVE) {
        hint_after(1);
    }
    assert_in_range(core.game.tick - since, HINT_TICKS_MIN, HINT_TICKS_MIN + 12u);
}

static void test_an_urgent_hint_is_shown_immediately(void **state)
{
    (void)state;
    hint_after(300);
    learn(HINT_MOVE);
    /* HINT_DIP has just appeared. Most other hints would now wait for some time before they replace
     * it. HINT_LOST_POI must replace it at once. */
    hint_after(13);
    core.world.poi[0].link = POI_SOURCE_LOST;
    assert_int_equal(hint_after(13), HINT_LOST_POI);
    core.world.poi[0].link = POI_SOURCE_LIVE;
    core.game.player[0].out = 1;
    core.game.player[0].torn_tick = core.game.tick;
    assert_int_equal(hint_after(13), HINT_TORN);
}

static void test_a_bot_gets_no_hint(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    assert_int_equal(hint_after(500), HINT_NONE);
}

static void test_a_new_player_gets_the_hints_from_the_start(void **state)
{
    (void)state;
    learn(HINT_MOVE);
    core.game.hints = (struct hints){ 0 };
    assert_int_equal(hint_after(300), HINT_MOVE);
}

static void test_only_a_player_with_a_controller_gets_hints(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 2, .players = 2 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    core.game.phase = PHASE_ROUND;
    /* In this test only the second player has a controller. */
    core.world.poi[1].link = POI_SOURCE_LIVE;
    core.world.poi[1].position_m = v3(0.0f, 0.06f, 0.0f);
    core.game.tick = 5000;
    assert_int_equal(hint_after(300), HINT_MOVE);
    core.world.poi[1].link = POI_SOURCE_LOST;
    assert_int_equal(hint_after(60), HINT_LOST_POI);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_attract_shows_the_start_hint),
        TEST(test_the_result_shows_the_start_hint_when_a_dip_counts),
        TEST(test_a_resting_poi_gets_the_move_hint),
        TEST(test_the_move_hint_is_also_shown_before_the_round),
        TEST(test_a_moved_poi_gets_the_dip_hint),
        TEST(test_a_fish_over_the_dipped_poi_gives_the_lift_hint),
        TEST(test_a_fish_under_the_dipped_poi_gives_no_lift_hint),
        TEST(test_a_fish_on_the_lifted_poi_gives_the_bowl_hint),
        TEST(test_the_tilt_hint_stays_until_the_player_tilts),
        TEST(test_a_completed_lift_ends_the_lift_hint),
        TEST(test_unsuccessful_dips_give_the_technique_hint),
        TEST(test_a_fast_motion_that_tears_gives_the_slow_hint),
        TEST(test_a_tear_in_slow_motion_gives_no_slow_hint),
        TEST(test_a_hint_stays_for_one_and_a_half_seconds),
        TEST(test_an_urgent_hint_is_shown_immediately),
        TEST(test_a_bot_gets_no_hint),
        TEST(test_a_new_player_gets_the_hints_from_the_start),
        TEST(test_only_a_player_with_a_controller_gets_hints),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
