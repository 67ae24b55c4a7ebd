/* test_practice.c -- checks practice mode, in which the paper shows its stress, torn paper is
 * replaced, hints are shown, and no score is stored. */
#include "tests/unit/support/core_fixture.h"
#include "core/game/phases.h"
#include "tests/unit/support/newest_record.h"

#define ROUND_S 30u

static const vec3 there_m = { 0.05f, ABOVE_M, 0.05f };

static void play(uint8_t mode)
{
    const struct core_config config = {
        .seed = 7, .fish_count = 12, .round_s = ROUND_S, .modes = (uint8_t)(1u << mode)
    };
    open_core(&config);
    hold(0, there_m);
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 6u * CORE_TICK_HZ);
    ticks(150);
}

static int practise(void **state)
{
    (void)state;
    play(MODE_PRACTICE);
    return 0;
}

static void test_the_paper_shows_its_stress_only_in_practice(void **state)
{
    (void)state;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        play(mode);
        assert_int_equal(look()->poi[0].shows_stress, mode == MODE_PRACTICE);
    }
}

static void test_a_torn_poi_is_replaced_by_a_new_one(void **state)
{
    (void)state;
    static struct sheet first, second;
    first = core.world.poi[0].sheet;
    tear_all(0);
    ticks(CORE_TICK_HZ);
    /* The torn paper is still shown, because it is replaced only after a second. */
    assert_int_equal(core.world.poi[0].sheet.paper_cells, 0);
    ticks(2);
    second = core.world.poi[0].sheet;
    assert_int_equal(second.paper_cells, second.paper_cells_new);
    assert_memory_not_equal(second.strength, first.strength, sizeof first.strength);
    assert_false(look()->player[0].out);
    tear_all(0);
    ticks(CORE_TICK_HZ + 2u);
    assert_int_equal(sounds[SOUND_GONE], 2);
    assert_memory_not_equal(core.world.poi[0].sheet.strength, second.strength,
                            sizeof first.strength);
    assert_int_equal(core.world.poi[0].sheet.grade, 6);
}

static void test_a_torn_poi_is_replaced_above_the_water(void **state)
{
    (void)state;
    lead(0, v3(there_m.x, BELOW_M, there_m.z));
    ticks(120);
    tear_all(0);
    ticks(2u * CORE_TICK_HZ);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, 0);
    lead(0, there_m);
    ticks(120);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, core.world.poi[0].sheet.paper_cells_new);
    assert_int_equal(game_record(&core.game, &core.world, &core.config).player[0].scoops,
                     1); /* `scoops` includes the scoop in which the first paper tore. */
}

static void test_only_time_ends_a_practice(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4; i++) {
        tear_all(0);
        ticks(GAME_GONE_TICKS + 1u);
        assert_int_equal(core.game.phase, PHASE_ROUND);
    }
    wait_for_phase(PHASE_RESULT, ROUND_S * CORE_TICK_HZ);
}

static void test_a_practice_stores_no_score(void **state)
{
    (void)state;
    core.game.player[0].caught = 50;
    wait_for_phase(PHASE_RESULT, (ROUND_S + 4u) * CORE_TICK_HZ);
    assert_int_equal(newest_record(&output)->id, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_PRACTICE][RANK_DAY][0].caught, 0);
    assert_int_equal(game_record(&core.game, &core.world, &core.config).caught,
                     50); /* The catch is in the record of the round, but not on a leaderboard. */
}

/* Dips a tilted ring until its middle is at the water surface, and lifts it again. Afterwards half
 * of the paper is wet. */
static void wet_half(void)
{
    /* Turns the poi no faster than a wrist can, because a sudden turn would be an invalid input. */
    for (uint32_t i = 1; i <= 30; i++) {
        input.poi[0].target.angles.pitch_rad = 0.7f * (float)i / 30.0f;
        ticks(1);
    }
    ticks(30);
    lead(0, v3(there_m.x, 0.0f, there_m.z));
    ticks(60);
    lead(0, v3(there_m.x, 0.07f, there_m.z));
    ticks(60);
}

static void test_half_wet_paper_gives_the_wetting_hint(void **state)
{
    (void)state;
    wet_half();
    ticks(180);
    assert_int_equal(look()->lesson[0].hint, HINT_WET_ALL);
    lead(0, v3(there_m.x, -0.09f, there_m.z));
    ticks(300);
    lead(0, v3(there_m.x, 0.07f, there_m.z));
    ticks(300);
    assert_int_not_equal(look()->lesson[0].hint, HINT_WET_ALL);
}

static void test_the_championship_gives_no_wetting_hint(void **state)
{
    (void)state;
    play(MODE_CHAMPIONSHIP);
    wet_half();
    ticks(200);
    assert_int_equal(look()->lesson[0].hint, HINT_NONE);
}

static void test_a_poured_fish_gives_the_clear_rim_hint(void **state)
{
    (void)state;
    struct carried_fish washed = { .fish = 1, .state = CARRIED_FALLING };
    core.world.tank.fish[1].gait = GAIT_HELD;
    core.world.tank.fish[1].holder = 0;
    core.world.tank.fish[1].position_m =
        v3_add(core.world.bowl[0].position_m, v3(0.0f, 0.02f, 0.0f));
    core.world.poi[0].carried_fish[core.world.poi[0].carried_count++] = washed;
    ticks(240);
    assert_int_equal(look()->lesson[0].hint, HINT_CLEAR_RIM);
    /* In practice, a foul must only show a hint. The fish still counts. */
    assert_int_equal(scene.player[0].fouls, 0);
    assert_int_equal(scene.caught[0], 1);
    ticks(600);
    assert_int_not_equal(look()->lesson[0].hint, HINT_CLEAR_RIM);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, practise)
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_paper_shows_its_stress_only_in_practice),
        TEST(test_a_torn_poi_is_replaced_by_a_new_one),
        TEST(test_a_torn_poi_is_replaced_above_the_water),
        TEST(test_only_time_ends_a_practice),
        TEST(test_a_practice_stores_no_score),
        TEST(test_half_wet_paper_gives_the_wetting_hint),
        cmocka_unit_test(test_the_championship_gives_no_wetting_hint),
        TEST(test_a_poured_fish_gives_the_clear_rim_hint),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
