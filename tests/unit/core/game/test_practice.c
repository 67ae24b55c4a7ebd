/* test_practice.c -- practice: the paper shows its stress, a torn one is changed, the keeper
 * coaches, and nothing is kept of it. */
#include "tests/unit/support/stall_stand.h"
#include "core/game/phases.h"

#define ROUND_S 30u

static const vec3 there_m = { 0.05f, STAND_ABOVE_M, 0.05f };

static void play(uint8_t mode)
{
    const struct core_config config = {
        .seed = 7, .fish_count = 12, .round_s = ROUND_S, .modes = (uint8_t)(1u << mode)
    };
    open_stall(&config);
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

static void test_only_in_practice_the_paper_shows_its_stress(void **state)
{
    (void)state;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        play(mode);
        assert_int_equal(look()->poi[0].shows_stress, mode == MODE_PRACTICE);
    }
}

static void test_a_torn_poi_is_changed_for_a_whole_and_other_one(void **state)
{
    (void)state;
    static struct sheet first, second;
    first = core.world.poi[0].sheet;
    tear_all(0);
    ticks(CORE_TICK_HZ);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, 0); /* The hole is seen for a second. */
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

static void test_it_is_changed_when_it_is_clear_of_the_water(void **state)
{
    (void)state;
    lead(0, v3(there_m.x, STAND_BELOW_M, there_m.z));
    ticks(120);
    tear_all(0);
    ticks(2u * CORE_TICK_HZ);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, 0);
    lead(0, there_m);
    ticks(120);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, core.world.poi[0].sheet.paper_cells_new);
    assert_int_equal(game_record(&core.game, &core.world, &core.config).player[0].scoops,
                     1); /* That of the torn one counts. */
}

static void test_torn_paper_ends_no_practice_but_time_does(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4; i++) {
        tear_all(0);
        ticks(GAME_GONE_TICKS + 1u);
        assert_int_equal(core.game.phase, PHASE_ROUND);
    }
    wait_for_phase(PHASE_RESULT, ROUND_S * CORE_TICK_HZ);
}

static void test_nothing_is_kept_of_it(void **state)
{
    (void)state;
    core.game.player[0].caught = 50;
    wait_for_phase(PHASE_RESULT, (ROUND_S + 4u) * CORE_TICK_HZ);
    assert_int_equal(output.record.id, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_PRACTICE][RANK_DAY][0].caught, 0);
    assert_int_equal(game_record(&core.game, &core.world, &core.config).caught,
                     50); /* Who asks can know. */
}

/* Dips to where the surface cuts the slanted ring in two, and comes up again. */
static void wet_half(void)
{
    for (uint32_t i = 1; i <= 30; i++) { /* As a wrist turns; at once would be doubted. */
        input.poi[0].target.angles.pitch_rad = 0.7f * (float)i / 30.0f;
        ticks(1);
    }
    ticks(30);
    lead(0, v3(there_m.x, 0.0f, there_m.z));
    ticks(60);
    lead(0, v3(there_m.x, 0.07f, there_m.z));
    ticks(60);
}

static void test_half_wet_paper_is_told_to_get_wet_all_over(void **state)
{
    (void)state;
    wet_half();
    ticks(180);
    assert_int_equal(look()->hint, HINT_WET_ALL);
    lead(0, v3(there_m.x, -0.09f, there_m.z));
    ticks(300);
    lead(0, v3(there_m.x, 0.07f, there_m.z));
    ticks(300);
    assert_int_not_equal(look()->hint, HINT_WET_ALL);
}

static void test_an_umpire_does_not_coach(void **state)
{
    (void)state;
    play(MODE_CHAMPIONSHIP);
    wet_half();
    ticks(200);
    assert_int_equal(look()->hint, HINT_NONE);
}

static void test_who_pours_is_told_to_clear_the_rim(void **state)
{
    (void)state;
    struct carried_fish washed = { .fish = 1, .state = CARRIED_FALLING };
    core.world.tank.fish[1].gait = GAIT_HELD;
    core.world.tank.fish[1].holder = 0;
    core.world.tank.fish[1].position_m =
        v3_add(core.world.bowl[0].position_m, v3(0.0f, 0.02f, 0.0f));
    core.world.poi[0].carried_fish[core.world.poi[0].carried_count++] = washed;
    ticks(240);
    assert_int_equal(look()->hint, HINT_CLEAR_RIM);
    assert_int_equal(scene.player[0].fouls, 0); /* A word, not a whistle; and it counts. */
    assert_int_equal(scene.caught[0], 1);
    ticks(600);
    assert_int_not_equal(look()->hint, HINT_CLEAR_RIM);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, practise)
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_only_in_practice_the_paper_shows_its_stress),
        TEST(test_a_torn_poi_is_changed_for_a_whole_and_other_one),
        TEST(test_it_is_changed_when_it_is_clear_of_the_water),
        TEST(test_torn_paper_ends_no_practice_but_time_does),
        TEST(test_nothing_is_kept_of_it),
        TEST(test_half_wet_paper_is_told_to_get_wet_all_over),
        cmocka_unit_test(test_an_umpire_does_not_coach),
        TEST(test_who_pours_is_told_to_clear_the_rim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
