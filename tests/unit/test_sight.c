/* test_sight.c -- the bots' eye tells what the scene shows: no more, and the same. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "tests/unit/bot_stall.h"

static struct bot_stall stall;
static struct scene scene;

static int same_angles(struct angles a, struct angles b)
{
    return a.yaw_rad == b.yaw_rad && a.pitch_rad == b.pitch_rad && a.roll_rad == b.roll_rad;
}

static int same_place(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void compare_fish(const struct sight *sight)
{
    assert_int_equal(sight_fish_count(sight), scene.fish_count);
    for (uint32_t i = 0; i < scene.fish_count; i++) {
        const struct sight_fish seen = sight_fish(sight, i);
        const struct scene_fish *shown = &scene.fish[i];
        assert_true(same_place(seen.position_m, shown->position_m));
        assert_true(same_angles(seen.angles, shown->angles));
        assert_true(seen.length_m == shown->length_m && seen.bend_rad == shown->bend_rad);
        assert_true(seen.gape == shown->gape && seen.gulp == shown->gulp);
        assert_int_equal(seen.place, shown->place);
    }
}

static void compare_things(const struct sight *sight)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct sight_poi poi = sight_poi(sight, i);
        const struct sight_bowl bowl = sight_bowl(sight, i);
        assert_int_equal(poi.present, scene.poi[i].present);
        assert_int_equal(bowl.present, scene.bowl[i].present);
        if (poi.present) {
            assert_true(same_place(poi.position_m, scene.poi[i].position_m));
            assert_true(same_angles(poi.angles, scene.poi[i].angles));
            assert_true(poi.radius_m == scene.poi[i].ring_radius_m);
            assert_true(poi.paper_left == scene.poi[i].paper_left);
            assert_true(poi.water_m == scene.poi[i].water_m);
        }
        if (bowl.present) {
            assert_true(same_place(bowl.position_m, scene.bowl[i].position_m));
            assert_true(bowl.radius_m == scene.bowl[i].radius_m);
        }
        assert_int_equal(sight_fan(sight, i).present, scene.fan[i].present);
    }
}

/* Beyond the ring the scene repeats the paper beside it, for its renderer. */
static void compare_paper(const struct sight *sight)
{
    const struct sheet *sheet = &stall.core.poi[0].sheet;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        if (sheet->state[i] != CELL_OUTSIDE) {
            assert_int_equal(sight_integrity(sight, i), scene.poi[0].integrity[i]);
            assert_int_equal(sight_wetness(sight, i), scene.poi[0].wetness[i]);
        } else {
            assert_int_equal(sight_integrity(sight, i), 0);
        }
    }
}

static void test_the_eye_tells_what_the_scene_shows(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 12, .players = 2 };
    bot_stall_open(&stall, &config, &technique_novice);
    bot_stall_begin(&stall);
    const struct sight sight = bot_stall_sight(&stall);
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
        bot_stall_tick(&stall);
        if (i % 60u == 0) {
            core_scene(&stall.core, &scene);
            const struct sight_game game = sight_game(&sight);
            assert_int_equal(game.tick, scene.tick);
            assert_int_equal(game.phase, scene.phase);
            assert_int_equal(game.mode, scene.mode);
            assert_int_equal(game.fouls, scene.player[0].fouls);
            assert_true(game.seconds_left == scene.seconds_left);
            assert_true(same_place(sight_tank_m(&sight), scene.tank_size_m));
            compare_fish(&sight);
            compare_things(&sight);
            compare_paper(&sight);
        }
    }
}

static void test_there_is_nothing_to_see_beyond_the_last(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 12 };
    bot_stall_open(&stall, &config, &technique_expert);
    const struct sight sight = bot_stall_sight(&stall);
    expect_assert_failure((void)sight_fish(&sight, sight_fish_count(&sight)));
    expect_assert_failure((void)sight_poi(&sight, POI_MAX));
    expect_assert_failure((void)sight_bowl(&sight, POI_MAX));
    expect_assert_failure((void)sight_fan(&sight, SHADE_MAX));
    expect_assert_failure((void)sight_integrity(&sight, SHEET_CELL_COUNT));
    expect_assert_failure((void)sight_wetness(&sight, SHEET_CELL_COUNT));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_eye_tells_what_the_scene_shows),
        cmocka_unit_test(test_there_is_nothing_to_see_beyond_the_last),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
