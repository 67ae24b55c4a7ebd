/* test_phases.c -- checks the phases of the game. Each transition is checked just before and just
 * after its condition is met. */
#include "tests/unit/support/game_fixture.h"
#include "core/game/menu/menu.h"
#include "core/game/lab/lab.h"
#include "core/game/phases.h"
#include "tests/unit/support/newest_record.h"

static void test_the_game_starts_in_attract_and_stays_there_without_input(void **state)
{
    (void)state;
    steps(3000);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(core.game.round_count, 0);
}

static void test_start_begins_one_round_in_the_tick_that_sees_it(void **state)
{
    (void)state;
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
    steps(10);
    assert_int_equal(core.game.round_count, 1);
    assert_int_equal(sounds[SOUND_START], 1);
}

static void test_other_buttons_begin_no_round(void **state)
{
    (void)state;
    press(INPUT_BUTTON_ALL & ~(uint32_t)(INPUT_START | INPUT_TEST));
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_start_within_a_round_is_ignored(void **state)
{
    (void)state;
    play_into_round();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(core.game.round_count, 1);
}

static void test_a_dip_of_a_live_poi_starts_a_round(void **state)
{
    (void)state;
    dip();
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_a_poi_that_appears_below_the_water_does_not_dip(void **state)
{
    (void)state;
    hold_at(BELOW_M);
    steps(100);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_a_poi_just_above_the_dip_line_does_not_dip(void **state)
{
    (void)state;
    hold_at(ABOVE_M);
    step();
    hold_at(RULES_DIP_Y_M + 0.0001f);
    step();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    hold_at(RULES_DIP_Y_M - 0.0001f);
    step();
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_the_dip_of_a_bot_or_of_a_poi_without_a_bowl_starts_no_round(void **state)
{
    (void)state;
    dip();
    setup(state);
    hold_at(ABOVE_M);
    input.poi[1] = input.poi[0];
    input.poi[0].link = POI_SOURCE_BOT;
    step();
    input.poi[0].target.position_m.y = BELOW_M;
    input.poi[1].target.position_m.y = BELOW_M;
    step();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_ready_lasts_exactly_three_seconds(void **state)
{
    (void)state;
    start_with_a_poi();
    steps(GAME_READY_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_READY);
    step();
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

static void test_a_round_lasts_exactly_its_seconds(void **state)
{
    (void)state;
    play_into_round();
    steps(ROUND_S * CORE_TICK_HZ - 1u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(newest_record(&output)->end_tick - newest_record(&output)->start_tick,
                     ROUND_S * CORE_TICK_HZ);
}

/* After the end of the playing time, a fish on the paper may still be carried to the bowl for three
 * seconds. */
static void test_a_fish_on_the_paper_at_the_call_gets_three_seconds_to_the_bowl(void **state)
{
    (void)state;
    play_into_round();
    core.world.poi[0].carried_count = 1;
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    steps(GAME_CARRY_TICKS - 1);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(core.world.poi[0].carried_count, 0);
}

static void test_the_round_ends_when_the_last_fish_is_in_the_bowl(void **state)
{
    (void)state;
    play_into_round();
    core.world.poi[0].carried_count = 1;
    steps(ROUND_S * CORE_TICK_HZ + 10);
    core.world.poi[0].carried_count = 0;
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_no_poi_enters_the_water_after_the_call(void **state)
{
    (void)state;
    struct poi_target targets[POI_MAX];
    uint8_t live[POI_MAX];
    play_into_round();
    hold_at(BELOW_M);
    core.world.poi[0].carried_count = 1;
    steps(ROUND_S * CORE_TICK_HZ + 2);
    game_tick(&core.game, &core.world, &core.config, &input, &output, targets, live);
    assert_true(live[0]);
    assert_true(targets[0].position_m.y > 0.0f);
}

static void test_the_album_and_attract_follow_the_result_after_twelve_seconds(void **state)
{
    (void)state;
    play_into_result();
    steps(GAME_RESULT_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    step();
    /* The player has got a fish as a present, so the album opens. */
    assert_int_equal(core.game.phase, PHASE_ALBUM);
    steps(album_ticks(1));
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_start_in_the_result_counts_from_one_and_a_half_seconds(void **state)
{
    (void)state;
    play_into_result();
    steps(GAME_AGAIN_TICKS - 2u);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(core.game.round_count, 2);
}

static void test_a_dip_in_the_result_counts_from_two_and_a_half_seconds(void **state)
{
    (void)state;
    play_into_result();
    steps(GAME_AGAIN_DIP_TICKS - 3u);
    /* This dip ends one tick before the result screen accepts a dip, so it has no effect. */
    dip();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    dip();
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_seconds_left_count_down_through_ready_and_round(void **state)
{
    (void)state;
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), 0.0f, 0.0f);
    start_with_a_poi();
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), 3.0f, 0.01f);
    steps(GAME_READY_TICKS);
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), (float)ROUND_S, 0.01f);
    steps(ROUND_S * CORE_TICK_HZ - 1u);
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), 0.0f, 0.01f);
}

static void test_each_of_the_last_five_seconds_ticks_once(void **state)
{
    (void)state;
    play_into_round();
    clear_sounds();
    steps((ROUND_S - 5u) * CORE_TICK_HZ - 1u);
    assert_int_equal(sounds[SOUND_TICK], 0);
    step();
    assert_int_equal(sounds[SOUND_TICK], 1);
    steps(5u * CORE_TICK_HZ);
    assert_int_equal(sounds[SOUND_TICK], 5);
    assert_int_equal(sounds[SOUND_RESULT], 1);
}

/* Plays a round in which the player catches `caught` fish. Returns the sound of the result, and
 * asserts that no other result is heard. */
static enum sound result_with(uint32_t caught)
{
    static const enum sound results[] = { SOUND_RESULT, SOUND_WIN, SOUND_RECORD };
    enum sound heard = SOUND_NONE;
    play_into_round();
    clear_sounds();
    core.game.player[0].caught = (uint16_t)caught;
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    for (uint32_t i = 0; i < sizeof results / sizeof *results; i++) {
        if (sounds[results[i]] > 0) {
            assert_int_equal(heard, SOUND_NONE);
            assert_int_equal(sounds[results[i]], 1);
            heard = results[i];
        }
    }
    return heard;
}

static void test_the_sound_of_the_result_follows_the_outcome(void **state)
{
    assert_int_equal(result_with(0), SOUND_RESULT);
    setup(state);
    assert_int_equal(result_with(3), SOUND_RECORD);
    /* All ten places of each period of the leaderboard have better scores. */
    setup(state);
    for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
        for (uint32_t row = 0; row < RANK_ROWS; row++) {
            core.game.accounts.ranking.row[MODE_FESTIVAL][period][row].caught = 50;
        }
    }
    assert_int_equal(result_with(3), SOUND_WIN);
}

static void test_the_bot_controls_the_poi_in_attract(void **state)
{
    (void)state;
    hold_at(ABOVE_M);
    steps(5);
    assert_int_equal(core.world.poi[0].link, POI_SOURCE_BOT);
    assert_int_equal(core.world.poi[1].link, POI_SOURCE_ABSENT);
}

/* The controller was lost, and its player has left. The poi must not return to the last pose of
 * this player, but follow the bot. */
static void test_a_poi_that_the_bot_takes_over_does_not_return_to_the_player(void **state)
{
    (void)state;
    start_with_a_poi();
    input.poi[0].link = POI_SOURCE_LOST;
    steps(60);
    assert_true(core.game.control[0].return_ticks > 0);
    core.game.phase = PHASE_RESULT;
    core.game.phase_tick = core.game.tick;
    steps(GAME_RESULT_TICKS + 2u);
    assert_int_equal(core.game.control[0].holder, POI_SOURCE_BOT);
    assert_int_equal(core.game.control[0].return_ticks, 0);
}

static void test_language_changes_with_each_press_in_any_phase(void **state)
{
    (void)state;
    assert_int_equal(core.game.language, LANGUAGE_JA);
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    steps(3);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    play_into_round();
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_JA);
}

/* Runs the game without player input, through the result and the leaderboards, until it is in
 * attract mode again. */
static void steps_into_attract(void)
{
    for (uint32_t i = 0; i < 120u * CORE_TICK_HZ && core.game.phase != PHASE_ATTRACT; i++) {
        step();
    }
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_a_chosen_language_lasts_through_the_game_until_attract_begins(void **state)
{
    (void)state;
    press(INPUT_LANGUAGE);
    play_into_round();
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    steps_into_attract();
    assert_int_equal(core.game.language, LANGUAGE_JA);
}

static void test_a_language_chosen_in_attract_lasts_for_one_cycle(void **state)
{
    (void)state;
    steps(100);
    press(INPUT_LANGUAGE);
    steps(LANGUAGE_TICKS - 1u);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    step();
    assert_int_equal(core.game.language, LANGUAGE_JA);
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    steps(LANGUAGE_TICKS / 2u);
    /* This press selects Japanese, which is the operator's language. After LANGUAGE_TICKS the
     * language must therefore still be Japanese. */
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_JA);
    steps(2u * LANGUAGE_TICKS);
    assert_int_equal(core.game.language, LANGUAGE_JA);
}

static void test_attract_returns_to_the_operators_language(void **state)
{
    (void)state;
    const struct menu_scope scope = menu_scope_of(&core.game, &core.config, &output);
    settings_edit_set(&scope, SET_LANGUAGE, LANGUAGE_EN);
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_JA);
    steps(LANGUAGE_TICKS);
    assert_int_equal(core.game.language, LANGUAGE_EN);
}

static void test_a_chosen_language_stays_under_the_rules_of_format_7(void **state)
{
    (void)state;
    core.config.rules = 7;
    const uint32_t until = core.game.language_until;
    press(INPUT_LANGUAGE);
    steps(3u * LANGUAGE_TICKS);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    assert_int_equal(core.game.language_until, until);
}

static void test_the_start_lamp_blinks_only_when_start_is_accepted(void **state)
{
    (void)state;
    uint32_t lit = 0;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        step();
        lit += output.start_lamp;
    }
    assert_int_equal(lit, CORE_TICK_HZ / 2u);
    start_with_a_poi();
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        step();
        assert_int_equal(output.start_lamp, 0);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_the_game_starts_in_attract_and_stays_there_without_input),
        TEST(test_start_begins_one_round_in_the_tick_that_sees_it),
        TEST(test_other_buttons_begin_no_round),
        TEST(test_start_within_a_round_is_ignored),
        TEST(test_a_dip_of_a_live_poi_starts_a_round),
        TEST(test_a_poi_that_appears_below_the_water_does_not_dip),
        TEST(test_a_poi_just_above_the_dip_line_does_not_dip),
        TEST(test_the_dip_of_a_bot_or_of_a_poi_without_a_bowl_starts_no_round),
        TEST(test_ready_lasts_exactly_three_seconds),
        TEST(test_a_round_lasts_exactly_its_seconds),
        TEST(test_a_fish_on_the_paper_at_the_call_gets_three_seconds_to_the_bowl),
        TEST(test_the_round_ends_when_the_last_fish_is_in_the_bowl),
        TEST(test_no_poi_enters_the_water_after_the_call),
        TEST(test_the_album_and_attract_follow_the_result_after_twelve_seconds),
        TEST(test_start_in_the_result_counts_from_one_and_a_half_seconds),
        TEST(test_a_dip_in_the_result_counts_from_two_and_a_half_seconds),
        TEST(test_seconds_left_count_down_through_ready_and_round),
        TEST(test_each_of_the_last_five_seconds_ticks_once),
        TEST(test_the_sound_of_the_result_follows_the_outcome),
        TEST(test_the_bot_controls_the_poi_in_attract),
        TEST(test_a_poi_that_the_bot_takes_over_does_not_return_to_the_player),
        TEST(test_language_changes_with_each_press_in_any_phase),
        TEST(test_a_chosen_language_lasts_through_the_game_until_attract_begins),
        TEST(test_a_language_chosen_in_attract_lasts_for_one_cycle),
        TEST(test_attract_returns_to_the_operators_language),
        TEST(test_a_chosen_language_stays_under_the_rules_of_format_7),
        TEST(test_the_start_lamp_blinks_only_when_start_is_accepted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
