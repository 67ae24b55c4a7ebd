/* test_lesson.c -- checks which fish the lessons mark, when the arrow points to the bowl, what the
 * ghost shows, and which fault each hint beside the poi follows. */
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
    /* The ghost poi appears only in the first round after attract mode. The tests without a ghost
     * play a later round. */
    core.lessons.is_first = false;
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

/* ---- Ghost ----------------------------------------------------------------------------------- */

static const struct scene_ghost *ghost_after(uint32_t ticks)
{
    return &lesson_after(ticks, 0)->ghost;
}

static float gap_m(vec3 a, vec3 b)
{
    return v3_length(v3(a.x - b.x, 0.0f, a.z - b.z));
}

static void begin_first_round(void)
{
    lesson_init(&core.lessons);
    core.game.phase = PHASE_READY;
    core.game.phase_tick = core.game.tick;
}

static void
test_the_ghost_dips_beside_a_fish_glides_under_it_and_carries_it_to_the_bowl(void **state)
{
    (void)state;
    const vec3 fish_m = core.world.tank.fish[0].position_m;
    const vec3 bowl_m = core.world.bowl[0].position_m;
    begin_first_round();
    assert_true(ghost_after(60)->is_present);
    assert_true(shown.ghost.position_m.y > 0.03f);
    ghost_after(120); /* After 1.5 s the ghost is under water, beside the fish and slanted. */
    assert_true(shown.ghost.position_m.y < fish_m.y);
    assert_in_range((int)(1000.0f * gap_m(shown.ghost.position_m, fish_m)), 45, 75);
    assert_true(shown.ghost.angles.pitch_rad < -0.5f);
    assert_float_equal(shown.ghost.opacity, 1.0f, 0.01f);
    core.game.phase = PHASE_ROUND; /* The ghost continues after the round has begun. */
    /* After 2.6 s the ghost is under the fish, and its paper is level. */
    ghost_after(132);
    assert_true(gap_m(shown.ghost.position_m, fish_m) < 0.01f);
    assert_true(shown.ghost.position_m.y < fish_m.y);
    assert_true(f_abs(shown.ghost.angles.pitch_rad) < 0.1f);
    ghost_after(96); /* After 3.4 s the ghost has lifted the fish. */
    assert_true(shown.ghost.carries && shown.ghost.position_m.y > 0.03f);
    ghost_after(150); /* After 4.65 s the ghost is over the bowl. */
    assert_true(gap_m(shown.ghost.position_m, bowl_m) < 0.01f);
    assert_float_equal(shown.ghost.opacity, 1.0f, 0.01f); /* The ghost begins to fade out now. */
    assert_in_range((int)(100.0f * ghost_after(24)->opacity), 20, 60);
    assert_false(ghost_after(60)->is_present);
}

static void test_a_dip_ends_the_ghost(void **state)
{
    (void)state;
    begin_first_round();
    assert_true(ghost_after(60)->is_present);
    core.game.phase = PHASE_ROUND;
    core.world.poi[0].immersed = 0.2f;
    assert_false(ghost_after(1)->is_present);
    core.world.poi[0].immersed = 0.0f;
    assert_false(ghost_after(60)->is_present);
}

static void test_a_dip_in_ready_which_moves_no_poi_ends_the_ghost(void **state)
{
    (void)state;
    core.game.control[0].live_y_m = -0.05f;
    begin_first_round();
    assert_true(ghost_after(60)->is_present); /* The dip that began the game does not count. */
    core.game.control[0].live_y_m = 0.05f;
    assert_true(ghost_after(10)->is_present);
    core.game.control[0].live_y_m = -1.0f; /* Invalid input is no dip. */
    assert_true(ghost_after(10)->is_present);
    core.game.control[0].live_y_m = 0.05f;
    assert_true(ghost_after(10)->is_present);
    core.game.control[0].live_y_m = -0.05f;
    assert_false(ghost_after(1)->is_present);
}

static void test_the_dip_that_begins_the_game_does_not_end_the_ghost(void **state)
{
    (void)state;
    float *y_m = &core.game.control[0].live_y_m;
    lesson_init(&core.lessons);
    core.game.phase = PHASE_MODE_SELECT;
    *y_m = 0.05f;
    lesson_after(10, 0);
    *y_m = RULES_DIP_Y_M - 0.001f; /* READY begins in the tick in which the poi is dipped. */
    core.game.phase = PHASE_READY;
    core.game.phase_tick = core.game.tick;
    assert_true(ghost_after(60)->is_present);
    *y_m = RULES_DIP_Y_M + 0.001f; /* A trembling hand is no second dip. */
    lesson_after(1, 0);
    *y_m = RULES_DIP_Y_M - 0.001f;
    assert_true(ghost_after(1)->is_present);
    *y_m = 0.05f;
    lesson_after(1, 0);
    *y_m = -0.05f;
    assert_false(ghost_after(1)->is_present);
}

static void test_only_the_first_round_after_attract_mode_has_a_ghost(void **state)
{
    (void)state;
    begin_first_round();
    core.game.phase = PHASE_RESULT;
    lesson_after(2, 0);
    core.game.phase = PHASE_READY;
    assert_false(ghost_after(60)->is_present);
    core.game.phase = PHASE_ATTRACT;
    lesson_after(2, 0);
    core.game.phase = PHASE_READY;
    assert_true(ghost_after(60)->is_present);
}

static void test_a_championship_and_a_bot_have_no_ghost(void **state)
{
    (void)state;
    core.game.mode = MODE_CHAMPIONSHIP;
    begin_first_round();
    assert_false(ghost_after(60)->is_present);
    core.game.mode = MODE_FESTIVAL;
    core.world.poi[0].link = POI_SOURCE_BOT;
    assert_false(ghost_after(60)->is_present);
    core.world.poi[0].link = POI_SOURCE_LIVE;
    assert_true(ghost_after(60)->is_present);
}

static void test_the_bots_dips_before_the_game_do_not_end_the_ghost(void **state)
{
    (void)state;
    static struct output output;
    const struct core_config config = { .seed = 3, .fish_count = 40, .players = 1 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    const struct poi *poi = &core.world.poi[0];
    const uint32_t ticks_max = 60u * CORE_TICK_HZ;
    for (uint32_t i = 0; i < ticks_max && (poi->dips == 0 || poi->immersed <= 0.0f); i++) {
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    }
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_true(poi->dips > 0 && poi->immersed > 0.0f);
    input.poi[0] =
        (struct poi_input){ .link = POI_SOURCE_LIVE, .target.position_m = v3(0.05f, 0.06f, 0.02f) };
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        input.pressed = i == 0 ? INPUT_START : 0u;
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    }
    assert_int_equal(core.game.phase, PHASE_READY);
    lesson_show(&core.lessons, &core.game, &core.world, 0, &shown);
    assert_true(shown.ghost.is_present);
    while (core.game.phase == PHASE_READY) { /* The ghost poi (the demonstration) continues in the
                                                round. */
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    }
    assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    lesson_show(&core.lessons, &core.game, &core.world, 0, &shown);
    assert_true(shown.ghost.is_present);
}

static void test_the_ghost_of_a_player_without_a_controller_is_hidden(void **state)
{
    (void)state;
    begin_first_round();
    assert_true(ghost_after(60)->is_present);
    core.world.poi[0].link = POI_SOURCE_LOST;
    assert_false(ghost_after(10)->is_present);
    core.world.poi[0].link = POI_SOURCE_LIVE;
    assert_true(ghost_after(10)->is_present);
}

static void test_the_ghost_waits_during_a_pause_and_hides_the_ring(void **state)
{
    (void)state;
    begin_first_round();
    core.game.phase = PHASE_ROUND;
    assert_true(ghost_after(60)->is_present);
    assert_false(shown.marks_fish);
    core.game.paused = 1;
    const vec3 before_m = shown.ghost.position_m;
    assert_true(ghost_after(2u * LESSON_GHOST_TICKS)->is_present);
    assert_true(v3_length(v3_sub(shown.ghost.position_m, before_m)) < 1e-6f);
    core.game.paused = 0;
    assert_false(ghost_after(LESSON_GHOST_TICKS)->is_present);
    assert_true(is_marked());
}

/* ---- Hints beside the poi -------------------------------------------------------------------- */

static uint8_t hint_after(uint32_t ticks)
{
    return lesson_after(ticks, 0)->hint;
}

static void test_the_hint_to_dip_waits_for_four_seconds(void **state)
{
    (void)state;
    core.world.poi[0].velocity_m_s = v3(0.3f, 0.0f, 0.0f);
    assert_int_equal(hint_after(470), HINT_NONE);
    assert_int_equal(hint_after(30), HINT_DIP);
    assert_true(shown.hint_s >= 0.0f && shown.hint_s <= 30.0f * CORE_TICK_S);
    core.world.poi[0].immersed = 1.0f;
    assert_int_equal(hint_after(13), HINT_NONE);
}

static void test_the_hint_to_dip_also_follows_a_poi_that_does_not_move(void **state)
{
    (void)state;
    assert_int_equal(hint_after(470), HINT_NONE);
    assert_int_equal(hint_after(30), HINT_DIP);
    assert_int_equal(core.lessons.player[0].hints.shown, HINT_MOVE);
    core.world.poi[0].velocity_m_s = v3(0.3f, 0.0f, 0.0f);
    assert_int_equal(hint_after(240), HINT_DIP); /* Motion alone does not end the hint. */
}

static void learn(uint32_t hint)
{
    core.lessons.player[0].hints.learned |= 1u << hint;
}

static void test_the_hint_to_glide_follows_two_dips_without_a_catch_and_ends(void **state)
{
    (void)state;
    learn(HINT_MOVE);
    learn(HINT_DIP);
    core.world.poi[0].dips = 1;
    assert_int_equal(hint_after(300), HINT_NONE);
    core.world.poi[0].dips = 2;
    assert_int_equal(hint_after(60), HINT_GLIDE);
    /* The hint must disappear after some seconds, so that it does not hide the fish. */
    assert_int_equal(hint_after(620), HINT_NONE);
}

static void test_the_hint_to_lift_needs_a_long_dip_and_a_fish_over_the_paper(void **state)
{
    (void)state;
    core.world.poi[0].immersed = 1.0f;
    core.world.poi[0].position_m = v3(-0.1f, -0.05f, 0.0f); /* Fish 0 is 3 cm above the ring. */
    assert_int_equal(hint_after(160), HINT_NONE);
    assert_int_equal(hint_after(40), HINT_LIFT);
    core.world.tank.fish[0].position_m.x += 0.04f;
    assert_int_equal(hint_after(240), HINT_NONE);
}

static void test_the_hint_about_the_bowl_follows_a_fish_that_stays_on_the_paper(void **state)
{
    (void)state;
    core.world.tank.fish[0].gait = GAIT_HELD;
    core.world.tank.fish[0].holder = 0;
    core.world.poi[0].carried_count = 1;
    assert_int_equal(hint_after(150), HINT_NONE);
    assert_int_equal(hint_after(60), HINT_BOWL);
}

static void test_the_hint_about_haste_follows_motion_that_tears(void **state)
{
    (void)state;
    core.world.poi[0].strain.cells_torn = 1;
    assert_int_not_equal(hint_after(13), HINT_SLOWLY);
    core.world.poi[0].velocity_m_s = v3(0.2f, 0.0f, 0.0f);
    assert_int_equal(hint_after(13), HINT_SLOWLY);
    core.world.poi[0].strain.cells_torn = 0;
    assert_int_not_equal(hint_after(400), HINT_SLOWLY);
}

static void test_the_hint_about_haste_appears_whenever_its_fault_occurs(void **state)
{
    (void)state;
    struct poi *poi = &core.world.poi[0];
    learn(HINT_MOVE);
    learn(HINT_DIP);
    poi->dips = 2;
    assert_int_equal(hint_after(60), HINT_GLIDE);
    assert_int_equal(hint_after(940), HINT_NONE); /* HINT_GLIDE still fits, but is hidden now. */
    poi->strain.cells_torn = 1;
    poi->velocity_m_s = v3(0.2f, 0.0f, 0.0f);
    assert_int_equal(hint_after(13), HINT_SLOWLY);
}

static void test_damage_alone_is_no_haste(void **state)
{
    (void)state;
    struct poi *poi = &core.world.poi[0];
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        poi->sheet.damage[i] = 0.9f;
    }
    const float strength_n_m = sheet_grade(poi->sheet.grade)->wet_n_m;
    poi->velocity_m_s = v3(0.2f, 0.0f, 0.0f);
    poi->immersed = 0.3f;
    poi->strain.tension_max_n_m = 0.5f * strength_n_m;
    assert_int_not_equal(hint_after(60), HINT_SLOWLY);
    poi->immersed = 0.0f; /* A load on the paper in the air must not show HINT_SLOWLY either. */
    poi->strain.tension_max_n_m = 0.7f * strength_n_m;
    assert_int_not_equal(hint_after(60), HINT_SLOWLY);
    poi->immersed = 0.3f;
    assert_int_equal(hint_after(60), HINT_SLOWLY);
}

static void expect_a_new_lesson(uint32_t player)
{
    const struct lesson *lesson = &core.lessons.player[player];
    assert_int_equal(lesson->flat_dips, 0);
    assert_int_equal(lesson->haste_tick, 0);
    assert_true(lesson->hints.moved_m < 0.01f);
    assert_int_equal(lesson->hints.learned, 0);
    assert_int_equal(lesson->hints.pupil, player);
    assert_int_equal(lesson->ghost.state, GHOST_IS_OVER);
}

static void play_with_faults(void)
{
    for (uint32_t i = 0; i < 2u; i++) {
        core.lessons.player[i].flat_dips = 2;
        core.lessons.player[i].haste_tick = core.game.tick;
        core.lessons.player[i].hints.learned = 1u << HINT_MOVE;
        core.lessons.player[i].hints.moved_m = 0.5f;
        core.lessons.player[i].ghost.state = GHOST_IS_OVER;
    }
}

static void test_a_new_game_resets_the_lesson_but_not_the_ghost(void **state)
{
    (void)state;
    core.world.poi[1].link = POI_SOURCE_LIVE;
    play_with_faults();
    lesson_after(20, 0);
    assert_int_equal(core.lessons.player[0].flat_dips, 2);
    core.game.phase = PHASE_READY;
    core.game.phase_tick = core.game.tick;
    lesson_after(1, 0);
    expect_a_new_lesson(0);
    expect_a_new_lesson(1);
}

static void test_a_player_who_leaves_takes_the_lesson_along(void **state)
{
    (void)state;
    core.world.poi[1].link = POI_SOURCE_LIVE;
    play_with_faults();
    lesson_after(20, 0);
    core.world.poi[1].link = POI_SOURCE_ABSENT;
    lesson_after(1, 0);
    expect_a_new_lesson(1);
    assert_int_equal(core.lessons.player[0].flat_dips, 2);
}

static void test_only_a_player_who_may_dip_makes_faults(void **state)
{
    (void)state;
    core.game.phase = PHASE_READY;
    core.world.poi[0].splash_m_s = 0.4f;
    lesson_after(5, 0);
    assert_int_equal(core.lessons.player[0].flat_dips, 0);
    core.game.phase = PHASE_ROUND;
    lesson_after(1, 0);
    assert_int_equal(core.lessons.player[0].flat_dips, 1);
}

static void test_the_hint_to_tilt_follows_two_flat_dips(void **state)
{
    (void)state;
    struct poi *poi = &core.world.poi[0];
    learn(HINT_MOVE);
    learn(HINT_DIP);
    for (uint32_t i = 0; i < 2u; i++) {
        assert_int_equal(hint_after(100), HINT_NONE);
        poi->splash_m_s = 0.4f;
        hint_after(1);
        poi->splash_m_s = 0.0f;
    }
    assert_int_equal(hint_after(60), HINT_TILT);
    poi->splash_m_s = 0.4f; /* A slanted dip ends the hint. */
    poi->angles.pitch_rad = -0.5f;
    hint_after(1);
    poi->splash_m_s = 0.0f;
    assert_int_equal(hint_after(240), HINT_NONE);
}

static void test_useless_paper_is_named_at_once_in_every_mode(void **state)
{
    (void)state;
    core.game.mode = MODE_CHAMPIONSHIP;
    core.game.player[0].out = 1;
    core.game.player[0].torn_tick = core.game.tick;
    assert_int_equal(hint_after(13), HINT_TORN);
    assert_int_equal(hint_after(620), HINT_NONE); /* The hint must disappear after some seconds. */
}

static void test_a_bot_gets_no_hint_about_useless_paper(void **state)
{
    (void)state;
    core.world.poi[0].link = POI_SOURCE_BOT;
    core.game.player[0].out = 1;
    core.game.player[0].torn_tick = core.game.tick;
    assert_int_equal(hint_after(13), HINT_NONE);
}

static void test_a_championship_gives_no_advice(void **state)
{
    (void)state;
    core.game.mode = MODE_CHAMPIONSHIP;
    core.world.poi[0].strain.cells_torn = 1;
    core.world.poi[0].velocity_m_s = v3(0.2f, 0.0f, 0.0f);
    core.world.poi[0].dips = 5;
    assert_int_equal(hint_after(900), HINT_NONE);
}

static void test_each_player_has_an_own_hint(void **state)
{
    (void)state;
    core.world.poi[1].link = POI_SOURCE_LIVE;
    core.world.poi[1].dips = 3;
    core.lessons.player[1].hints.learned = 1u << HINT_MOVE | 1u << HINT_DIP;
    assert_int_equal(hint_after(500), HINT_DIP);
    assert_int_equal(lesson_after(0, 1)->hint, HINT_GLIDE);
}

static void test_hints_of_the_whole_screen_are_not_beside_the_poi(void **state)
{
    (void)state;
    core.game.paused = 1;
    assert_int_equal(hint_after(600), HINT_NONE);
    core.game.hints.shown = HINT_LOST_POI;
    assert_int_equal(lesson_screen_hint(&core.game), HINT_LOST_POI);
    core.game.hints.shown = HINT_GLIDE;
    assert_int_equal(lesson_screen_hint(&core.game), HINT_NONE);
    core.game.phase = PHASE_RESULT;
    core.game.hints.shown = HINT_START;
    assert_int_equal(lesson_screen_hint(&core.game), HINT_START);
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
        TEST(test_the_ghost_dips_beside_a_fish_glides_under_it_and_carries_it_to_the_bowl),
        TEST(test_a_dip_ends_the_ghost),
        TEST(test_a_dip_in_ready_which_moves_no_poi_ends_the_ghost),
        TEST(test_the_dip_that_begins_the_game_does_not_end_the_ghost),
        TEST(test_only_the_first_round_after_attract_mode_has_a_ghost),
        TEST(test_a_championship_and_a_bot_have_no_ghost),
        TEST(test_the_bots_dips_before_the_game_do_not_end_the_ghost),
        TEST(test_the_ghost_of_a_player_without_a_controller_is_hidden),
        TEST(test_the_ghost_waits_during_a_pause_and_hides_the_ring),
        TEST(test_the_hint_to_dip_waits_for_four_seconds),
        TEST(test_the_hint_to_dip_also_follows_a_poi_that_does_not_move),
        TEST(test_the_hint_to_glide_follows_two_dips_without_a_catch_and_ends),
        TEST(test_the_hint_to_lift_needs_a_long_dip_and_a_fish_over_the_paper),
        TEST(test_the_hint_about_the_bowl_follows_a_fish_that_stays_on_the_paper),
        TEST(test_the_hint_about_haste_follows_motion_that_tears),
        TEST(test_the_hint_about_haste_appears_whenever_its_fault_occurs),
        TEST(test_damage_alone_is_no_haste),
        TEST(test_a_new_game_resets_the_lesson_but_not_the_ghost),
        TEST(test_a_player_who_leaves_takes_the_lesson_along),
        TEST(test_only_a_player_who_may_dip_makes_faults),
        TEST(test_the_hint_to_tilt_follows_two_flat_dips),
        TEST(test_useless_paper_is_named_at_once_in_every_mode),
        TEST(test_a_bot_gets_no_hint_about_useless_paper),
        TEST(test_a_championship_gives_no_advice),
        TEST(test_each_player_has_an_own_hint),
        TEST(test_hints_of_the_whole_screen_are_not_beside_the_poi),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
