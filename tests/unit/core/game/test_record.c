/* test_record.c -- checks which fish count, what the record of a round contains, and that two
 * rounds are different. */
#include "tests/unit/support/game_fixture.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"
#include "tests/unit/support/newest_record.h"

static void land(uint32_t count)
{
    const struct catch_result caught[POI_MAX] = { { .landed = count, .bowled = count } };
    game_score(core.game.player, &core.game.album, &core.game, &core.world, caught, false, &output);
}

static void test_fish_count_only_while_the_round_runs(void **state)
{
    (void)state;
    land(3);
    assert_int_equal(core.game.player[0].caught, 0);
    start_with_a_poi();
    land(3);
    assert_int_equal(core.game.player[0].caught, 0);
    steps(GAME_READY_TICKS);
    land(2);
    land(1);
    assert_int_equal(core.game.player[0].caught, 3);
    steps(ROUND_S * CORE_TICK_HZ);
    land(5);
    assert_int_equal(core.game.player[0].caught, 3);
}

static void test_a_round_leaves_a_record_with_the_id_of_its_entry(void **state)
{
    (void)state;
    play_into_round();
    land(4);
    steps(ROUND_S * CORE_TICK_HZ);
    const uint32_t first_id = newest_record(&output)->id;
    assert_true(entries_keep_record(&output));
    assert_int_equal(newest_record(&output)->seed, 7);
    assert_int_equal(newest_record(&output)->caught, 4);
    assert_int_equal(newest_record(&output)->by_bot, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 4);
    steps(GAME_AGAIN_TICKS);
    press(INPUT_START);
    steps(GAME_READY_TICKS + ROUND_S * CORE_TICK_HZ);
    assert_true(newest_record(&output)->id > first_id);
    assert_true(entries_keep_record(&output));
    assert_int_equal(balance_count(&output, LEDGER_ROUND), 2);
    assert_int_equal(newest_record(&output)->caught, 0);
    /* No fish was caught in the second round, so the best score of the day is still 4. */
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 4);
}

static void test_record_ids_continue_after_those_of_the_store(void **state)
{
    (void)state;
    struct core_config config = core.config;
    config.persistent.ledger.last_id = 41;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    input.record_saved_id = 41;
    play_into_result();
    assert_true(newest_record(&output)->id > 41);
    assert_true(entries_keep_record(&output));
    assert_int_equal(balance_count(&output, LEDGER_ROUND), 1);
    /* The last entry in the store has the id 41, so the first new entry gets the id 42. */
    assert_int_equal(balance_entry(&output, 42)->id, 42);
}

static void test_a_bots_round_is_marked_and_never_the_best(void **state)
{
    (void)state;
    input.poi[0].link = POI_SOURCE_BOT;
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    land(9);
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(newest_record(&output)->by_bot, 1);
    assert_int_equal(newest_record(&output)->caught, 9);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 2);
}

static void test_a_better_round_becomes_the_best_of_the_day(void **state)
{
    (void)state;
    play_into_round();
    land(2);
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 2);
}

static void test_a_start_empties_the_bowl_and_releases_carried_fish(void **state)
{
    (void)state;
    core.world.tank.fish[0].gait = GAIT_BOWL;
    core.world.bowl[0].fish_count = 1;
    core.world.tank.fish[1].gait = GAIT_HELD;
    core.world.tank.fish[1].holder = 0;
    core.world.tank.fish[1].position_m = core.world.poi[0].position_m;
    core.world.poi[0].carried_fish[0].fish = 1;
    core.world.poi[0].carried_count = 1;
    hold_at(ABOVE_M);
    input.pressed = INPUT_START;
    core_tick(&core, &input, &output);
    input.pressed = 0;
    float last_m = core.world.tank.fish[1].position_m.y;
    assert_true(last_m > 0.03f);
    /* The released fish falls back into the water. It must not jump, so it moves by less than 15 mm
     * in each tick. */
    for (uint32_t i = 0; i < 60; i++) {
        core_tick(&core, &input, &output);
        assert_true(f_abs(core.world.tank.fish[1].position_m.y - last_m) < 0.015f);
        last_m = core.world.tank.fish[1].position_m.y;
    }
    assert_int_equal(core.world.bowl[0].fish_count, 0);
    assert_true(core.world.tank.fish[0].gait < GAIT_HELD);
    assert_true(core.world.tank.fish[1].gait < GAIT_HELD);
    assert_true(core.world.tank.fish[1].position_m.y < 0.0f);
}

static void test_a_fish_that_falls_into_the_bowl_before_the_round_is_poured_back(void **state)
{
    (void)state;
    start_with_a_poi();
    steps(100);
    core.world.tank.fish[3].gait = GAIT_BOWL;
    core.world.bowl[0].fish_count = 1;
    steps(GAME_READY_TICKS - 100u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(core.world.bowl[0].fish_count, 0);
    expect_all_to_swim_soon(4);
}

static void hold_a_fish(uint32_t fish, float y_m)
{
    core.world.tank.fish[fish].gait = GAIT_HELD;
    core.world.tank.fish[fish].holder = 0;
    core.world.tank.fish[fish].position_m = v3(0.0f, y_m, 0.0f);
    core.world.tank.fish[fish].velocity_m_s = v3(0.0f, 0.0f, 0.0f);
}

static void test_the_fish_of_a_removed_poi_falls_into_the_water(void **state)
{
    (void)state;
    play_into_round();
    hold_a_fish(1, 0.05f);
    core.world.poi[0].carried_fish[0] = (struct carried_fish){ .fish = 1 };
    core.world.poi[0].carried_count = 1;
    /* tank.fish[2] has GAIT_HELD, although no poi carries it. The core must release this fish
     * too. */
    hold_a_fish(2, 0.05f);
    input.poi[0].link = POI_SOURCE_ABSENT;
    core_tick(&core, &input, &output);
    assert_true(core.world.tank.fish[1].position_m.y > 0.045f);
    for (uint32_t i = 0; i < 30; i++) {
        core_tick(&core, &input, &output);
    }
    assert_int_equal(core.world.poi[0].carried_count, 0);
    assert_true(core.world.tank.fish[1].gait < GAIT_HELD);
    assert_true(core.world.tank.fish[2].gait < GAIT_HELD);
    assert_true(core.world.tank.fish[1].position_m.y < 0.0f);
}

static void test_a_round_without_a_player_ends_without_a_record(void **state)
{
    (void)state;
    /* START begins a round even if no controller is connected. */
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    const float before_s = game_seconds_left(&core.game, core.game.tick);
    steps(GAME_LOST_TICKS_MAX - 2u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_float_equal(game_seconds_left(&core.game, core.game.tick), before_s, 0.001f);
    steps(4);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(newest_record(&output)->id, 0);
    assert_int_equal(balance_count(&output, LEDGER_ROUND), 0);
    assert_int_equal(balance_count(&output, LEDGER_LEFT), 1);
}

static void test_an_abandoned_round_keeps_its_record(void **state)
{
    (void)state;
    play_into_round();
    step();
    land(3);
    input.poi[0].link = POI_SOURCE_ABSENT;
    steps(GAME_LOST_TICKS_MAX + 1u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(newest_record(&output)->caught, 3);
}

static void test_the_bots_first_catch_depends_on_the_seed(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 8, .fish_count = 12 };
    const uint32_t first = core.world.poi[0].seed;
    const uint32_t beside = core.world.poi[1].seed;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_true((core.world.poi[0].seed ^ 8u) != (first ^ 7u));
    assert_true(core.world.poi[0].seed != beside);
    assert_int_equal(core.world.poi[0].seed, game_poi_seed(8, 0, 0, GAME_SERIES_ROUND));
    assert_true(game_poi_seed(8, 0, 0, GAME_SERIES_ROUND) !=
                game_poi_seed(8, 0, 0, GAME_SERIES_ATTRACT));
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_fish_count_only_while_the_round_runs),
        TEST(test_a_round_leaves_a_record_with_the_id_of_its_entry),
        TEST(test_record_ids_continue_after_those_of_the_store),
        TEST(test_a_bots_round_is_marked_and_never_the_best),
        TEST(test_a_better_round_becomes_the_best_of_the_day),
        TEST(test_a_start_empties_the_bowl_and_releases_carried_fish),
        TEST(test_a_fish_that_falls_into_the_bowl_before_the_round_is_poured_back),
        TEST(test_the_fish_of_a_removed_poi_falls_into_the_water),
        TEST(test_a_round_without_a_player_ends_without_a_record),
        TEST(test_an_abandoned_round_keeps_its_record),
        TEST(test_the_bots_first_catch_depends_on_the_seed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
