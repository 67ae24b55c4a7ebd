/* test_hints.c -- what the stall says to a player who does this or that. */
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

/* So many ticks of hints alone; what they say then. */
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

static void test_attract_says_start(void **state)
{
    (void)state;
    core.game.phase = PHASE_ATTRACT;
    assert_int_equal(hint_after(300), HINT_START);
}

static void test_the_result_says_start_when_a_dip_would_begin_again(void **state)
{
    (void)state;
    core.game.phase = PHASE_RESULT;
    core.game.phase_tick = core.game.tick;
    assert_int_equal(hint_after(GAME_AGAIN_DIP_TICKS - 1u), HINT_NONE);
    assert_int_equal(hint_after(20), HINT_START);
}

static void test_a_hand_that_rests_is_told_to_move(void **state)
{
    (void)state;
    assert_int_equal(hint_after(300), HINT_MOVE);
}

static void test_a_hand_that_moved_is_told_to_dip(void **state)
{
    (void)state;
    hint_after(300);
    core.world.poi[0].velocity_m_s = v3(0.3f, 0.0f, 0.0f);
    assert_int_equal(hint_after(24), HINT_MOVE); /* 6 cm are not a try yet */
    assert_int_equal(hint_after(120), HINT_DIP);
}

static void test_a_fish_over_the_dipped_poi_calls_for_a_lift(void **state)
{
    (void)state;
    hint_after(300);
    dip_poi();
    assert_int_equal(hint_after(200), HINT_NONE); /* under water with no fish near: let be */
    put_fish_over_the_poi();
    assert_int_equal(hint_after(200), HINT_LIFT);
}

static void test_a_fish_under_the_dipped_poi_does_not(void **state)
{
    (void)state;
    dip_poi();
    put_fish_over_the_poi();
    core.world.tank.fish[0].position_m.y = -0.09f;
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_a_fish_on_the_lifted_poi_calls_for_the_bowl(void **state)
{
    (void)state;
    put_fish_on_the_poi();
    assert_int_equal(hint_after(300), HINT_BOWL);
    core.world.tank.fish[0].gait = GAIT_BOWL;
    core.game.player[0].caught = 1;
    learn(HINT_TILT);
    learn(HINT_MOVE);
    learn(HINT_DIP);
    assert_int_equal(hint_after(300), HINT_NONE); /* and is not said again */
    put_fish_on_the_poi();
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_who_caught_one_hears_of_the_tilt_until_it_is_done(void **state)
{
    (void)state;
    learn(HINT_MOVE);
    learn(HINT_DIP);
    core.game.player[0].caught = 1;
    assert_int_equal(hint_after(300), HINT_TILT);
    core.game.hand_pose[0].angles.pitch_rad = -0.3f;
    assert_int_equal(hint_after(300), HINT_NONE);
}

static void test_a_lift_that_is_done_is_not_asked_for_any_longer(void **state)
{
    (void)state;
    hint_after(300);
    dip_poi();
    put_fish_over_the_poi();
    assert_int_equal(hint_after(200), HINT_LIFT);
    core.world.poi[0].immersed = 0.0f;
    assert_int_not_equal(hint_after(12), HINT_LIFT);
}

static void test_dips_in_vain_call_for_a_word_on_how_it_is_done(void **state)
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

static void test_haste_that_tears_is_told_to_slow_down(void **state)
{
    (void)state;
    hint_after(300);
    core.world.poi[0].velocity_m_s = v3(0.0f, 0.6f, 0.0f);
    core.world.poi[0].sheet.paper_cells -= 12u;
    assert_int_equal(hint_after(13), HINT_SLOWLY);
}

static void test_a_tear_without_haste_is_no_reproach(void **state)
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

static void test_what_is_urgent_does_not_wait(void **state)
{
    (void)state;
    hint_after(300);
    learn(HINT_MOVE);
    hint_after(13); /* now HINT_DIP is fresh */
    core.world.poi[0].link = POI_SOURCE_LOST;
    assert_int_equal(hint_after(13), HINT_LOST_POI);
    core.world.poi[0].link = POI_SOURCE_LIVE;
    core.game.player[0].out = 1;
    core.game.player[0].torn_tick = core.game.tick;
    assert_int_equal(hint_after(13), HINT_TORN);
}

static void test_a_bot_is_told_nothing(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    assert_int_equal(hint_after(500), HINT_NONE);
}

static void test_a_new_player_learns_anew(void **state)
{
    (void)state;
    learn(HINT_MOVE);
    core.game.hints = (struct hints){ 0 };
    assert_int_equal(hint_after(300), HINT_MOVE);
}

static void test_the_lesson_is_for_who_has_a_poi_in_hand(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 2, .players = 2 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    core.game.phase = PHASE_ROUND;
    core.world.poi[1].link = POI_SOURCE_LIVE; /* The first seat is empty. */
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
        TEST(test_attract_says_start),
        TEST(test_the_result_says_start_when_a_dip_would_begin_again),
        TEST(test_a_hand_that_rests_is_told_to_move),
        TEST(test_a_hand_that_moved_is_told_to_dip),
        TEST(test_a_fish_over_the_dipped_poi_calls_for_a_lift),
        TEST(test_a_fish_under_the_dipped_poi_does_not),
        TEST(test_a_fish_on_the_lifted_poi_calls_for_the_bowl),
        TEST(test_who_caught_one_hears_of_the_tilt_until_it_is_done),
        TEST(test_a_lift_that_is_done_is_not_asked_for_any_longer),
        TEST(test_dips_in_vain_call_for_a_word_on_how_it_is_done),
        TEST(test_haste_that_tears_is_told_to_slow_down),
        TEST(test_a_tear_without_haste_is_no_reproach),
        TEST(test_a_hint_stays_for_one_and_a_half_seconds),
        TEST(test_what_is_urgent_does_not_wait),
        TEST(test_a_bot_is_told_nothing),
        TEST(test_a_new_player_learns_anew),
        TEST(test_the_lesson_is_for_who_has_a_poi_in_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
