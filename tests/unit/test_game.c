/* test_game.c -- the phases of the stall, each edge on both sides, and what a round leaves behind.
 *
 * Most tests tick the game alone, with a still tank: its clock and rules are what is tested. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/core.h"
#include "core/game/hand.h"
#include "core/game/paper.h"

#define ROUND_S 20u
#define ABOVE_M 0.06f
#define BELOW_M (-0.05f)

static struct core core;
static struct input input;
static struct output output;
static uint32_t sounds[SOUND_COUNT]; /* Heard since the last clear_sounds(). */

static void clear_sounds(void)
{
    memset(sounds, 0, sizeof sounds);
}

/* One tick of the game alone; edges are in one tick only. */
static void step(void)
{
    struct poi_target targets[POI_MAX];
    uint8_t live[POI_MAX];
    const struct catch_result caught[POI_MAX] = { 0 };
    output.sound_count = 0;
    game_tick(&core, &input, &output, targets, live);
    game_score(&core, caught, &output);
    core.tick++;
    input.pressed = 0;
    for (uint32_t i = 0; i < output.sound_count; i++) {
        sounds[output.sounds[i].sound]++;
    }
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        step();
    }
}

static void press(uint32_t buttons)
{
    input.pressed = buttons;
    step();
}

static void hold_at(float y_m)
{
    input.poi[0].link = POI_LINK_LIVE;
    input.poi[0].target.position_m = v3(0.05f, y_m, 0.02f);
}

static void dip(void)
{
    hold_at(ABOVE_M);
    step();
    hold_at(BELOW_M);
    step();
}

static int setup(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 7, .fish_count = 12, .round_s = ROUND_S, .best_today = { 2 }
    };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    clear_sounds();
    return 0;
}

static void start_with_a_hand(void)
{
    hold_at(ABOVE_M);
    step();
    press(INPUT_START);
}

/* Into the first tick of the round. */
static void play_into_round(void)
{
    start_with_a_hand();
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

/* Into the first tick of the result. */
static void play_into_result(void)
{
    play_into_round();
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void tear_all(uint32_t index)
{
    struct sheet *sheet = &core.poi[index].sheet;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        if (sheet->state[i] == CELL_PAPER) {
            sheet->state[i] = CELL_HOLE;
        }
    }
    sheet->paper_cells = 0;
}

/* ---- Phases --------------------------------------------------------------------------------- */

static void test_the_stall_begins_in_attract_and_stays_there_alone(void **state)
{
    (void)state;
    steps(3000);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(core.game.round_count, 0);
}

static void test_start_begins_one_round_in_the_tick_that_sees_it(void **state)
{
    (void)state;
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
    steps(10);
    assert_int_equal(core.game.round_count, 1);
    assert_int_equal(sounds[SOUND_START], 1);
}

static void test_other_buttons_begin_nothing(void **state)
{
    (void)state;
    press(INPUT_BUTTON_ALL & ~(uint32_t)INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_start_within_a_round_is_not_heard(void **state)
{
    (void)state;
    play_into_round();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(core.game.round_count, 1);
}

static void test_a_dip_of_a_live_poi_starts_a_round(void **state)
{
    (void)state;
    dip();
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_a_hand_that_appears_below_the_water_does_not_dip(void **state)
{
    (void)state;
    hold_at(BELOW_M);
    steps(100);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_a_hand_just_above_the_dip_line_does_not_dip(void **state)
{
    (void)state;
    hold_at(ABOVE_M);
    step();
    hold_at(GAME_DIP_Y_M + 0.0001f);
    step();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    hold_at(GAME_DIP_Y_M - 0.0001f);
    step();
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_the_dip_of_a_bot_or_of_a_poi_without_a_bowl_starts_nothing(void **state)
{
    (void)state;
    dip();
    setup(state);
    hold_at(ABOVE_M);
    input.poi[1] = input.poi[0];
    input.poi[0].link = POI_LINK_BOT;
    step();
    input.poi[0].target.position_m.y = BELOW_M;
    input.poi[1].target.position_m.y = BELOW_M;
    step();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_ready_lasts_three_seconds_to_the_tick(void **state)
{
    (void)state;
    start_with_a_hand();
    steps(GAME_READY_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_READY);
    step();
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

static void test_a_round_lasts_its_seconds_to_the_tick(void **state)
{
    (void)state;
    play_into_round();
    steps(ROUND_S * CORE_TICK_HZ - 1u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(output.record.end_tick - output.record.start_tick, ROUND_S * CORE_TICK_HZ);
}

/* When time is called a fish on the paper may still be carried home, but not for ever. */
static void test_a_fish_on_the_paper_at_the_call_gets_three_seconds_to_the_bowl(void **state)
{
    (void)state;
    play_into_round();
    core.poi[0].rider_count = 1;
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    steps(GAME_CARRY_TICKS - 1);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(core.poi[0].rider_count, 0);
}

static void test_the_round_ends_as_soon_as_the_last_fish_is_home(void **state)
{
    (void)state;
    play_into_round();
    core.poi[0].rider_count = 1;
    steps(ROUND_S * CORE_TICK_HZ + 10);
    core.poi[0].rider_count = 0;
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_nothing_can_be_dipped_after_the_call(void **state)
{
    (void)state;
    struct poi_target targets[POI_MAX];
    uint8_t live[POI_MAX];
    play_into_round();
    hold_at(BELOW_M);
    core.poi[0].rider_count = 1;
    steps(ROUND_S * CORE_TICK_HZ + 2);
    game_tick(&core, &input, &output, targets, live);
    assert_true(live[0]);
    assert_true(targets[0].position_m.y > 0.0f);
}

static void test_the_result_gives_way_to_attract_after_twelve_seconds(void **state)
{
    (void)state;
    play_into_result();
    steps(GAME_RESULT_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    step();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_start_in_the_result_counts_from_one_and_a_half_seconds(void **state)
{
    (void)state;
    play_into_result();
    steps(GAME_AGAIN_TICKS - 2u);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(core.game.round_count, 2);
}

static void test_a_dip_in_the_result_counts_from_two_and_a_half_seconds(void **state)
{
    (void)state;
    play_into_result();
    steps(GAME_AGAIN_DIP_TICKS - 3u);
    dip(); /* one tick too early */
    assert_int_equal(core.game.phase, PHASE_RESULT);
    dip();
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_seconds_left_count_down_through_ready_and_round(void **state)
{
    (void)state;
    assert_float_equal(game_seconds_left(&core.game, core.tick), 0.0f, 0.0f);
    start_with_a_hand();
    assert_float_equal(game_seconds_left(&core.game, core.tick), 3.0f, 0.01f);
    steps(GAME_READY_TICKS);
    assert_float_equal(game_seconds_left(&core.game, core.tick), (float)ROUND_S, 0.01f);
    steps(ROUND_S * CORE_TICK_HZ - 1u);
    assert_float_equal(game_seconds_left(&core.game, core.tick), 0.0f, 0.01f);
}

static void test_each_of_the_last_five_seconds_ticks_once(void **state)
{
    (void)state;
    play_into_round();
    clear_sounds();
    steps((ROUND_S - 5u) * CORE_TICK_HZ - 1u);
    assert_int_equal(sounds[SOUND_TICK], 0);
    step();
    assert_int_equal(sounds[SOUND_TICK], 1);
    steps(5u * CORE_TICK_HZ);
    assert_int_equal(sounds[SOUND_TICK], 5);
    assert_int_equal(sounds[SOUND_RESULT], 1);
}

/* ---- Controllers ---------------------------------------------------------------------------- */

static void test_the_clock_waits_while_the_poi_is_lost(void **state)
{
    (void)state;
    play_into_round();
    steps(100);
    const float before_s = game_seconds_left(&core.game, core.tick);
    input.poi[0].link = POI_LINK_LOST;
    steps(1000);
    assert_float_equal(game_seconds_left(&core.game, core.tick), before_s, 0.001f);
    assert_int_equal(core.game.hints.shown, HINT_LOST_POI);
    hold_at(ABOVE_M);
    steps(TRUST_AGREE_TICKS - 1u);
    assert_float_equal(game_seconds_left(&core.game, core.tick), before_s, 0.001f);
    steps(120);
    assert_float_equal(game_seconds_left(&core.game, core.tick), before_s - 1.0f, 0.001f);
}

static void test_a_round_that_nobody_comes_back_to_ends(void **state)
{
    (void)state;
    play_into_round();
    input.poi[0].link = POI_LINK_LOST;
    steps(GAME_LOST_TICKS_MAX);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    step();
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_a_new_hand_draws_the_poi_over_without_a_jump(void **state)
{
    (void)state;
    steps(200); /* the bot moves it about */
    input.poi[0].link = POI_LINK_LIVE;
    input.poi[0].target.position_m = v3(0.20f, 0.08f, 0.10f);
    press(INPUT_START);
    vec3 last = core.game.hand[0].position_m;
    for (uint32_t i = 0; i < 160; i++) {
        step();
        const vec3 now = core.game.hand[0].position_m;
        assert_true(v3_length(v3_sub(now, last)) < 0.012f); /* 1.4 m/s at most */
        last = now;
    }
    assert_float_equal(last.x, 0.20f, 0.0f); /* then it follows at once */
    assert_float_equal(last.z, 0.10f, 0.0f);
}

static void test_nothing_can_be_dipped_before_the_round(void **state)
{
    (void)state;
    dip();
    for (uint32_t i = 0; i < GAME_READY_TICKS - 1u; i++) {
        step();
        assert_true(core.game.hand[0].position_m.y > 0.0f || i < 60u);
    }
    step();
    float last_m = core.game.hand[0].position_m.y;
    for (uint32_t i = 0; i < 150u; i++) { /* and then it is led down, not dropped */
        step();
        assert_true(last_m - core.game.hand[0].position_m.y < 0.004f);
        last_m = core.game.hand[0].position_m.y;
    }
    assert_float_equal(last_m, BELOW_M, 0.0f);
}

static void test_a_hand_beyond_reach_is_brought_back(void **state)
{
    (void)state;
    play_into_round();
    input.poi[0].target.position_m = v3(90.0f, -90.0f, -90.0f);
    steps(400);
    const vec3 hand = core.game.hand[0].position_m;
    assert_true(hand.x < core.tank.size_m.x);
    assert_float_equal(hand.y, -core.tank.size_m.y, 0.0f);
    assert_true(hand.z > -core.tank.size_m.z);
}

static void test_any_hand_is_brought_within_reach(void **state)
{
    (void)state;
    static const float wild[] = { 1e9f, -3e38f, 1.0f / 0.0f, 99.0f, -100.0f, 101.0f, 999.0f, 0.0f };
    play_into_round();
    for (size_t i = 0; i < sizeof wild / sizeof wild[0]; i++) {
        input.poi[0].target.position_m = v3(wild[i], wild[(i + 1) % 8], wild[(i + 2) % 8]);
        input.poi[0].target.angles = (struct angles){ wild[i], wild[(i + 3) % 8], -wild[i] };
        for (uint32_t tick = 0; tick < 400; tick++) { /* past the gentle change of hands */
            core_tick(&core, &input, &output);
        }
        const struct angles hand = core.game.hand[0].angles;
        assert_true(f_abs(hand.yaw_rad) < 3.15f);
        assert_true(f_abs(hand.pitch_rad) < 3.15f);
        assert_true(f_abs(hand.roll_rad) < 3.15f);
        assert_true(v3_is_finite(core.poi[0].position_m));
    }
    input.poi[0].target = (struct poi_target){ .angles = { -F_TAU, F_TAU + 0.5f, 0.0f } };
    steps(400);
    assert_float_equal(core.game.hand[0].angles.yaw_rad, 0.0f, 1e-5f);
    assert_float_equal(core.game.hand[0].angles.pitch_rad, 0.5f, 1e-5f);
}

static void test_a_hand_turns_over_the_short_way_round(void **state)
{
    (void)state;
    input.poi[0].target.angles.yaw_rad = -3.1f;
    play_into_round();
    core.game.hand[0].angles.yaw_rad = 3.1f;
    core.game.grip_tick[0] = core.tick;
    for (uint32_t i = 0; i < 160; i++) {
        step();
        assert_true(f_abs(core.game.hand[0].angles.yaw_rad) > 3.0f);
    }
    assert_float_equal(core.game.hand[0].angles.yaw_rad, -3.1f, 1e-5f);
}

static void test_only_a_poi_with_a_bowl_is_there(void **state)
{
    (void)state;
    static struct scene scene;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        input.poi[i].link = POI_LINK_LIVE;
        input.poi[i].target.position_m = v3(0.0f, 0.06f, 0.0f);
    }
    press(INPUT_START);
    core_scene(&core, &scene);
    assert_true(scene.poi[0].present);
    for (uint32_t i = 1; i < POI_MAX; i++) {
        assert_false(scene.poi[i].present);
    }
}

static void test_torn_paper_stays_in_sight_when_the_controller_comes_back(void **state)
{
    (void)state;
    play_into_round();
    tear_all(0);
    steps(GAME_GONE_TICKS / 2u);
    input.poi[0].link = POI_LINK_LOST;
    steps(2u * GAME_GONE_TICKS);
    hold_at(ABOVE_M);
    steps(TRUST_AGREE_TICKS - 1u + GAME_GONE_TICKS / 2u - 1u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    steps(3);
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_a_hand_that_is_no_number_is_a_lost_hand(void **state)
{
    (void)state;
    play_into_round();
    const float before_s = game_seconds_left(&core.game, core.tick);
    input.poi[0].target.position_m.x = 1.0f / 0.0f;
    steps(100);
    assert_true(hand_is_lost(&core, 0));
    assert_float_equal(game_seconds_left(&core.game, core.tick), before_s, 0.001f);
}

static void test_in_attract_the_bot_has_the_poi_whatever_is_linked(void **state)
{
    (void)state;
    hold_at(ABOVE_M);
    steps(5);
    assert_int_equal(core.poi[0].link, POI_LINK_BOT);
    assert_int_equal(core.poi[1].link, POI_LINK_ABSENT);
}

static void test_language_changes_with_each_press_in_any_phase(void **state)
{
    (void)state;
    assert_int_equal(core.game.language, LANGUAGE_JA);
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    steps(3);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    play_into_round();
    press(INPUT_LANGUAGE);
    assert_int_equal(core.game.language, LANGUAGE_JA);
}

static void test_the_start_lamp_blinks_only_where_start_would_be_heard(void **state)
{
    (void)state;
    uint32_t lit = 0;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        step();
        lit += output.start_lamp;
    }
    assert_int_equal(lit, CORE_TICK_HZ / 2u);
    start_with_a_hand();
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        step();
        assert_int_equal(output.start_lamp, 0);
    }
}

/* ---- Paper ---------------------------------------------------------------------------------- */

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

static void test_each_round_hands_out_fresh_and_different_paper(void **state)
{
    (void)state;
    play_into_round();
    static struct sheet first;
    first = core.poi[0].sheet;
    assert_int_equal(first.paper_cells, first.paper_cells_new);
    tear_all(0);
    steps(GAME_GONE_TICKS + 1u + GAME_AGAIN_TICKS);
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    assert_int_equal(core.poi[0].sheet.paper_cells, first.paper_cells);
    assert_memory_not_equal(core.poi[0].sheet.strength, first.strength, sizeof first.strength);
}

static void test_a_poi_under_water_gets_its_paper_when_it_is_clear(void **state)
{
    (void)state;
    core.poi[0].immersed = 1.0f;
    start_with_a_hand();
    steps(30);
    assert_int_equal(core.game.player[0].handed, 0);
    core.poi[0].immersed = 0.0f;
    step();
    assert_int_equal(core.game.player[0].handed, 1);
}

static void test_the_attract_bot_gets_new_paper_when_its_own_is_gone(void **state)
{
    (void)state;
    steps(10);
    tear_all(0);
    steps(2u * CORE_TICK_HZ);
    assert_int_equal(core.poi[0].sheet.paper_cells, 0);
    steps(2);
    assert_int_equal(core.poi[0].sheet.paper_cells, core.poi[0].sheet.paper_cells_new);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* Poured out, the first `count` fish swim within half a second, however many they come down upon.
 */
static void expect_all_to_swim_soon(uint32_t count)
{
    uint8_t swam[16] = { 0 };
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u; tick++) {
        core_tick(&core, &input, &output);
        for (uint32_t i = 0; i < count; i++) {
            swam[i] |= core.tank.fish[i].gait < GAIT_HELD;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        assert_true(swam[i]);
    }
}

static void test_the_attract_bot_pours_a_full_bowl_back(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 9; i++) {
        core.tank.fish[i].gait = GAIT_BOWL;
    }
    core.bowl[0].fish_count = 9;
    steps(3u * CORE_TICK_HZ);
    assert_int_equal(core.bowl[0].fish_count, 9);
    core.tank.fish[9].gait = GAIT_BOWL;
    core.bowl[0].fish_count = 10;
    core.poi[0].rider_count = 1; /* not while it carries one more */
    steps(3u * CORE_TICK_HZ);
    assert_int_equal(core.bowl[0].fish_count, 10);
    core.poi[0].rider_count = 0;
    step();
    assert_int_equal(core.bowl[0].fish_count, 0);
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

static void test_paper_with_a_hole_in_the_middle_still_holds_beside_it(void **state)
{
    (void)state;
    struct sheet *sheet = &core.poi[0].sheet;
    assert_true(paper_can_hold(sheet));
    punch(sheet, 0.0f, 0.0f, 0.012f);
    assert_true(paper_can_hold(sheet));
    punch(sheet, 0.0f, 0.0f, 0.026f); /* a fringe of 14 mm is narrower than a fish needs */
    assert_true(sheet_left(sheet) > PAPER_LEFT_MIN);
    assert_false(paper_can_hold(sheet));
}

/* ---- What a round leaves -------------------------------------------------------------------- */

static void land(uint32_t count)
{
    const struct catch_result caught[POI_MAX] = { { .landed = count } };
    game_score(&core, caught, &output);
}

static void test_fish_count_only_while_the_round_runs(void **state)
{
    (void)state;
    land(3);
    assert_int_equal(core.game.player[0].caught, 0);
    start_with_a_hand();
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

static void test_a_round_leaves_a_record_with_the_next_id(void **state)
{
    (void)state;
    play_into_round();
    land(4);
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(output.record.id, 1);
    assert_int_equal(output.record.seed, 7);
    assert_int_equal(output.record.caught, 4);
    assert_int_equal(output.record.by_bot, 0);
    assert_int_equal(core.game.best_today[MODE_FESTIVAL], 4);
    steps(GAME_AGAIN_TICKS);
    press(INPUT_START);
    steps(GAME_READY_TICKS + ROUND_S * CORE_TICK_HZ);
    assert_int_equal(output.record.id, 2);
    assert_int_equal(output.record.caught, 0);
    assert_int_equal(core.game.best_today[MODE_FESTIVAL], 4); /* a worse round takes nothing away */
}

static void test_record_ids_go_on_from_what_the_store_has(void **state)
{
    (void)state;
    input.record_saved_id = 41;
    play_into_result();
    assert_int_equal(output.record.id, 42);
}

static void test_a_bots_round_is_marked_and_is_no_best(void **state)
{
    (void)state;
    input.poi[0].link = POI_LINK_BOT;
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    land(9);
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(output.record.by_bot, 1);
    assert_int_equal(output.record.caught, 9);
    assert_int_equal(core.game.best_today[MODE_FESTIVAL], 2);
}

static void test_the_best_of_the_day_is_a_round_that_beats_it(void **state)
{
    (void)state;
    play_into_round();
    land(2);
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.best_today[MODE_FESTIVAL], 2);
}

static void test_a_start_pours_the_bowl_back_and_frees_the_fish_on_the_paper(void **state)
{
    (void)state;
    core.tank.fish[0].gait = GAIT_BOWL;
    core.bowl[0].fish_count = 1;
    core.tank.fish[1].gait = GAIT_HELD;
    core.tank.fish[1].holder = 0;
    core.tank.fish[1].position_m = core.poi[0].position_m;
    core.poi[0].riders[0].fish = 1;
    core.poi[0].rider_count = 1;
    hold_at(ABOVE_M);
    input.pressed = INPUT_START;
    core_tick(&core, &input, &output);
    input.pressed = 0;
    float last_m = core.tank.fish[1].position_m.y;
    assert_true(last_m > 0.03f);
    for (uint32_t i = 0; i < 60; i++) { /* It falls; it is not under water at once. */
        core_tick(&core, &input, &output);
        assert_true(f_abs(core.tank.fish[1].position_m.y - last_m) < 0.015f);
        last_m = core.tank.fish[1].position_m.y;
    }
    assert_int_equal(core.bowl[0].fish_count, 0);
    assert_true(core.tank.fish[0].gait < GAIT_HELD);
    assert_true(core.tank.fish[1].gait < GAIT_HELD);
    assert_true(core.tank.fish[1].position_m.y < 0.0f);
}

static void test_a_fish_that_falls_into_the_bowl_before_the_round_is_poured_back(void **state)
{
    (void)state;
    start_with_a_hand();
    steps(100);
    core.tank.fish[3].gait = GAIT_BOWL;
    core.bowl[0].fish_count = 1;
    steps(GAME_READY_TICKS - 100u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(core.bowl[0].fish_count, 0);
    expect_all_to_swim_soon(4);
}

static void hold_a_fish(uint32_t fish, float y_m)
{
    core.tank.fish[fish].gait = GAIT_HELD;
    core.tank.fish[fish].holder = 0;
    core.tank.fish[fish].position_m = v3(0.0f, y_m, 0.0f);
    core.tank.fish[fish].velocity_m_s = v3(0.0f, 0.0f, 0.0f);
}

static void test_a_fish_on_a_poi_whose_controller_is_taken_away_falls_into_the_water(void **state)
{
    (void)state;
    play_into_round();
    hold_a_fish(1, 0.05f);
    core.poi[0].riders[0] = (struct rider){ .fish = 1 };
    core.poi[0].rider_count = 1;
    hold_a_fish(2, 0.05f); /* held, and nobody's rider */
    input.poi[0].link = POI_LINK_ABSENT;
    core_tick(&core, &input, &output);
    assert_true(core.tank.fish[1].position_m.y > 0.045f);
    for (uint32_t i = 0; i < 30; i++) {
        core_tick(&core, &input, &output);
    }
    assert_int_equal(core.poi[0].rider_count, 0);
    assert_true(core.tank.fish[1].gait < GAIT_HELD);
    assert_true(core.tank.fish[2].gait < GAIT_HELD);
    assert_true(core.tank.fish[1].position_m.y < 0.0f);
}

static void test_a_round_that_nobody_played_ends_without_a_record(void **state)
{
    (void)state;
    press(INPUT_START); /* no controller at all */
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    const float before_s = game_seconds_left(&core.game, core.tick);
    steps(GAME_LOST_TICKS_MAX - 2u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_float_equal(game_seconds_left(&core.game, core.tick), before_s, 0.001f);
    steps(4);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(output.record.id, 0);
    assert_int_equal(core.game.record_id, 0);
}

static void test_a_round_that_was_left_after_a_while_keeps_its_record(void **state)
{
    (void)state;
    play_into_round();
    step();
    land(3);
    input.poi[0].link = POI_LINK_ABSENT;
    steps(GAME_LOST_TICKS_MAX + 1u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(output.record.caught, 3);
}

/* ---- Seeds ---------------------------------------------------------------------------------- */

static void test_the_bots_first_luck_differs_between_seeds(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 8, .fish_count = 12 };
    const uint32_t first = core.poi[0].seed;
    const uint32_t beside = core.poi[1].seed;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_true((core.poi[0].seed ^ 8u) != (first ^ 7u));
    assert_true(core.poi[0].seed != beside);
    assert_int_equal(core.poi[0].seed, game_poi_seed(8, 0, 0, GAME_SERIES_ROUND));
    assert_true(game_poi_seed(8, 0, 0, GAME_SERIES_ROUND) !=
                game_poi_seed(8, 0, 0, GAME_SERIES_ATTRACT));
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_the_stall_begins_in_attract_and_stays_there_alone),
        TEST(test_start_begins_one_round_in_the_tick_that_sees_it),
        TEST(test_other_buttons_begin_nothing),
        TEST(test_start_within_a_round_is_not_heard),
        TEST(test_a_dip_of_a_live_poi_starts_a_round),
        TEST(test_a_hand_that_appears_below_the_water_does_not_dip),
        TEST(test_a_hand_just_above_the_dip_line_does_not_dip),
        TEST(test_the_dip_of_a_bot_or_of_a_poi_without_a_bowl_starts_nothing),
        TEST(test_ready_lasts_three_seconds_to_the_tick),
        TEST(test_a_round_lasts_its_seconds_to_the_tick),
        TEST(test_a_fish_on_the_paper_at_the_call_gets_three_seconds_to_the_bowl),
        TEST(test_the_round_ends_as_soon_as_the_last_fish_is_home),
        TEST(test_nothing_can_be_dipped_after_the_call),
        TEST(test_the_result_gives_way_to_attract_after_twelve_seconds),
        TEST(test_start_in_the_result_counts_from_one_and_a_half_seconds),
        TEST(test_a_dip_in_the_result_counts_from_two_and_a_half_seconds),
        TEST(test_seconds_left_count_down_through_ready_and_round),
        TEST(test_each_of_the_last_five_seconds_ticks_once),
        TEST(test_the_clock_waits_while_the_poi_is_lost),
        TEST(test_a_round_that_nobody_comes_back_to_ends),
        TEST(test_a_new_hand_draws_the_poi_over_without_a_jump),
        TEST(test_nothing_can_be_dipped_before_the_round),
        TEST(test_a_hand_beyond_reach_is_brought_back),
        TEST(test_a_hand_that_is_no_number_is_a_lost_hand),
        TEST(test_in_attract_the_bot_has_the_poi_whatever_is_linked),
        TEST(test_language_changes_with_each_press_in_any_phase),
        TEST(test_the_start_lamp_blinks_only_where_start_would_be_heard),
        TEST(test_a_round_with_no_paper_left_ends_three_seconds_later),
        TEST(test_each_round_hands_out_fresh_and_different_paper),
        TEST(test_a_poi_under_water_gets_its_paper_when_it_is_clear),
        TEST(test_the_attract_bot_gets_new_paper_when_its_own_is_gone),
        TEST(test_the_attract_bot_pours_a_full_bowl_back),
        TEST(test_paper_with_a_hole_in_the_middle_still_holds_beside_it),
        TEST(test_fish_count_only_while_the_round_runs),
        TEST(test_a_round_leaves_a_record_with_the_next_id),
        TEST(test_record_ids_go_on_from_what_the_store_has),
        TEST(test_a_bots_round_is_marked_and_is_no_best),
        TEST(test_the_best_of_the_day_is_a_round_that_beats_it),
        TEST(test_a_start_pours_the_bowl_back_and_frees_the_fish_on_the_paper),
        TEST(test_a_fish_that_falls_into_the_bowl_before_the_round_is_poured_back),
        TEST(test_a_fish_on_a_poi_whose_controller_is_taken_away_falls_into_the_water),
        TEST(test_a_round_that_nobody_played_ends_without_a_record),
        TEST(test_a_round_that_was_left_after_a_while_keeps_its_record),
        TEST(test_the_bots_first_luck_differs_between_seeds),
        TEST(test_any_hand_is_brought_within_reach),
        TEST(test_a_hand_turns_over_the_short_way_round),
        TEST(test_only_a_poi_with_a_bowl_is_there),
        TEST(test_torn_paper_stays_in_sight_when_the_controller_comes_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
