/* test_mode_select.c -- checks the selection of a mode and of each player's level, and the tank of
 * each mode. */
#include "tests/unit/support/core_fixture.h"
#include "core/game/mode_tags.h"
#include "core/game/table_setup.h"

#define ALL_MODES ((1u << MODE_COUNT) - 1u)
#define LEFT_M (-0.35f)
#define RIGHT_M 0.35f

static int offer_all(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = ALL_MODES };
    open_core(&config);
    return 0;
}

/* Opens a core with `players` bowls that offers all modes and levels. The operator's default is the
 * level `level`. */
static void offer_levels(uint8_t level, uint8_t players)
{
    open_core(&(struct core_config){ .seed = 5,
                                     .fish_count = 12,
                                     .modes = (1u << CHOICE_COUNT) - 1u,
                                     .level = level,
                                     .players = players });
}

/* Returns the position above the water from which a poi points at the tag `tag`. The poi must
 * measure its rotation. */
static vec3 above_tag(uint32_t tag)
{
    const struct layout_box box = mode_tag_box(false, look()->tags, tag);
    const struct layout_point canvas = pointer_layout_size(false);
    const vec3 tank_m = core.world.tank.size_m;
    return v3(tank_m.x * ((box.x + 0.5f * box.width) / canvas.x - 0.5f), ABOVE_M,
              tank_m.z * ((box.y + 0.5f * box.height) / canvas.y - 0.5f));
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

static void test_a_single_mode_needs_no_selection(void **state)
{
    (void)state;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        const struct core_config config = { .seed = 5,
                                            .fish_count = 12,
                                            .modes = (uint8_t)(1u << mode) };
        open_core(&config);
        press(INPUT_START);
        assert_int_equal(core.game.phase, PHASE_READY);
        assert_int_equal(look()->mode, mode);
    }
}

static void test_left_and_right_cycle_and_start_chooses_a_mode(void **state)
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
    /* The selection plays the sound once when it opens, and once for each of its four changes. */
    assert_int_equal(sounds[SOUND_CHOOSE], 5);
    press(INPUT_OK);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(look()->mode, MODE_PRACTICE);
}

static void test_disabled_modes_are_skipped(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12,
                                        .modes = 1u << MODE_FESTIVAL | 1u << MODE_PRACTICE };
    open_core(&config);
    choose();
    press(INPUT_RIGHT);
    assert_int_equal(look()->mode, MODE_PRACTICE);
    press(INPUT_RIGHT);
    assert_int_equal(look()->mode, MODE_FESTIVAL);
}

/* Recordings older than format 9 use other rules, which this test checks. */
static void test_under_the_rules_of_format_8_a_poi_selects_the_mode_of_its_section(void **state)
{
    (void)state;
    open_core(&(struct core_config){ .seed = 5, .fish_count = 12, .modes = ALL_MODES, .rules = 8 });
    hold(0, v3(RIGHT_M, ABOVE_M, 0.0f));
    choose();
    assert_int_equal(look()->mode, MODE_PRACTICE);
    lead(0, v3(0.0f, ABOVE_M, 0.0f));
    assert_int_equal(look()->mode, MODE_CHAMPIONSHIP);
    lead(0, v3(-0.6f, ABOVE_M, 0.0f));
    assert_int_equal(look()->mode, MODE_FESTIVAL);
    /* The poi rests over the tag of FESTIVAL on the left. A button press must have priority over
     * the resting poi. */
    press(INPUT_RIGHT);
    ticks(60);
    assert_int_equal(look()->mode, MODE_CHAMPIONSHIP);
}

static void test_a_moved_poi_selects_the_tag_below_it(void **state)
{
    (void)state;
    offer_levels(LEVEL_NORMAL, 1);
    hold(0, v3(0.0f, ABOVE_M, -0.2f));
    choose();
    assert_int_equal(look()->pointed_tags, 1u << 1);
    for (uint32_t tag = 0; tag < MODE_TAG_COUNT; tag++) {
        lead(0, above_tag(tag));
        assert_int_equal(look()->pointed_tags, 1u << tag);
        assert_int_equal(scene.choice, mode_tags[tag].mode);
        assert_true(scene.player[0].has_pointer);
        assert_true(
            pointer_is_inside(mode_tag_box(false, scene.tags, tag), 0.0f,
                              (struct layout_point){ scene.player[0].x, scene.player[0].y }));
    }
    /* The small tags select only a mode, so the level stays the same. */
    assert_int_equal(core.game.player[0].level, LEVEL_MASTER);
    /* The resting poi does not override this button. */
    press(INPUT_LEFT);
    ticks(60);
    assert_int_equal(look()->choice, MODE_PRACTICE);
}

static void test_a_dip_chooses_the_tag_under_it(void **state)
{
    (void)state;
    for (uint32_t tag = 0; tag < MODE_TAG_COUNT - 1u; tag++) {
        offer_levels(LEVEL_NORMAL, 1);
        hold(0, v3(0.0f, ABOVE_M, -0.2f));
        choose();
        const vec3 at_m = above_tag(tag);
        lead(0, at_m);
        press(INPUT_RIGHT);
        dip(0, at_m.x, at_m.z);
        assert_int_equal(core.game.phase, PHASE_READY);
        assert_int_equal(core.game.mode, mode_tags[tag].mode);
        /* On its way to the small tag the poi has passed over the large tag of LEVEL_MASTER. The
         * selected level must be that of the tag under the poi. */
        assert_int_equal(core.game.player[0].level, mode_tags[tag].level);
    }
}

/* If a finger first touches the screen on a tag, this tag must be selected. */
static void test_a_poi_that_appears_over_a_tag_has_moved_to_it(void **state)
{
    (void)state;
    static const uint8_t rules[] = { 0, 9 };
    for (size_t i = 0; i < sizeof rules; i++) {
        offer_levels(LEVEL_NORMAL, 1);
        core.config.rules = rules[i];
        choose();
        hold(0, above_tag(0));
        ticks(60);
        lead(0, v3_add(input.poi[0].target.position_m, v3(0.0f, BELOW_M - ABOVE_M, 0.0f)));
        assert_int_equal(core.game.phase, PHASE_READY);
        assert_int_equal(core.game.player[0].level, rules[i] == 0 ? LEVEL_EASY : LEVEL_NORMAL);
    }
}

static void test_start_or_a_dip_at_once_begins_the_festival_at_the_configured_level(void **state)
{
    (void)state;
    for (uint8_t level = 0; level < LEVEL_COUNT; level++) {
        for (uint32_t dips = 0; dips < 2u; dips++) {
            offer_levels(level, 1);
            hold(0, above_tag(3)); /* Holds the poi at rest above the tag of the championship. */
            ticks(60);
            choose();
            if (dips) {
                lead(0, v3_add(input.poi[0].target.position_m, v3(0.0f, BELOW_M - ABOVE_M, 0.0f)));
            } else {
                press(INPUT_START);
            }
            assert_int_equal(core.game.phase, PHASE_READY);
            assert_int_equal(core.game.mode, MODE_FESTIVAL);
            assert_int_equal(core.game.player[0].level, level);
        }
    }
}

/* Without a poi, a player must not influence the fish. Otherwise the absent players would make the
 * fish calm. */
static void test_the_fish_follow_the_easiest_level_of_the_players_with_a_poi(void **state)
{
    (void)state;
    offer_levels(LEVEL_NORMAL, 4);
    hold(0, v3(0.0f, ABOVE_M, -0.2f));
    choose();
    lead(0, above_tag(2));
    press(INPUT_START);
    ticks(60);
    assert_int_equal(core.game.player[0].level, LEVEL_MASTER);
    assert_memory_equal(&core.world.tank.temper, &rules_of_level(LEVEL_MASTER)->temper,
                        sizeof(struct temper));
    /* A player who appears later gets the level that the operator configured. */
    hold(1, v3(0.2f, ABOVE_M, 0.0f));
    ticks(60);
    assert_int_equal(core.game.player[1].level, LEVEL_NORMAL);
    assert_memory_equal(&core.world.tank.temper, &rules_of_level(LEVEL_NORMAL)->temper,
                        sizeof(struct temper));
}

static void test_each_player_has_the_level_that_the_player_selected_last(void **state)
{
    (void)state;
    static const uint8_t levels[] = { LEVEL_MASTER, LEVEL_EASY, LEVEL_NORMAL };
    offer_levels(LEVEL_NORMAL, 3);
    for (uint32_t i = 0; i < 3u; i++) {
        hold(i, v3(0.1f * (float)i, ABOVE_M, -0.2f));
    }
    choose();
    lead(0, above_tag(0));
    lead(1, above_tag(2));
    lead(1, above_tag(0));
    lead(0, above_tag(2));
    assert_int_equal(look()->pointed_tags, 7u);
    press(INPUT_START);
    for (uint32_t i = 0; i < 600u && core.game.phase != PHASE_ROUND; i++) {
        tick();
    }
    assert_int_equal(core.game.mode, MODE_FESTIVAL);
    for (uint32_t i = 0; i < 3u; i++) {
        assert_int_equal(look()->player[i].level, levels[i]);
        assert_float_equal(core.world.poi[i].sheet.radius_m,
                           rules_of_level(levels[i])->ring_radius_m, 0.0f);
        assert_int_equal(core.world.poi[i].sheet.grade,
                         rules_grade_at_level(GAME_POI_GRADE, levels[i]));
    }
    assert_memory_equal(&core.world.tank.temper, &rules_of_level(LEVEL_EASY)->temper,
                        sizeof(struct temper));
}

static void test_tags_do_not_overlap_and_are_on_the_canvas(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2u << CHOICE_COUNT; i++) {
        const bool upright = i & 1u;
        const struct layout_point canvas = pointer_layout_size(upright);
        const uint32_t offered = mode_tags_offered((uint8_t)(i >> 1), true);
        for (uint32_t a = 0; a < MODE_TAG_COUNT; a++) {
            for (uint32_t b = 0; b < MODE_TAG_COUNT; b++) {
                if (!(offered >> a & 1u) || !(offered >> b & 1u)) {
                    continue;
                }
                const struct layout_box one = mode_tag_box(upright, offered, a);
                const struct layout_box two = mode_tag_box(upright, offered, b);
                assert_true(one.x >= 0.0f && one.x + one.width <= canvas.x);
                assert_true(one.y >= 0.0f && one.y + one.height <= canvas.y);
                assert_true(a == b || one.x + one.width <= two.x || two.x + two.width <= one.x ||
                            one.y + one.height <= two.y || two.y + two.height <= one.y);
            }
        }
    }
}

static void test_the_press_that_opens_the_selection_chooses_no_mode(void **state)
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

static void test_fifteen_seconds_without_input_end_the_selection(void **state)
{
    (void)state;
    choose();
    press(INPUT_RIGHT);
    assert_float_equal(look()->seconds_left, 15.0f, 0.02f);
    ticks(RULES_MODE_SELECT_TICKS - 2u);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_float_equal(look()->seconds_left, 0.0f, 0.02f);
    ticks(2);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_a_moving_poi_keeps_the_selection_open(void **state)
{
    (void)state;
    hold(0, v3(LEFT_M, ABOVE_M, 0.0f));
    choose();
    for (uint32_t i = 0; i < 5; i++) {
        ticks(RULES_MODE_SELECT_TICKS - CORE_TICK_HZ);
        lead(0, v3(LEFT_M, ABOVE_M, i % 2u ? 0.0f : 0.1f));
        assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    }
    /* The poi has been resting, so no player counts as present. The selection therefore times
     * out. */
    ticks(RULES_MODE_SELECT_TICKS + 1u);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* A poi that hangs at the kiosk's edge and swings on its cord must not keep the selection open for
 * ever. */
static void test_the_selection_lasts_at_most_two_minutes(void **state)
{
    (void)state;
    hold(0, v3(LEFT_M, ABOVE_M, 0.0f));
    choose();
    const uint32_t begin_tick = core.game.phase_tick;
    while (core.game.phase == PHASE_MODE_SELECT &&
           core.game.tick - begin_tick <= GAME_MODE_SELECT_TICKS_MAX) {
        lead(0, v3(LEFT_M, ABOVE_M, core.game.tick % 2u ? 0.0f : 0.1f));
        press(core.game.tick % 3u ? 0 : INPUT_RIGHT);
        assert_true(look()->seconds_left <= 15.0f);
    }
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_in_range(core.game.phase_tick - begin_tick, 120u * CORE_TICK_HZ,
                    120u * CORE_TICK_HZ + 1u);
}

/* The controller is lost and returns at another place, so the poi moves to that place at a limited
 * speed. This motion must end when a tank is opened. */
static void test_a_newly_opened_tank_has_no_returning_poi(void **state)
{
    (void)state;
    hold(0, v3(0.0f, ABOVE_M, 0.0f));
    choose();
    input.poi[0].link = POI_SOURCE_LOST;
    ticks(60);
    hold(0, v3(0.0f, ABOVE_M, 0.2f));
    for (uint32_t i = 0; i < 120 && core.game.control[0].return_ticks < 2u; i++) {
        tick();
    }
    assert_true(core.game.control[0].return_ticks > 0);
    press(INPUT_RIGHT);
    assert_int_equal(core.game.mode, MODE_CHAMPIONSHIP);
    press(INPUT_START);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_OFFICIAL);
    assert_int_equal(core.game.control[0].return_ticks, 0);
    assert_int_equal(core.world.poi[0].damage_immune, 0);
}

static void test_a_poi_stays_above_the_water_during_the_selection(void **state)
{
    (void)state;
    choose();
    /* The controller is below the water when it first appears. This does not count as a dip,
     * because the poi was not above the water before. */
    hold(0, v3(RIGHT_M, BELOW_M, 0.0f));
    ticks(300);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_true(core.world.poi[0].position_m.y > 0.0f);
    assert_int_equal(core.world.poi[0].dips, 0);
}

static void test_the_championship_has_its_own_tank_and_attract_the_festivals(void **state)
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
    /* Simulates the end of a round. After the result the kiosk returns to attract mode in the
     * festival's tank. */
    core.game.phase = PHASE_RESULT;
    core.game.phase_tick = core.game.tick;
    ticks(GAME_RESULT_TICKS + 1u);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_FESTIVAL);
    assert_int_equal(core.world.tank.fish_count, 12);
}

static void test_each_championship_has_a_new_random_tank(void **state)
{
    (void)state;
    take(MODE_CHAMPIONSHIP);
    const uint32_t first = core.world.tank.seed;
    offer_all(state);
    core.game.round_count = 1;
    take(MODE_CHAMPIONSHIP);
    assert_int_not_equal(core.world.tank.seed, first);
}

/* Each fish stores the tick of its last decision in one byte, which wraps every 256 ticks. In a
 * tank that is opened late, this byte must be set to the current tick. Otherwise the fish would
 * seem to have made their decision long ago. */
static void test_fish_of_a_tank_that_opens_late_were_just_updated(void **state)
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

static void test_festival_and_practice_use_the_configured_tank(void **state)
{
    (void)state;
    const struct core_config config = { .preset = TANK_PRESET_THESIS,
                                        .fish_count = 12,
                                        .modes = ALL_MODES };
    static const uint8_t modes[] = { MODE_FESTIVAL, MODE_PRACTICE };
    for (size_t i = 0; i < sizeof modes; i++) {
        open_core(&config);
        take(modes[i]);
        assert_int_equal(core.world.tank.preset, TANK_PRESET_THESIS);
        assert_int_equal(core.world.tank.fish_count, 12);
    }
}

static void test_the_paper_is_the_configured_grade_except_in_the_championship(void **state)
{
    (void)state;
    const struct core_config config = { .fish_count = 12, .modes = ALL_MODES, .grade = 4 };
    static const uint8_t grades[MODE_COUNT] = { 4, 5, 4 };
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        open_core(&config);
        take(mode);
        ticks(10);
        assert_int_equal(core.world.poi[0].sheet.grade, grades[mode]);
        assert_int_equal(look()->grade, grades[mode]);
    }
}

static void test_a_championship_as_the_only_mode_uses_the_configured_grade(void **state)
{
    (void)state;
    const uint8_t named[] = { 0, 4, 7 }, played[] = { 5, 4, 7 };
    for (size_t i = 0; i < sizeof named; i++) {
        const struct core_config config = { .preset = TANK_PRESET_OFFICIAL,
                                            .fish_count = 12,
                                            .modes = 1u << MODE_CHAMPIONSHIP,
                                            .grade = named[i] };
        assert_int_equal(table_setup_grade(&config, MODE_CHAMPIONSHIP), played[i]);
        open_core(&config);
        assert_int_equal(core.world.poi[0].sheet.grade, played[i]);
    }
}

static void test_the_same_inputs_choose_and_play_identically(void **state)
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

static void test_start_in_the_result_reopens_the_selection(void **state)
{
    (void)state;
    take(MODE_PRACTICE);
    core.game.phase = PHASE_RESULT;
    core.game.phase_tick = core.game.tick;
    ticks(GAME_AGAIN_TICKS);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    /* The new selection begins with the mode of the last round. */
    assert_int_equal(look()->mode, MODE_PRACTICE);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, offer_all)
    const struct CMUnitTest tests[] = {
        TEST(test_a_single_mode_needs_no_selection),
        TEST(test_left_and_right_cycle_and_start_chooses_a_mode),
        TEST(test_disabled_modes_are_skipped),
        TEST(test_under_the_rules_of_format_8_a_poi_selects_the_mode_of_its_section),
        TEST(test_a_moved_poi_selects_the_tag_below_it),
        TEST(test_a_dip_chooses_the_tag_under_it),
        TEST(test_a_poi_that_appears_over_a_tag_has_moved_to_it),
        TEST(test_start_or_a_dip_at_once_begins_the_festival_at_the_configured_level),
        TEST(test_the_fish_follow_the_easiest_level_of_the_players_with_a_poi),
        TEST(test_each_player_has_the_level_that_the_player_selected_last),
        TEST(test_tags_do_not_overlap_and_are_on_the_canvas),
        TEST(test_the_press_that_opens_the_selection_chooses_no_mode),
        TEST(test_fifteen_seconds_without_input_end_the_selection),
        TEST(test_a_moving_poi_keeps_the_selection_open),
        TEST(test_the_selection_lasts_at_most_two_minutes),
        TEST(test_a_newly_opened_tank_has_no_returning_poi),
        TEST(test_a_poi_stays_above_the_water_during_the_selection),
        TEST(test_the_championship_has_its_own_tank_and_attract_the_festivals),
        TEST(test_each_championship_has_a_new_random_tank),
        TEST(test_fish_of_a_tank_that_opens_late_were_just_updated),
        TEST(test_festival_and_practice_use_the_configured_tank),
        TEST(test_the_paper_is_the_configured_grade_except_in_the_championship),
        TEST(test_a_championship_as_the_only_mode_uses_the_configured_grade),
        TEST(test_the_same_inputs_choose_and_play_identically),
        TEST(test_start_in_the_result_reopens_the_selection),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
