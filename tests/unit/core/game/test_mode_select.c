/* test_mode_select.c -- a stall that offers several modes: pointing, taking, and the tank that a
 * mode is played in. */
#include "tests/unit/support/stall_stand.h"
#include "core/game/table_setup.h"

#define ALL_MODES ((1u << MODE_COUNT) - 1u)
#define LEFT_M (-0.35f)
#define RIGHT_M 0.35f

static int offer_all(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = ALL_MODES };
    open_stall(&config);
    return 0;
}

static void choose(void)
{
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    ticks(GAME_MODE_SELECT_TICKS_MIN);
}

static void take(uint8_t mode)
{
    choose();
    while (look()->mode != mode) {
        press(INPUT_RIGHT);
    }
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_one_mode_alone_is_not_asked_for(void **state)
{
    (void)state;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        const struct core_config config = { .seed = 5,
                                            .fish_count = 12,
                                            .modes = (uint8_t)(1u << mode) };
        open_stall(&config);
        press(INPUT_START);
        assert_int_equal(core.game.phase, PHASE_READY);
        assert_int_equal(look()->mode, mode);
    }
}

static void test_left_and_right_go_round_and_start_takes_one(void **state)
{
    (void)state;
    choose();
    assert_int_equal(look()->modes, ALL_MODES);
    assert_int_equal(look()->mode, MODE_FESTIVAL);
    press(INPUT_RIGHT);
    assert_int_equal(look()->mode, MODE_CHAMPIONSHIP);
    press(INPUT_RIGHT);
    press(INPUT_RIGHT);
    assert_int_equal(look()->mode, MODE_FESTIVAL);
    press(INPUT_LEFT);
    assert_int_equal(look()->mode, MODE_PRACTICE);
    assert_int_equal(sounds[SOUND_CHOOSE], 5); /* One as it opens, one for each. */
    press(INPUT_OK);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(look()->mode, MODE_PRACTICE);
}

static void test_modes_that_are_not_offered_are_passed_over(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12,
                                        .modes = 1u << MODE_FESTIVAL | 1u << MODE_PRACTICE };
    open_stall(&config);
    choose();
    press(INPUT_RIGHT);
    assert_int_equal(look()->mode, MODE_PRACTICE);
    press(INPUT_RIGHT);
    assert_int_equal(look()->mode, MODE_FESTIVAL);
}

static void test_a_hand_points_at_the_share_of_the_tank_that_it_is_over(void **state)
{
    (void)state;
    hold(0, v3(RIGHT_M, STAND_ABOVE_M, 0.0f));
    choose();
    assert_int_equal(look()->mode, MODE_PRACTICE);
    lead(0, v3(0.0f, STAND_ABOVE_M, 0.0f));
    assert_int_equal(look()->mode, MODE_CHAMPIONSHIP);
    lead(0, v3(-0.6f, STAND_ABOVE_M, 0.0f));
    assert_int_equal(look()->mode, MODE_FESTIVAL);
    press(INPUT_RIGHT); /* A hand that rests leaves the buttons their way. */
    ticks(60);
    assert_int_equal(look()->mode, MODE_CHAMPIONSHIP);
}

static void test_a_dip_takes_the_mode_where_it_dips(void **state)
{
    (void)state;
    choose();
    dip(0, RIGHT_M, 0.0f);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(look()->mode, MODE_PRACTICE);
    offer_all(state);
    choose();
    dip(0, LEFT_M, 0.0f);
    assert_int_equal(look()->mode, MODE_FESTIVAL);
}

static void test_the_press_that_opens_the_choice_takes_nothing(void **state)
{
    (void)state;
    press(INPUT_START);
    press(INPUT_START);
    ticks(GAME_MODE_SELECT_TICKS_MIN - 3u);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_fifteen_seconds_without_pointing_end_the_choice(void **state)
{
    (void)state;
    choose();
    press(INPUT_RIGHT);
    assert_float_equal(look()->seconds_left, 15.0f, 0.02f);
    ticks(GAME_MODE_SELECT_TICKS - 2u);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_float_equal(look()->seconds_left, 0.0f, 0.02f);
    ticks(2);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_a_hand_that_moves_about_is_somebody_who_chooses(void **state)
{
    (void)state;
    hold(0, v3(LEFT_M, STAND_ABOVE_M, 0.0f));
    choose();
    for (uint32_t i = 0; i < 5; i++) {
        ticks(GAME_MODE_SELECT_TICKS - CORE_TICK_HZ);
        lead(0, v3(LEFT_M, STAND_ABOVE_M, i % 2u ? 0.0f : 0.1f));
        assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    }
    ticks(GAME_MODE_SELECT_TICKS + 1u); /* One that rests is a poi that lies there. */
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* A poi on its cord swings past the stall's edge for ever. */
static void test_no_choice_lasts_longer_than_two_minutes(void **state)
{
    (void)state;
    hold(0, v3(LEFT_M, STAND_ABOVE_M, 0.0f));
    choose();
    const uint32_t begin_tick = core.game.phase_tick;
    while (core.game.phase == PHASE_MODE_SELECT &&
           core.game.tick - begin_tick <= GAME_MODE_SELECT_TICKS_MAX) {
        lead(0, v3(LEFT_M, STAND_ABOVE_M, core.game.tick % 2u ? 0.0f : 0.1f));
        press(core.game.tick % 3u ? 0 : INPUT_RIGHT);
        assert_true(look()->seconds_left <= 15.0f);
    }
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_in_range(core.game.phase_tick - begin_tick, 120u * CORE_TICK_HZ,
                    120u * CORE_TICK_HZ + 1u);
}

/* Away while the player chooses, back elsewhere: the poi is on its way to the hand as it opens. */
static void test_in_a_tank_that_opens_nobodys_poi_is_still_led_back(void **state)
{
    (void)state;
    hold(0, v3(0.0f, STAND_ABOVE_M, 0.0f));
    choose();
    input.poi[0].link = POI_SOURCE_LOST;
    ticks(60);
    hold(0, v3(0.0f, STAND_ABOVE_M, 0.2f));
    for (uint32_t i = 0; i < 120 && core.game.return_ticks[0] < 2u; i++) {
        tick();
    }
    assert_true(core.game.return_ticks[0] > 0);
    assert_int_equal(core.game.mode, MODE_CHAMPIONSHIP); /* It points there. */
    press(INPUT_START);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_OFFICIAL);
    assert_int_equal(core.game.return_ticks[0], 0);
    assert_int_equal(core.world.poi[0].damage_immune, 0);
}

static void test_a_poi_stays_above_the_water_while_somebody_chooses(void **state)
{
    (void)state;
    choose();
    hold(0, v3(RIGHT_M, STAND_BELOW_M, 0.0f)); /* It appears below: no dip. */
    ticks(300);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_true(core.world.poi[0].position_m.y > 0.0f);
    assert_int_equal(core.world.poi[0].dips, 0);
}

static void test_the_championship_has_a_tank_of_its_own_and_attract_has_the_stalls(void **state)
{
    (void)state;
    take(MODE_CHAMPIONSHIP);
    const struct tank_preset *official = tank_preset(TANK_PRESET_OFFICIAL);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_OFFICIAL);
    assert_int_equal(core.world.tank.fish_count, official->fish_count);
    assert_memory_equal(&look()->tank_size_m, &official->size_m, sizeof(vec3));
    assert_float_equal(core.world.bowl[0].position_m.x, official->bowl_m[0].x, 0.02f);
    assert_int_equal(scene.grade, 5);
    assert_float_equal(scene.seconds_left, 5.0f, 0.02f);
    core.game.phase = PHASE_RESULT; /* As if it had been played. */
    core.game.phase_tick = core.game.tick;
    ticks(GAME_RESULT_TICKS + 1u);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_FESTIVAL);
    assert_int_equal(core.world.tank.fish_count, 12);
}

static void test_each_championship_draws_its_tank_anew(void **state)
{
    (void)state;
    take(MODE_CHAMPIONSHIP);
    const uint32_t first = core.world.tank.seed;
    offer_all(state);
    core.game.round_count = 1;
    take(MODE_CHAMPIONSHIP);
    assert_int_not_equal(core.world.tank.seed, first);
}

/* Fish count ticks since their last thought in a byte: those of a tank that opens late have not
 * slept for seconds. */
static void test_fish_of_a_tank_that_opens_late_have_just_thought(void **state)
{
    (void)state;
    ticks(200u - core.game.tick % 256u);
    press(INPUT_START);
    ticks(GAME_MODE_SELECT_TICKS_MIN);
    press(INPUT_RIGHT);
    press(INPUT_START);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_OFFICIAL);
    for (uint32_t i = 0; i < core.world.tank.fish_count; i++) {
        assert_in_range((uint8_t)(core.game.tick - core.world.tank.fish[i].thought_tick), 0, 2);
    }
}

static void test_festival_and_practice_are_played_in_the_stalls_own_tank(void **state)
{
    (void)state;
    const struct core_config config = { .preset = TANK_PRESET_THESIS,
                                        .fish_count = 12,
                                        .modes = ALL_MODES };
    static const uint8_t modes[] = { MODE_FESTIVAL, MODE_PRACTICE };
    for (size_t i = 0; i < sizeof modes; i++) {
        open_stall(&config);
        take(modes[i]);
        assert_int_equal(core.world.tank.preset, TANK_PRESET_THESIS);
        assert_int_equal(core.world.tank.fish_count, 12);
    }
}

static void test_the_paper_is_the_stalls_but_for_the_championships(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12, .modes = ALL_MODES, .grade = 4 };
    static const uint8_t grades[MODE_COUNT] = { 4, 5, 4 };
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        open_stall(&config);
        take(mode);
        ticks(10);
        assert_int_equal(core.world.poi[0].sheet.grade, grades[mode]);
        assert_int_equal(look()->grade, grades[mode]);
    }
}

static void test_a_championship_that_is_offered_alone_takes_the_paper_that_is_named(void **state)
{
    (void)state;
    const uint8_t named[] = { 0, 4, 7 }, played[] = { 5, 4, 7 };
    for (size_t i = 0; i < sizeof named; i++) {
        const struct core_config config = { .preset = TANK_PRESET_OFFICIAL,
                                            .fish_count = 12,
                                            .modes = 1u << MODE_CHAMPIONSHIP,
                                            .grade = named[i] };
        assert_int_equal(table_setup_grade(&config, MODE_CHAMPIONSHIP), played[i]);
        open_stall(&config);
        assert_int_equal(core.world.poi[0].sheet.grade, played[i]);
    }
}

static void test_the_same_presses_choose_and_play_the_same(void **state)
{
    uint64_t hash[2];
    for (uint32_t i = 0; i < 2; i++) {
        offer_all(state);
        take(MODE_CHAMPIONSHIP);
        ticks(60);
        hash[i] = core_hash(&core);
    }
    assert_true(hash[0] == hash[1]);
}

static void test_start_in_the_result_asks_again(void **state)
{
    (void)state;
    take(MODE_PRACTICE);
    core.game.phase = PHASE_RESULT;
    core.game.phase_tick = core.game.tick;
    ticks(GAME_AGAIN_TICKS);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_int_equal(look()->mode, MODE_PRACTICE); /* What was played is pointed at. */
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, offer_all)
    const struct CMUnitTest tests[] = {
        TEST(test_one_mode_alone_is_not_asked_for),
        TEST(test_left_and_right_go_round_and_start_takes_one),
        TEST(test_modes_that_are_not_offered_are_passed_over),
        TEST(test_a_hand_points_at_the_share_of_the_tank_that_it_is_over),
        TEST(test_a_dip_takes_the_mode_where_it_dips),
        TEST(test_the_press_that_opens_the_choice_takes_nothing),
        TEST(test_fifteen_seconds_without_pointing_end_the_choice),
        TEST(test_a_hand_that_moves_about_is_somebody_who_chooses),
        TEST(test_no_choice_lasts_longer_than_two_minutes),
        TEST(test_in_a_tank_that_opens_nobodys_poi_is_still_led_back),
        TEST(test_a_poi_stays_above_the_water_while_somebody_chooses),
        TEST(test_the_championship_has_a_tank_of_its_own_and_attract_has_the_stalls),
        TEST(test_each_championship_draws_its_tank_anew),
        TEST(test_fish_of_a_tank_that_opens_late_have_just_thought),
        TEST(test_festival_and_practice_are_played_in_the_stalls_own_tank),
        TEST(test_the_paper_is_the_stalls_but_for_the_championships),
        TEST(test_a_championship_that_is_offered_alone_takes_the_paper_that_is_named),
        TEST(test_the_same_presses_choose_and_play_the_same),
        TEST(test_start_in_the_result_asks_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
