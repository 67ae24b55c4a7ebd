/* test_lesson.c -- checks the lessons, which are aids in the picture: a mark on a fish that is easy
 * to catch, and an arrow from a caught fish to the bowl. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/game/phases.h"

static struct core core;
static struct scene_lesson shown;

/* Starts a round of two players at LEVEL_EASY. The tank has three fish: two deep ones, and fish 0,
 * which is easy to catch and near the bowl of player 0. Only player 0 has a controller. */
static int setup(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 3, .players = 2 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    core.game.phase = PHASE_ROUND;
    core.game.mode = MODE_FESTIVAL;
    core.game.round_s = 60;
    core.game.tick = core.game.phase_tick = 5000;
    core.world.poi[0].link = POI_SOURCE_LIVE;
    core.world.poi[0].position_m = v3(0.0f, 0.06f, 0.0f);
    core.world.poi[1].link = POI_SOURCE_ABSENT;
    core.world.bowl[0].position_m = v3(-0.3f, 0.0f, 0.2f);
    core.world.bowl[1].position_m = v3(0.3f, 0.0f, 0.2f);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        core.game.player[i].level = LEVEL_EASY;
        core.world.poi[i].carried_count = 0;
        core.world.poi[i].immersed = 0.0f;
    }
    for (uint32_t i = 0; i < 3u; i++) {
        struct fish *fish = &core.world.tank.fish[i];
        fish->gait = GAIT_SWIM;
        fish->velocity_m_s = v3(0.02f, 0.0f, 0.0f);
        fish->refractory_s = 0.0f;
        fish->startle = 0;
        fish->position_m = v3(-0.1f, i == 0 ? -0.02f : -0.12f, 0.0f);
    }
    return 0;
}

/* Runs only lesson_tick() and not the whole core, for `ticks` ticks. Returns what the lesson of the
 * player `player` shows afterwards. */
static const struct scene_lesson *lesson_after(uint32_t ticks, uint32_t player)
{
    for (uint32_t i = 0; i < ticks; i++) {
        lesson_tick(&core.lessons, &core.game, &core.world);
        core.game.tick++;
    }
    lesson_show(&core.lessons, &core.game, &core.world, player, &shown);
    return &shown;
}

static bool is_marked(void)
{
    return lesson_after(13, 0)->marks_fish && shown.fish == 0;
}

static void test_a_calm_fish_near_the_surface_is_marked(void **state)
{
    (void)state;
    assert_true(is_marked());
    assert_true(shown.mark_s > 0.0f);
}

static void test_a_fast_deep_or_startled_fish_is_not_marked(void **state)
{
    (void)state;
    struct fish *fish = &core.world.tank.fish[0];
    fish->velocity_m_s = v3(0.0f, 0.0f, 0.08f);
    assert_false(is_marked());
    fish->velocity_m_s = v3(0.0f, 0.0f, 0.02f);
    assert_true(is_marked());
    fish->position_m.y = -0.06f;
    assert_false(is_marked());
    fish->position_m.y = -0.02f;
    fish->startle = 1;
    assert_false(is_marked());
    fish->startle = 0;
    fish->gait = GAIT_ESCAPE;
    assert_false(is_marked());
}

static void test_a_fish_beside_a_wall_or_a_bowl_is_not_marked(void **state)
{
    (void)state;
    struct fish *fish = &core.world.tank.fish[0];
    fish->position_m.x = -0.5f * core.world.tank.size_m.x + 0.04f;
    assert_false(is_marked());
    fish->position_m = core.world.bowl[0].position_m;
    fish->position_m.x += BOWL_RADIUS_M + 0.02f;
    fish->position_m.y = -0.02f;
    assert_false(is_marked());
    fish->position_m.x += 0.06f;
    assert_true(is_marked());
}

static void test_a_mark_stays_until_the_fish_is_clearly_faster(void **state)
{
    (void)state;
    assert_true(is_marked());
    /* At this speed the fish gets no new mark, but keeps its mark. */
    core.world.tank.fish[0].velocity_m_s.x = 0.06f;
    assert_true(is_marked());
    core.world.tank.fish[0].velocity_m_s.x = 0.09f;
    assert_false(is_marked());
}

static void test_the_easiest_of_several_fish_is_marked(void **state)
{
    (void)state;
    core.world.tank.fish[1].position_m = v3(-0.02f, -0.02f, 0.0f);
    assert_int_equal(lesson_after(13, 0)->fish, 1);
}

static void test_a_mark_under_water_stays_with_its_fish(void **state)
{
    (void)state;
    assert_true(is_marked());
    core.world.tank.fish[1].position_m = v3(-0.02f, -0.02f, 0.0f);
    core.world.poi[0].immersed = 1.0f;
    assert_int_equal(lesson_after(600, 0)->fish, 0);
    /* The dip is over and has not caught the fish. An easier fish must now get the mark. */
    core.world.poi[0].immersed = 0.0f;
    assert_int_equal(lesson_after(13, 0)->fish, 1);
}

static void test_two_players_have_different_fish_on_their_own_sides(void **state)
{
    (void)state;
    core.world.poi[1].link = POI_SOURCE_LIVE;
    core.world.poi[1].position_m = v3(-0.1f, 0.06f, 0.0f);
    core.world.tank.fish[1].position_m = v3(0.1f, -0.02f, 0.0f);
    assert_int_equal(lesson_after(13, 0)->fish, 0);
    /* Fish 0 is nearer to the bowl of player 0, so the mark of player 1 is on fish 1. */
    assert_int_equal(lesson_after(13, 1)->fish, 1);
    /* Only fish 2 is easy now, and it is equally far from both bowls. Only one of the two players
     * may get a mark on it. */
    core.world.tank.fish[0].position_m.y = core.world.tank.fish[1].position_m.y = -0.1f;
    core.world.tank.fish[2].position_m = v3(0.0f, -0.02f, 0.0f);
    assert_int_equal(lesson_after(13, 0)->fish, 2);
    assert_false(lesson_after(13, 1)->marks_fish);
}

static void test_no_fish_is_marked_at_master_or_in_a_championship(void **state)
{
    (void)state;
    core.game.player[0].level = LEVEL_MASTER;
    assert_false(is_marked());
    core.game.player[0].level = LEVEL_NORMAL;
    assert_true(is_marked());
    core.game.mode = MODE_CHAMPIONSHIP;
    assert_false(is_marked());
}

static void test_only_a_player_who_may_dip_has_a_mark(void **state)
{
    (void)state;
    core.game.paused = 1;
    assert_false(is_marked());
    core.game.paused = 0;
    core.game.player[0].out = 1;
    assert_false(is_marked());
    core.game.player[0].out = 0;
    core.world.poi[0].link = POI_SOURCE_BOT;
    assert_false(is_marked());
    core.world.poi[0].link = POI_SOURCE_LIVE;
    assert_true(is_marked());
    core.game.phase = PHASE_RESULT;
    assert_false(is_marked());
}

static void test_the_arrow_points_to_the_bowl_while_a_fish_lies_on_the_paper(void **state)
{
    (void)state;
    struct poi *poi = &core.world.poi[0];
    assert_false(lesson_after(13, 0)->points_to_bowl);
    poi->carried_count = 1;
    assert_true(lesson_after(13, 0)->points_to_bowl);
    /* The arrow is shown, so the mark on a fish is hidden: the picture has only one aid at a
     * time. */
    assert_false(shown.marks_fish);
    poi->immersed = 0.5f;
    assert_false(lesson_after(1, 0)->points_to_bowl);
    poi->immersed = 0.0f;
    poi->position_m.x = core.world.bowl[0].position_m.x + 0.01f;
    poi->position_m.z = core.world.bowl[0].position_m.z;
    assert_false(lesson_after(1, 0)->points_to_bowl);
}

static void test_the_arrow_is_shown_at_every_level_but_not_in_a_championship(void **state)
{
    (void)state;
    core.world.poi[0].carried_count = 1;
    core.game.player[0].level = LEVEL_MASTER;
    assert_true(lesson_after(1, 0)->points_to_bowl);
    core.game.mode = MODE_CHAMPIONSHIP;
    assert_false(lesson_after(1, 0)->points_to_bowl);
}

static void test_no_hash_contains_the_lessons(void **state)
{
    (void)state;
    const uint64_t before = core_hash(&core);
    assert_true(lesson_easiest_fish(&core.lessons, &core.world, 0) == 0);
    core.lessons.player[0].fish = 2;
    assert_true(core_hash(&core) == before);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_a_calm_fish_near_the_surface_is_marked),
        TEST(test_a_fast_deep_or_startled_fish_is_not_marked),
        TEST(test_a_fish_beside_a_wall_or_a_bowl_is_not_marked),
        TEST(test_a_mark_stays_until_the_fish_is_clearly_faster),
        TEST(test_the_easiest_of_several_fish_is_marked),
        TEST(test_a_mark_under_water_stays_with_its_fish),
        TEST(test_two_players_have_different_fish_on_their_own_sides),
        TEST(test_no_fish_is_marked_at_master_or_in_a_championship),
        TEST(test_only_a_player_who_may_dip_has_a_mark),
        TEST(test_the_arrow_points_to_the_bowl_while_a_fish_lies_on_the_paper),
        TEST(test_the_arrow_is_shown_at_every_level_but_not_in_a_championship),
        TEST(test_no_hash_contains_the_lessons),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
