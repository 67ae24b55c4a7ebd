/* test_pause.c -- checks the loss of a controller during a round. The clock pauses, so that no
 * player can scoop and no paper wears. After some time the other players continue. */
#include "tests/unit/support/core_fixture.h"
#include "core/game/phases.h"
#include "tests/unit/support/newest_record.h"

#define ROUND_S 20u
#define MINE 0u
#define OTHER 1u

static const vec3 mine_m = { -0.10f, ABOVE_M, 0.05f };
static const vec3 other_m = { 0.10f, ABOVE_M, -0.05f };

static void play(uint8_t players)
{
    const struct core_config config = {
        .seed = 7, .fish_count = 12, .round_s = ROUND_S, .players = players
    };
    open_core(&config);
    hold(MINE, mine_m);
    if (players > 1) {
        hold(OTHER, other_m);
    }
    tick();
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 4u * CORE_TICK_HZ);
    ticks(CORE_TICK_HZ);
}

static int alone(void **state)
{
    (void)state;
    play(1);
    return 0;
}

static int two(void **state)
{
    (void)state;
    play(2);
    return 0;
}

static void lose(uint32_t index)
{
    input.poi[index].link = POI_SOURCE_LOST;
}

static void return_hand(uint32_t index)
{
    input.poi[index].link = POI_SOURCE_LIVE;
}

static void test_the_clock_pauses_for_both_players_and_shows_the_cause(void **state)
{
    (void)state;
    const float before_s = look()->seconds_left;
    lose(OTHER);
    ticks(5u * CORE_TICK_HZ);
    assert_float_equal(look()->seconds_left, before_s, 0.001f);
    assert_true(scene.paused);
    assert_true(scene.player[OTHER].lost);
    assert_false(scene.player[MINE].lost);
    assert_int_equal(scene.hint, HINT_LOST_POI);
}

static void test_the_round_continues_when_the_controller_returns(void **state)
{
    (void)state;
    lose(OTHER);
    ticks(5u * CORE_TICK_HZ);
    return_hand(OTHER);
    /* The input of a returning controller becomes valid after a quarter of a second (30 ticks). */
    ticks(60);
    const float before_s = look()->seconds_left;
    assert_false(scene.paused);
    assert_false(scene.player[OTHER].out);
    ticks(CORE_TICK_HZ);
    assert_float_equal(look()->seconds_left, before_s - 1.0f, 0.001f);
}

static void test_both_pois_leave_the_water_during_the_pause(void **state)
{
    (void)state;
    lead(MINE, v3(mine_m.x, BELOW_M, mine_m.z));
    ticks(CORE_TICK_HZ / 2u);
    assert_true(core.world.poi[MINE].immersed > 0.9f);
    lose(OTHER);
    float fastest_m_s = 0.0f;
    for (uint32_t i = 0; i < 4u * CORE_TICK_HZ; i++) {
        tick();
        fastest_m_s = f_max(fastest_m_s, v3_length(core.world.poi[MINE].velocity_m_s));
    }
    assert_true(core.world.poi[MINE].immersed <= 0.0f);
    assert_true(fastest_m_s < 0.25f);
    assert_int_equal(core.world.poi[MINE].sheet.paper_cells,
                     core.world.poi[MINE].sheet.paper_cells_new);
    /* During the pause, the poi must not follow its player's controller. */
    lead(MINE, v3(0.0f, BELOW_M, 0.0f));
    ticks(CORE_TICK_HZ);
    assert_true(core.world.poi[MINE].immersed <= 0.0f);
    return_hand(OTHER);
    /* The round continues now. Within three seconds the poi must reach the player's pose, which is
     * under water. */
    ticks(3u * CORE_TICK_HZ);
    assert_true(core.world.poi[MINE].immersed > 0.9f);
    assert_float_equal(core.world.poi[MINE].position_m.x, 0.0f, 0.01f);
}

static void test_the_other_players_continue_after_ten_seconds(void **state)
{
    (void)state;
    const float before_s = look()->seconds_left;
    lose(OTHER);
    ticks(GAME_LOST_TICKS_OTHERS);
    assert_false(look()->player[OTHER].out);
    assert_true(scene.paused);
    ticks(1);
    assert_true(look()->player[OTHER].out);
    assert_false(scene.paused);
    /* The player was removed from the round in the last tick, so the returning controller has no
     * effect. */
    return_hand(OTHER);
    ticks(CORE_TICK_HZ);
    assert_true(look()->player[OTHER].out);
    assert_float_equal(scene.seconds_left, before_s - 1.0f, 0.02f);
    lead(OTHER, v3(other_m.x, BELOW_M, other_m.z));
    ticks(2u * CORE_TICK_HZ);
    /* The poi no longer follows the controller of the removed player. */
    assert_true(core.world.poi[OTHER].immersed <= 0.0f);
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

static void test_a_few_short_losses_end_no_players_round(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 3; i++) {
        lose(OTHER);
        ticks(GAME_LOST_TICKS_OTHERS - CORE_TICK_HZ);
        return_hand(OTHER);
        ticks(CORE_TICK_HZ);
    }
    assert_false(look()->player[OTHER].out);
}

/* Plays until the round ends, with a controller that is lost for 9 s of every 9.3 s. Returns the
 * number of ticks. */
static uint32_t play_with_a_flaky_plug(uint32_t index)
{
    uint32_t passed = 0;
    for (; core.game.phase == PHASE_ROUND; passed++) {
        const int away = passed % 1120u < 1080u;
        input.poi[index].link = away ? POI_SOURCE_LOST : POI_SOURCE_LIVE;
        tick();
        assert_true(passed < 1200u * CORE_TICK_HZ);
    }
    return passed;
}

static void test_repeated_losses_pause_the_round_for_a_limited_time(void **state)
{
    (void)state;
    const uint32_t passed = play_with_a_flaky_plug(OTHER);
    /* One second of the round was played before the controller was lost for the first time. */
    const uint32_t round = (ROUND_S - 1u) * CORE_TICK_HZ;
    assert_true(core.game.player[OTHER].out && !core.game.player[MINE].out);
    assert_in_range(passed, round + GAME_WAIT_TICKS_OTHERS, round + GAME_WAIT_TICKS_OTHERS + 5u);
}

static void test_repeated_losses_end_the_round_of_a_single_player(void **state)
{
    (void)state;
    const uint32_t passed = play_with_a_flaky_plug(MINE);
    assert_in_range(passed, GAME_WAIT_TICKS_MAX, GAME_WAIT_TICKS_MAX * 11u / 10u);
}

static void test_each_round_has_its_own_pause_limit(void **state)
{
    (void)state;
    play_with_a_flaky_plug(OTHER);
    return_hand(OTHER);
    ticks(5u * CORE_TICK_HZ);
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 6u * CORE_TICK_HZ);
    ticks(1);
    assert_int_equal(core.game.waited_ticks, 0);
    assert_int_equal(core.game.player[OTHER].waited_ticks, 0);
}

/* The players play for ROUND_S seconds, but the round lasts about 9 s longer because of a pause.
 * The torn paper was used for 1.5 s before the pause and for 1.5 s after it. */
static void test_pauses_do_not_count_as_play_time_in_the_record(void **state)
{
    (void)state;
    const uint32_t *books = core.game.accounts.audits.count;
    ticks(CORE_TICK_HZ / 2u);
    lose(OTHER);
    ticks(9u * CORE_TICK_HZ);
    return_hand(OTHER);
    while (look()->paused) {
        tick();
    }
    ticks(3u * CORE_TICK_HZ / 2u);
    tear_all(MINE);
    wait_for_phase(PHASE_RESULT, 30u * CORE_TICK_HZ);
    ticks(2);
    assert_int_equal(books[AUDIT_ROUNDS], 1);
    assert_int_equal(books[AUDIT_PLAY_S], ROUND_S);
    assert_int_equal(books[AUDIT_PAPERS_TORN], 1);
    assert_int_equal(books[AUDIT_PAPER_LIFE_S], 3);
    assert_int_equal(newest_record(&output)->end_tick - newest_record(&output)->start_tick,
                     ROUND_S * CORE_TICK_HZ);
}

static void test_a_lost_player_who_is_out_pauses_nothing(void **state)
{
    (void)state;
    tear_all(MINE);
    ticks(2);
    assert_true(core.game.player[MINE].out);
    lose(MINE);
    uint32_t passed = 0;
    for (; core.game.phase == PHASE_ROUND; passed++) {
        tick();
        assert_false(look()->paused);
        assert_true(scene.hint != HINT_LOST_POI);
        assert_true(passed <= GAME_GONE_TICKS);
    }
}

static void test_no_loss_pauses_the_game_after_the_call_of_time(void **state)
{
    (void)state;
    while (game_seconds_left(&core.game, core.game.tick + 1u) > 0.0f) {
        tick();
    }
    /* Lets the poi carry a fish, which delays the end of the round by at most GAME_CARRY_TICKS. */
    core.world.poi[MINE].carried_count = 1;
    core.world.poi[MINE].carried_fish[0].fish = 0;
    core.world.tank.fish[0].gait = GAIT_HELD;
    ticks(1);
    assert_true(game_seconds_left(&core.game, core.game.tick) == 0.0f);
    /* The playing time is over, so the loss of a controller must not pause the round. */
    lose(MINE);
    uint32_t passed = 0;
    for (; core.game.phase == PHASE_ROUND; passed++) {
        tick();
        assert_false(look()->paused);
        assert_true(passed <= GAME_CARRY_TICKS);
    }
    assert_true(passed > 1u);
}

static void test_a_player_who_never_had_a_controller_pauses_nothing(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12, .round_s = ROUND_S, .players = 2 };
    open_core(&config);
    hold(MINE, mine_m);
    hold(OTHER, other_m);
    /* The second controller is lost before the round starts, so its player does not take part. */
    lose(OTHER);
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 4u * CORE_TICK_HZ);
    ticks(CORE_TICK_HZ);
    assert_false(look()->paused);
    assert_false(scene.player[OTHER].plays);
}

static void test_a_single_player_pauses_the_round_for_up_to_a_minute(void **state)
{
    (void)state;
    lose(MINE);
    ticks(GAME_LOST_TICKS_MAX);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(look()->paused);
    assert_false(scene.player[MINE].out);
    ticks(1);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_false(look()->paused);
}

static void test_separate_losses_do_not_add_up_to_the_minute(void **state)
{
    (void)state;
    lose(MINE);
    ticks(GAME_LOST_TICKS_MAX - 60u);
    return_hand(MINE);
    /* The input of a returning controller becomes valid after a quarter of a second (30 ticks), so
     * 50 ticks are enough. */
    ticks(50);
    lose(MINE);
    ticks(60);
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

static void test_an_invalid_pose_pauses_the_round_and_damages_no_paper(void **state)
{
    (void)state;
    const float nan = 0.0f / 0.0f;
    const uint32_t whole = core.world.poi[MINE].sheet.paper_cells_new;
    lead(MINE, v3(mine_m.x, BELOW_M, mine_m.z));
    ticks(60);
    const vec3 wild_m[] = { { 1.3f, -0.05f, 0.0f }, { nan, nan, nan } };
    for (size_t i = 0; i < sizeof wild_m / sizeof wild_m[0]; i++) {
        const vec3 good_m = input.poi[MINE].target.position_m;
        input.poi[MINE].target.position_m = wild_m[i];
        tick();
        assert_true(look()->paused);
        input.poi[MINE].target.position_m = good_m;
        ticks(5u * CORE_TICK_HZ);
        assert_false(look()->paused);
        assert_int_equal(core.world.poi[MINE].sheet.paper_cells, whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_clock_pauses_for_both_players_and_shows_the_cause, two),
        cmocka_unit_test_setup(test_the_round_continues_when_the_controller_returns, two),
        cmocka_unit_test_setup(test_both_pois_leave_the_water_during_the_pause, two),
        cmocka_unit_test_setup(test_the_other_players_continue_after_ten_seconds, two),
        cmocka_unit_test_setup(test_a_few_short_losses_end_no_players_round, two),
        cmocka_unit_test_setup(test_repeated_losses_pause_the_round_for_a_limited_time, two),
        cmocka_unit_test_setup(test_repeated_losses_end_the_round_of_a_single_player, alone),
        cmocka_unit_test_setup(test_each_round_has_its_own_pause_limit, two),
        cmocka_unit_test_setup(test_pauses_do_not_count_as_play_time_in_the_record, two),
        cmocka_unit_test_setup(test_a_lost_player_who_is_out_pauses_nothing, alone),
        cmocka_unit_test_setup(test_no_loss_pauses_the_game_after_the_call_of_time, alone),
        cmocka_unit_test(test_a_player_who_never_had_a_controller_pauses_nothing),
        cmocka_unit_test_setup(test_a_single_player_pauses_the_round_for_up_to_a_minute, alone),
        cmocka_unit_test_setup(test_separate_losses_do_not_add_up_to_the_minute, alone),
        cmocka_unit_test_setup(test_an_invalid_pose_pauses_the_round_and_damages_no_paper, alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
