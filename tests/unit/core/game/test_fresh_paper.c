/* test_fresh_paper.c -- checks when a poi gets new paper, and when torn paper ends a round. */
#include "tests/unit/support/game_fixture.h"
#include "core/game/phases.h"

static void test_a_round_with_no_paper_left_ends_three_seconds_later(void **state)
{
    (void)state;
    play_into_round();
    steps(50);
    tear_all(0);
    step();
    assert_int_equal(sounds[SOUND_GONE], 1);
    steps(GAME_GONE_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(core.game.hints.shown, HINT_TORN);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(sounds[SOUND_GONE], 1);
}

static void test_each_round_starts_with_new_and_different_paper(void **state)
{
    (void)state;
    play_into_round();
    static struct sheet first;
    first = core.world.poi[0].sheet;
    assert_int_equal(first.paper_cells, first.paper_cells_new);
    tear_all(0);
    steps(GAME_GONE_TICKS + 1u + GAME_AGAIN_TICKS);
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, first.paper_cells);
    assert_memory_not_equal(core.world.poi[0].sheet.strength, first.strength,
                            sizeof first.strength);
}

static void test_a_new_round_forgets_the_recorded_tear(void **state)
{
    (void)state;
    play_into_round();
    core.world.tear_clip[0].cause = TEAR_FLAT;
    tear_all(0);
    steps(GAME_GONE_TICKS + 1u + GAME_AGAIN_TICKS);
    assert_int_equal(core.world.tear_clip[0].cause, TEAR_FLAT);
    press(INPUT_START);
    assert_int_equal(core.world.tear_clip[0].cause, TEAR_NONE);
}

static void test_a_poi_under_water_gets_its_paper_above_the_water(void **state)
{
    (void)state;
    core.world.poi[0].immersed = 1.0f;
    start_with_a_poi();
    steps(30);
    assert_int_equal(core.game.player[0].handed, 0);
    core.world.poi[0].immersed = 0.0f;
    step();
    assert_int_equal(core.game.player[0].handed, 1);
}

static void test_the_attract_bot_gets_new_paper_when_its_paper_is_torn(void **state)
{
    (void)state;
    steps(10);
    tear_all(0);
    steps(2u * CORE_TICK_HZ);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, 0);
    steps(2);
    assert_int_equal(core.world.poi[0].sheet.paper_cells, core.world.poi[0].sheet.paper_cells_new);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_the_attract_bot_pours_a_full_bowl_back(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 9; i++) {
        core.world.tank.fish[i].gait = GAIT_BOWL;
    }
    core.world.bowl[0].fish_count = 9;
    steps(3u * CORE_TICK_HZ);
    assert_int_equal(core.world.bowl[0].fish_count, 9);
    core.world.tank.fish[9].gait = GAIT_BOWL;
    core.world.bowl[0].fish_count = 10;
    /* While the poi carries a fish, its bowl must not be emptied. */
    core.world.poi[0].carried_count = 1;
    steps(3u * CORE_TICK_HZ);
    assert_int_equal(core.world.bowl[0].fish_count, 10);
    core.world.poi[0].carried_count = 0;
    step();
    assert_int_equal(core.world.bowl[0].fish_count, 0);
    expect_all_to_swim_soon(10);
}

static void punch(struct sheet *sheet, float x_m, float z_m, float radius_m)
{
    const float cell_m = 2.0f * sheet->radius_m / (float)SHEET_SIDE;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        const float x = ((float)(i % SHEET_SIDE) + 0.5f) * cell_m - sheet->radius_m - x_m;
        const float z = ((float)(i / SHEET_SIDE) + 0.5f) * cell_m - sheet->radius_m - z_m;
        if (x * x + z * z < radius_m * radius_m && sheet->state[i] == CELL_PAPER) {
            sheet->state[i] = CELL_HOLE;
            sheet->paper_cells--;
        }
    }
}

static void test_paper_with_a_hole_in_the_middle_is_usable_beside_it(void **state)
{
    (void)state;
    struct sheet *sheet = &core.world.poi[0].sheet;
    assert_true(paper_can_hold(sheet));
    punch(sheet, 0.0f, 0.0f, 0.012f);
    assert_true(paper_can_hold(sheet));
    /* Leaves a ring of paper along the rim. It is 14 mm wide, which is too narrow for any fish to
     * lie on. */
    punch(sheet, 0.0f, 0.0f, 0.026f);
    assert_true(sheet_left(sheet) > PAPER_LEFT_MIN);
    assert_false(paper_can_hold(sheet));
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_a_round_with_no_paper_left_ends_three_seconds_later),
        TEST(test_a_new_round_forgets_the_recorded_tear),
        TEST(test_each_round_starts_with_new_and_different_paper),
        TEST(test_a_poi_under_water_gets_its_paper_above_the_water),
        TEST(test_the_attract_bot_gets_new_paper_when_its_paper_is_torn),
        TEST(test_the_attract_bot_pours_a_full_bowl_back),
        TEST(test_paper_with_a_hole_in_the_middle_is_usable_beside_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
