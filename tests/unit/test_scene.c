/* test_scene.c -- the picture says what the state is, and changes nothing in it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"

static struct core core;
static struct scene scene;

static int setup(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 11, .best_today = { 8 }, .language = LANGUAGE_EN };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&scene, 0xa5, sizeof scene); /* what was there before must not matter */
    return 0;
}

static void tick(uint32_t count)
{
    static struct input input;
    static struct output output;
    for (uint32_t i = 0; i < count; i++) {
        output.sound_count = 0;
        core_tick(&core, &input, &output);
    }
}

static void test_every_fish_has_weights_that_sum_to_one(void **state)
{
    (void)state;
    core_scene(&core, &scene);
    assert_int_equal(scene.fish_count, core.tank.fish_count);
    for (uint32_t i = 0; i < scene.fish_count; i++) {
        float sum = 0.0f;
        for (uint32_t key = 0; key < SCENE_KEY_MAX; key++) {
            assert_true(scene.fish[i].weight[key] >= 0.0f);
            sum += scene.fish[i].weight[key];
        }
        assert_float_equal(sum, 1.0f, 1e-5f);
    }
}

static void test_fish_are_where_the_tank_has_them(void **state)
{
    (void)state;
    core.tank.fish[3].gait = GAIT_HELD;
    core.tank.fish[4].gait = GAIT_BOWL;
    core.tank.fish[5].gait = GAIT_SWIM;
    core_scene(&core, &scene);
    assert_int_equal(scene.fish[3].place, SCENE_ON_POI);
    assert_int_equal(scene.fish[4].place, SCENE_IN_BOWL);
    assert_int_equal(scene.fish[5].place, SCENE_IN_TANK);
    assert_memory_equal(&scene.fish[5].position_m, &core.tank.fish[5].position_m, sizeof(vec3));
    assert_float_equal(scene.fish[5].length_m, core.tank.fish[5].length_m, 0.0f);
}

static float maturity_at(float age_days)
{
    core.tank.fish[0].age_days = age_days;
    core_scene(&core, &scene);
    return scene.fish[0].maturity;
}

static void test_fish_redden_between_fifty_and_a_hundred_and_twenty_days(void **state)
{
    (void)state;
    assert_float_equal(maturity_at(0.0f), 0.0f, 0.0f);
    assert_float_equal(maturity_at(50.0f), 0.0f, 0.0f);
    assert_true(maturity_at(60.0f) > 0.0f);
    assert_in_range((int)(100.0f * maturity_at(100.0f)), 70, 95);
    assert_float_equal(maturity_at(120.0f), 1.0f, 1e-6f);
    assert_float_equal(maturity_at(4000.0f), 1.0f, 0.0f);
}

static void test_paper_shows_wetness_damage_and_holes(void **state)
{
    (void)state;
    core.poi[0].link = POI_LINK_BOT;
    struct sheet *sheet = &core.poi[0].sheet;
    const uint32_t middle = SHEET_SIDE / 2u * SHEET_SIDE + SHEET_SIDE / 2u;
    sheet->wetness[middle] = 1.0f;
    sheet->damage[middle + 1u] = 0.999f;
    sheet->state[middle + 2u] = CELL_HOLE;
    core_scene(&core, &scene);
    assert_int_equal(scene.poi[0].present, 1);
    assert_int_equal(scene.poi[0].wetness[middle], 255);
    assert_int_equal(scene.poi[0].wetness[middle + 1u], 0);
    assert_int_equal(scene.poi[0].integrity[middle], 255);
    assert_int_equal(scene.poi[0].integrity[middle + 1u], 1); /* nearly torn is not a hole */
    assert_int_equal(scene.poi[0].integrity[middle + 2u], 0);
}

static void test_cells_beyond_the_ring_continue_the_paper_inside(void **state)
{
    (void)state;
    core.poi[0].link = POI_LINK_BOT;
    core_scene(&core, &scene);
    const uint32_t row = SHEET_SIDE / 4u * SHEET_SIDE;
    assert_int_equal(core.poi[0].sheet.state[row], CELL_OUTSIDE);
    assert_int_equal(scene.poi[0].integrity[row], 255);
}

static void test_an_absent_poi_and_bowl_are_not_shown(void **state)
{
    (void)state;
    core_scene(&core, &scene);
    assert_int_equal(scene.poi[3].present, 0);
    assert_int_equal(scene.bowl[3].present, 0);
    assert_int_equal(scene.bowl[0].present, 1);
}

static void test_the_game_is_told_as_it_is(void **state)
{
    (void)state;
    core.game.phase = PHASE_ROUND;
    core.game.phase_tick = 240;
    core.tick = 360;
    core.game.player[0].caught = 5;
    core.game.hints.shown = HINT_BOWL;
    core_scene(&core, &scene);
    assert_int_equal(scene.tick, 360);
    assert_int_equal(scene.phase, PHASE_ROUND);
    assert_float_equal(scene.phase_s, 1.0f, 1e-6f);
    assert_float_equal(scene.seconds_left, 59.0f, 1e-4f);
    assert_int_equal(scene.caught[0], 5);
    assert_int_equal(scene.best_today, 8);
    assert_int_equal(scene.hint, HINT_BOWL);
    assert_int_equal(scene.language, LANGUAGE_EN);
}

static void test_looking_changes_nothing(void **state)
{
    (void)state;
    tick(200);
    static struct core before;
    before = core;
    core_scene(&core, &scene);
    assert_memory_equal(&before, &core, sizeof core);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_every_fish_has_weights_that_sum_to_one),
        TEST(test_fish_are_where_the_tank_has_them),
        TEST(test_fish_redden_between_fifty_and_a_hundred_and_twenty_days),
        TEST(test_paper_shows_wetness_damage_and_holes),
        TEST(test_cells_beyond_the_ring_continue_the_paper_inside),
        TEST(test_an_absent_poi_and_bowl_are_not_shown),
        TEST(test_the_game_is_told_as_it_is),
        TEST(test_looking_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
