/* test_menu_calibrate.c -- checks the menu page that calibrates a poi: its marks, undo, and the
 * effect of the calibration on catching fish. After a power cut, the calibration must be complete
 * or absent. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/menu/menu_pages.h"
#include "core/game/bot/bot.h"
#include "tests/unit/support/bot_fixture.h"
#include "tests/unit/support/skewed_twin.h"
#include "tests/unit/support/newest_record.h"
#include "tests/unit/support/menu_tag.h"

static struct bot_fixture fixture;
static const struct twin skewed = {
    .xx = 0.7f,
    .xz = 0.5f,
    .zx = -0.6f,
    .zz = 0.8f,
    .shift_m = { 0.30f, 0.09f, -0.20f },
    .pitch_rad = 0.3f,
    .roll_rad = -0.2f,
};

static int setup(void **state)
{
    (void)state;
    struct core_config config = { .seed = 3 };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_MODES] = 1 << MODE_FESTIVAL;
    config.persistent.settings.value[SET_ROUND_S] = 60;
    config_apply_settings(&config, &config.persistent.settings);
    bot_fixture_open(&fixture, &config, &technique_expert);
    fixture.input.store_well = 1;
    return 0;
}

static void step(void)
{
    fixture.output.sound_count = 0;
    core_tick(&fixture.core, &fixture.input, &fixture.output);
    fixture.input.pressed = 0;
    fixture.input.record_saved_id = fixture.output.entry_id;
}

static void push(uint32_t button)
{
    fixture.input.pressed = button;
    for (uint32_t i = 0; i <= MENU_TAKE_TICKS; i++) {
        step();
    }
}

static const struct menu *menu(void)
{
    return &fixture.core.game.menu;
}

static const struct calibrate *calibrate(void)
{
    return &menu()->calibrate;
}

static void take(uint32_t tag)
{
    for (uint32_t i = 0; menu()->tag[menu()->page] != tag && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    assert_int_equal(menu()->tag[menu()->page], tag);
    push(INPUT_TEST);
}

/* Holds the poi at the true pose `at` with a tremor of 1 mm. The core gets the pose in the
 * coordinates of the simulated device. */
static void hold_true(struct poi_target at, uint32_t ticks)
{
    for (uint32_t i = 0; i < ticks; i++) {
        struct poi_target now = at;
        now.position_m.x += i % 2u ? 0.001f : -0.001f;
        fixture.input.poi[0] = (struct poi_input){
            .link = POI_SOURCE_LIVE, .has_wrist = 1, .trembles = 1, .target = seen(&skewed, now)
        };
        step();
    }
}

static void open_page(void)
{
    hold_true((struct poi_target){ .position_m = v3(0.0f, 0.1f, 0.0f) }, 2);
    push(INPUT_TEST);
    take(menu_tag_of(MENU_DEVICES));
    take(menu_tag_of(MENU_CALIBRATION));
    assert_int_equal(menu()->page, MENU_CALIBRATION);
}

/* Calibrates the poi without a button, by moving it from mark to mark. */
static void lead_through(struct poi_target water)
{
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        assert_int_equal(calibrate()->step, CALIBRATE_CORNER + (int)i);
        const vec3 mark_m = input_calibration_mark(fixture.core.world.tank.size_m, i);
        hold_true((struct poi_target){ .position_m = mark_m }, CALIBRATE_STILL_TICKS + 4u);
    }
    assert_int_equal(calibrate()->step, CALIBRATE_WATER);
    hold_true(water, CALIBRATE_STILL_TICKS + 4u);
}

static bool is_set(void)
{
    return input_calibration_is_set(&fixture.core.config.persistent.settings, 0);
}

static void calibrate_all(void)
{
    open_page();
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ 0 });
    assert_int_equal(calibrate()->step, CALIBRATE_DONE);
}

static void test_a_calibration_visits_each_mark_and_applies_immediately(void **state)
{
    (void)state;
    calibrate_all();
    assert_true(is_set());
    const struct poi_target at = { .position_m = v3(0.21f, 0.05f, -0.11f) };
    hold_true(at, 60);
    const vec3 off_m =
        v3_sub(fixture.core.game.control[0].validation.newest.position_m, at.position_m);
    /* The error must be below 4 mm. The tremor causes 1 mm of it. */
    assert_true(v3_length(off_m) < 0.004f);
}

static void test_each_calibration_value_is_a_ledger_entry(void **state)
{
    (void)state;
    open_page();
    const uint32_t before = fixture.output.entry_id;
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ 0 });
    hold_true((struct poi_target){ .position_m = v3(0.2f, 0.1f, 0.0f) }, CORE_TICK_HZ);
    assert_int_equal(fixture.output.entry_id, before + CALIBRATION_VALUES + 1u);
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        const struct ledger_entry *entry = &fixture.output.entries[(before + 1u + i) % LEDGER_RING];
        assert_int_equal(entry->kind, LEDGER_SETTING);
        assert_int_equal(entry->detail | entry->count << 8, input_calibration_setting(0) + i);
        assert_int_equal(
            entry->value,
            fixture.core.config.persistent.settings.value[input_calibration_setting(0) + i]);
    }
    /* The last entry must be the check value, which marks the calibration as complete. */
    const struct ledger_entry *check =
        &fixture.output.entries[fixture.output.entry_id % LEDGER_RING];
    assert_int_equal(check->detail | check->count << 8, input_calibration_check_setting(0));
    assert_true(settings_edit_is_saved(&fixture.core.game.accounts.ledger,
                                       &fixture.core.game.settings_edit,
                                       &fixture.core.config.persistent.settings));
}

/* Returns the settings that are stored if the power is cut after the first `count` entries after
 * the entry `before_id`. */
static struct settings settings_cut_after(const struct settings *before, uint32_t before_id,
                                          uint32_t count)
{
    struct settings left = *before;
    for (uint32_t i = 1; i <= count; i++) {
        const struct ledger_entry *entry = &fixture.output.entries[(before_id + i) % LEDGER_RING];
        assert_int_equal(entry->kind, LEDGER_SETTING);
        left.value[entry->detail | entry->count << 8] = entry->value;
    }
    settings_sanitize(&left);
    return left;
}

/* Simulates a power cut before the first entry, between any two entries, and after the last entry.
 * The stored calibration must be the old one, the new one or none, but never a mixture. */
static void expect_no_mixture(const struct settings *before, uint32_t before_id)
{
    const struct settings now = fixture.core.config.persistent.settings;
    const uint32_t count = fixture.output.entry_id - before_id;
    uint32_t torn = 0;
    assert_true(count >= 2u && count < LEDGER_RING);
    for (uint32_t i = 0; i <= count; i++) {
        const struct settings left = settings_cut_after(before, before_id, i);
        const struct settings *whole = i < count ? before : &now;
        const struct poi_input report = { .link = POI_SOURCE_LIVE,
                                          .has_wrist = 1,
                                          .target = { { 0.1f, 0.2f, 0.3f },
                                                      { 0.4f, 0.5f, 0.6f } } };
        struct poi_input poi = report, expected = report;
        input_calibration_apply(&left, 0, &poi);
        if (i == 0 || i == count) {
            input_calibration_apply(whole, 0, &expected);
        }
        assert_memory_equal(&poi, &expected, sizeof poi);
        torn += (uint32_t)input_calibration_is_torn(&left, 0);
        assert_false(input_calibration_is_torn(&left, 0) && (i == 0 || i == count));
    }
    /* A power cut between two ledger entries must leave an incomplete calibration, which is
     * detected and not used. There is one exception: during a removal, the last cut may leave no
     * calibration at all. */
    assert_true(torn >= count - 2u);
}

static void test_an_incomplete_calibration_after_a_power_cut_is_not_used(void **state)
{
    (void)state;
    struct settings before = fixture.core.config.persistent.settings;
    const struct poi_target aside = { .position_m = v3(0.2f, 0.1f, 0.0f) };
    open_page();
    uint32_t before_id = fixture.output.entry_id;
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ 0 });
    hold_true(aside, CORE_TICK_HZ);
    /* Cuts the power during the first calibration of the poi. */
    expect_no_mixture(&before, before_id);

    before = fixture.core.config.persistent.settings;
    before_id = fixture.output.entry_id;
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ .position_m.y = 0.01f, .angles = { 0.0f, 0.1f, 0.05f } });
    hold_true(aside, CORE_TICK_HZ);
    /* Cuts the power during a second calibration, which replaces the first one. */
    expect_no_mixture(&before, before_id);

    before = fixture.core.config.persistent.settings;
    before_id = fixture.output.entry_id;
    take(CALIBRATE_NONE);
    hold_true(aside, CORE_TICK_HZ);
    /* Cuts the power during the removal of the calibration. */
    expect_no_mixture(&before, before_id);
}

/* After a power cut, the page must show that the calibration is incomplete and let the operator
 * remove it. Undo must restore the last complete calibration. */
static void test_an_incomplete_calibration_is_shown_and_can_be_removed(void **state)
{
    (void)state;
    static struct scene scene;
    calibrate_all();
    fixture.core.config.persistent.settings.value[input_calibration_setting(0) + CALIBRATION_Z0] +=
        1;
    step();
    core_scene(&fixture.core, &scene);
    assert_true(input_calibration_is_torn(&scene.menu.settings, 0));
    assert_false(is_set());
    assert_true(menu_enabled(menu()) >> CALIBRATE_NONE & 1u);
    take(CALIBRATE_NONE);
    assert_false(input_calibration_is_torn(&fixture.core.config.persistent.settings, 0));
    take(CALIBRATE_UNDO);
    assert_false(input_calibration_is_torn(&fixture.core.config.persistent.settings, 0));
    assert_false(is_set());
}

static void test_a_calibration_can_be_undone_redone_and_removed(void **state)
{
    (void)state;
    calibrate_all();
    const struct settings set = fixture.core.config.persistent.settings;
    take(CALIBRATE_UNDO);
    assert_false(is_set());
    take(CALIBRATE_UNDO);
    assert_memory_equal(&fixture.core.config.persistent.settings, &set, sizeof set);
    take(CALIBRATE_NONE);
    assert_false(is_set());
    assert_false(menu_enabled(menu()) >> CALIBRATE_NONE & 1u);
    take(CALIBRATE_UNDO);
    assert_memory_equal(&fixture.core.config.persistent.settings, &set, sizeof set);
}

static void test_the_page_offers_only_connected_pois(void **state)
{
    (void)state;
    open_page();
    assert_int_equal(calibrate()->slot, 0);
    assert_false(menu_enabled(menu()) >> CALIBRATE_NEXT & 1u);
    fixture.input.poi[2] = fixture.input.poi[0];
    step();
    assert_true(menu_enabled(menu()) >> CALIBRATE_NEXT & 1u);
    take(CALIBRATE_NEXT);
    assert_int_equal(calibrate()->slot, 2);
    take(CALIBRATE_BACK);
    /* The selected poi is unplugged, so the page opens with the other poi. */
    fixture.input.poi[2].link = POI_SOURCE_ABSENT;
    step();
    take(menu_tag_of(MENU_CALIBRATION));
    assert_int_equal(menu()->page, MENU_CALIBRATION);
    assert_int_equal(calibrate()->slot, 0);
    assert_false(menu_enabled(menu()) >> CALIBRATE_NEXT & 1u);
}

static void test_a_rejected_calibration_changes_nothing(void **state)
{
    (void)state;
    open_page();
    take(CALIBRATE_BEGIN);
    lead_through((struct poi_target){ .angles.pitch_rad = 0.6f });
    assert_int_equal(calibrate()->step, CALIBRATE_REFUSED);
    assert_int_equal(calibrate()->fault, CALIBRATION_TILTED);
    assert_false(is_set());
    assert_false(menu_enabled(menu()) >> CALIBRATE_UNDO & 1u);
}

/* Only a poi that rests after a motion marks a position. A poi in its holder, a moving poi and an
 * absent poi must mark nothing. */
static void test_only_a_rest_after_a_movement_counts_as_a_mark(void **state)
{
    (void)state;
    open_page();
    take(CALIBRATE_BEGIN);
    const struct poi_target holder = { .position_m = v3(0.0f, 0.1f, 0.0f) };
    hold_true(holder, 4u * CALIBRATE_STILL_TICKS);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    /* Moves the poi at 10 cm/s, so that it never rests. */
    for (uint32_t i = 0; i < 5u * CALIBRATE_STILL_TICKS; i++) {
        const float x = 0.001f * (float)(i % 600u) - 0.3f;
        hold_true((struct poi_target){ .position_m = v3(x, 0.1f, 0.0f) }, 1);
    }
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    const struct poi_target mark = { .position_m = input_calibration_mark(
                                         fixture.core.world.tank.size_m, 0) };
    hold_true(mark, CALIBRATE_STILL_TICKS / 2u);
    fixture.input.poi[0].link = POI_SOURCE_LOST;
    step();
    hold_true(mark, CALIBRATE_STILL_TICKS / 2u + 2u);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    hold_true(mark, CALIBRATE_STILL_TICKS / 2u + 2u);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER + 1);
    /* The poi still rests at the first mark, which must not confirm the second mark. */
    hold_true(mark, 4u * CALIBRATE_STILL_TICKS);
    assert_int_equal(calibrate()->step, CALIBRATE_CORNER + 1);
}

static void test_a_moving_poi_activates_no_tag(void **state)
{
    (void)state;
    open_page();
    take(CALIBRATE_BEGIN);
    /* Moves the poi over the whole screen and through the water. */
    for (uint32_t i = 0; i < 600u; i++) {
        const vec3 at_m = v3(0.002f * (float)(i % 300u) - 0.3f, i % 40u < 20u ? 0.06f : -0.05f,
                             0.001f * (float)i - 0.3f);
        hold_true((struct poi_target){ .position_m = at_m }, 1);
        assert_int_equal(menu()->page, MENU_CALIBRATION);
        assert_int_equal(calibrate()->step, CALIBRATE_CORNER);
    }
}

/* ---- A round -------------------------------------------------------------------------------- */

/* Plays a round in which a bot moves the poi. The core gets the poses in the coordinates of the
 * simulated device. Returns the number of ticks. */
static uint32_t play_a_round(void)
{
    uint32_t ticks = 0;
    bot_init(&fixture.bot, &technique_expert, 3);
    fixture.bot.hand.pose = (struct poi_target){ .position_m = v3(0.0f, 0.10f, 0.0f) };
    while (fixture.core.game.phase != PHASE_RESULT && ticks++ < 120u * CORE_TICK_HZ) {
        const uint8_t phase = fixture.core.game.phase;
        const struct vision vision = bot_fixture_sight(&fixture);
        fixture.input.pressed =
            phase == PHASE_ATTRACT && ticks % CORE_TICK_HZ == 0 ? INPUT_START : 0;
        hold_true(bot_tick(&fixture.bot, &vision), 1);
    }
    assert_int_equal(fixture.core.game.phase, PHASE_RESULT);
    return newest_record(&fixture.output)->caught;
}

static void test_a_skewed_poi_catches_fish_only_after_calibration(void **state)
{
    assert_int_equal(play_a_round(), 0);
    setup(state);
    calibrate_all();
    take(CALIBRATE_BACK);
    take(menu_tag_count(MENU_DEVICES, false) - 1u);
    take(menu_tag_count(MENU_TOP, false) - 1u);
    assert_int_equal(fixture.core.game.phase, PHASE_ATTRACT);
    const uint32_t caught = play_a_round();
    print_message("calibrated it caught %u\n", caught);
    assert_true(caught > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_a_calibration_visits_each_mark_and_applies_immediately, setup),
        cmocka_unit_test_setup(test_each_calibration_value_is_a_ledger_entry, setup),
        cmocka_unit_test_setup(test_an_incomplete_calibration_after_a_power_cut_is_not_used, setup),
        cmocka_unit_test_setup(test_an_incomplete_calibration_is_shown_and_can_be_removed, setup),
        cmocka_unit_test_setup(test_a_calibration_can_be_undone_redone_and_removed, setup),
        cmocka_unit_test_setup(test_the_page_offers_only_connected_pois, setup),
        cmocka_unit_test_setup(test_a_rejected_calibration_changes_nothing, setup),
        cmocka_unit_test_setup(test_only_a_rest_after_a_movement_counts_as_a_mark, setup),
        cmocka_unit_test_setup(test_a_moving_poi_activates_no_tag, setup),
        cmocka_unit_test_setup(test_a_skewed_poi_catches_fish_only_after_calibration, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
