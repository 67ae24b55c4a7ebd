/* test_vision.c -- checks throughout a round that the bot sees exactly what the scene shows to a
 * player. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "tests/unit/support/bot_fixture.h"
#include "core/game/bot/bot.h"
#include "core/game/bot/vision.h"

static struct bot_fixture fixture;
static struct scene scene;

/* Starts a festival for two players. The second poi is held still over the water, and one player
 * holds a fan. */
static void begin(uint32_t seed)
{
    const struct core_config config = { .seed = seed, .players = 2 };
    bot_fixture_open(&fixture, &config, &technique_expert);
    fixture.input.poi[1] = (struct poi_input){ .link = POI_SOURCE_LIVE,
                                               .has_wrist = 1,
                                               .target.position_m = v3(0.2f, 0.1f, 0.1f) };
    fixture.input.shade[0] = (struct shade_input){ 1, -0.1f, 0.05f, 0.1f };
    bot_fixture_begin(&fixture);
}

#define SAME(seen, shown)                                                                          \
    _Static_assert(sizeof(seen) == sizeof(shown), "one type");                                     \
    assert_memory_equal(&(seen), &(shown), sizeof(seen))

static void game_is_as_shown(const struct vision *vision)
{
    const struct vision_game game = vision_game(vision);
    const vec3 tank_m = vision_game(vision).tank_m;
    SAME(game.tick, scene.tick);
    SAME(game.phase, scene.phase);
    SAME(game.mode, scene.mode);
    SAME(game.fouls, scene.player[vision->player].fouls);
    SAME(game.seconds_left, scene.seconds_left);
    SAME(tank_m, scene.tank_size_m);
}

static void fish_are_as_shown(const struct vision *vision)
{
    assert_int_equal(vision_game(vision).fish_count, scene.fish_count);
    for (uint32_t i = 0; i < scene.fish_count; i++) {
        const struct vision_fish fish = vision_fish(vision, i);
        if (fish.place != SCENE_ON_POI) { /* The thrashing of a lifted fish is added only in the
                                             picture, so a fish on a poi is not compared. */
            SAME(fish.position_m, scene.fish[i].position_m);
            SAME(fish.bend_rad, scene.fish[i].bend_rad);
        }
        SAME(fish.angles, scene.fish[i].angles);
        SAME(fish.length_m, scene.fish[i].length_m);
        SAME(fish.gape, scene.fish[i].gape);
        SAME(fish.gulp, scene.fish[i].gulp);
        SAME(fish.place, scene.fish[i].place);
    }
}

static void poi_is_as_shown(const struct vision *vision, uint32_t index)
{
    const struct vision_poi poi = vision_poi(vision, index);
    SAME(poi.present, scene.poi[index].present);
    SAME(poi.position_m, scene.poi[index].position_m);
    SAME(poi.angles, scene.poi[index].angles);
    SAME(poi.radius_m, scene.poi[index].ring_radius_m);
    SAME(poi.paper_left, scene.poi[index].paper_left);
    SAME(poi.water_m, scene.poi[index].water_m);
}

static void bowl_is_as_shown(const struct vision *vision, uint32_t index)
{
    const struct vision_bowl bowl = vision_bowl(vision, index);
    SAME(bowl.present, scene.bowl[index].present);
    if (bowl.present) {
        SAME(bowl.position_m, scene.bowl[index].position_m);
        SAME(bowl.radius_m, scene.bowl[index].radius_m);
    }
}

/* Checks that the bot sees each cell of the paper as the scene shows it. Cells outside the ring are
 * not compared. These cells are 0 for the bot, whereas the scene shows the nearest paper in
 * them. */
static void paper_is_as_shown(const struct vision *vision)
{
    const struct scene_poi *poi = &scene.poi[vision->player];
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        if (vision->world->poi[vision->player].sheet.state[i] != CELL_OUTSIDE) {
            assert_int_equal(vision_integrity(vision, i), poi->integrity[i]);
            assert_int_equal(vision_wetness(vision, i), poi->wetness[i]);
        } else {
            assert_int_equal(vision_integrity(vision, i) + vision_wetness(vision, i), 0);
        }
    }
}

static void all_is_as_shown(uint32_t player)
{
    const struct vision vision = { &fixture.core.game, &fixture.core.world, player };
    memset(&scene, 0, sizeof scene);
    core_scene(&fixture.core, &scene);
    game_is_as_shown(&vision);
    fish_are_as_shown(&vision);
    paper_is_as_shown(&vision);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        poi_is_as_shown(&vision, i);
        bowl_is_as_shown(&vision, i);
    }
}

static void test_vision_equals_the_scene_throughout_a_round(void **state)
{
    (void)state;
    uint32_t wet = 0, carried = 0, caught = 0;
    begin(8);
    fixture.core.game.player[0].fouls = 1;
    fixture.core.game.player[1].fouls = 2;
    for (uint32_t i = 0; fixture.core.game.phase == PHASE_ROUND; i++) {
        bot_fixture_tick(&fixture);
        if (i % 13u == 0) {
            all_is_as_shown(i % 2u);
            wet += scene.poi[0].water_m > 0.0f;
            carried += fixture.core.world.poi[0].carried_count;
            caught += scene.caught[0];
        }
    }
    assert_true(scene.poi[0].present && scene.poi[1].present);
    assert_true(scene.fan[0].present);
    assert_true(wet > 0 && carried > 0 && caught > 0);
}

static void test_vision_reads_nothing_beyond_the_last_element(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 12 };
    bot_fixture_open(&fixture, &config, &technique_expert);
    const struct vision vision = bot_fixture_sight(&fixture),
                        nobodys = { &fixture.core.game, &fixture.core.world, POI_MAX };
    expect_assert_failure((void)vision_fish(&vision, vision_game(&vision).fish_count));
    expect_assert_failure((void)vision_poi(&vision, POI_MAX));
    expect_assert_failure((void)vision_bowl(&vision, POI_MAX));
    expect_assert_failure((void)vision_integrity(&vision, SHEET_CELL_COUNT));
    expect_assert_failure((void)vision_wetness(&vision, SHEET_CELL_COUNT));
    expect_assert_failure((void)vision_integrity(&nobodys, 0));
    expect_assert_failure((void)vision_game(&nobodys));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_vision_equals_the_scene_throughout_a_round),
        cmocka_unit_test(test_vision_reads_nothing_beyond_the_last_element),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
