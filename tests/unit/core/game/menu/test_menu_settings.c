/* test_menu_settings.c -- checks the settings that an operator changes with two buttons or a poi.
 * Each change must apply at once, give one ledger entry, and never be lost. */
#include "core/pin.h"
#include "core/game/accounting/accounts.h"
#include "core/game/menu/menu_pages.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"
#include "tests/unit/support/menu_tag.h"

/* Seconds for which TEST is held, which is long enough to step through the longest range of
 * values. */
#define HELD_S 12u

static const struct menu *menu(void)
{
    return &core.game.menu;
}

static int32_t value(uint32_t id)
{
    return core.config.persistent.settings.value[id];
}

static void push(uint32_t button)
{
    press(button);
    steps(MENU_TAKE_TICKS);
}

static void point_at(uint32_t tag)
{
    for (uint32_t i = 0; menu()->tag[menu()->page] != tag && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    assert_int_equal(menu()->tag[menu()->page], tag);
}

static void take(uint32_t tag)
{
    point_at(tag);
    push(INPUT_TEST);
}

static void go_to(uint8_t page)
{
    take(menu_tag_of(page));
    assert_int_equal(menu()->page, page);
}

static void go_back(void)
{
    take(menu_tag_count(menu()->page, false) - 1u);
}

/* Opens a kiosk with default settings and with a store that saves every entry. Then opens the
 * menu. */
static int setup_menu(void **state)
{
    setup(state);
    settings_reset(&core.config.persistent.settings);
    settings_edit_init(&core.game.settings_edit, &core.config);
    config_apply_settings(&core.config, &core.config.persistent.settings);
    store_is_late = 1;
    input.store_well = 1;
    push(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    return 0;
}

static uint32_t row_of(uint8_t page, uint32_t id)
{
    uint32_t tag = 0;
    while (menu_setting_at(page, false, tag) != id) {
        assert_true(++tag < MENU_TAG_MAX);
    }
    return tag;
}

static uint32_t foot(uint32_t index)
{
    return menu_body_count(menu()->page, false) + index;
}

/* Returns the newest entry of the ledger. */
static const struct ledger_entry *newest(void)
{
    return &output.entries[output.entry_id % LEDGER_RING];
}

/* Reports all entries to the core as saved. */
static void save_all(void)
{
    input.record_saved_id = output.entry_id;
    step();
}

/* ---- Changing a value ----------------------------------------------------------------------- */

static void test_an_activation_increments_a_value_and_wraps_around(void **state)
{
    (void)state;
    static const uint8_t way[] = { PLAY_PAID, PLAY_EVENT, PLAY_FREE, PLAY_PAID };
    go_to(MENU_MONEY);
    point_at(row_of(MENU_MONEY, SET_PLAY));
    for (size_t i = 0; i < sizeof way; i++) {
        push(INPUT_TEST);
        assert_int_equal(value(SET_PLAY), way[i]);
        assert_int_equal(core.config.credit_coins, way[i] == PLAY_PAID ? value(SET_PRICE) : 0);
    }
}

static void test_the_level_of_the_menu_is_the_level_of_the_next_round(void **state)
{
    (void)state;
    static const uint8_t way[] = { LEVEL_EASY, LEVEL_MASTER, LEVEL_NORMAL };
    assert_int_equal(core.config.level, LEVEL_NORMAL);
    go_to(MENU_GAME);
    point_at(row_of(MENU_GAME, SET_LEVEL));
    for (size_t i = 0; i < sizeof way; i++) {
        push(INPUT_TEST);
        assert_int_equal(core.config.level, way[i]);
    }
}

/* The menu of older recordings lacks the rows of newer settings. Before format 10, LEFT moves the
 * highlight on every page. The button presses of a recording fit only the menu of its format. */
static void test_the_menu_of_an_older_format_lacks_the_rows_of_newer_settings(void **state)
{
    (void)state;
    static const struct {
        uint8_t rules, body_count;
    } menus[] = { { 0, 11 }, { 9, 8 }, { 8, 7 } };
    for (size_t i = 0; i < sizeof menus / sizeof *menus; i++) {
        go_back(); /* Closes the menu. */
        core.config.rules = menus[i].rules;
        push(INPUT_TEST);
        go_to(MENU_GAME);
        for (uint32_t row = 0; row + 1u < menus[i].body_count; row++) {
            push(INPUT_SERVICE);
        }
        /* The last row of the page opens the page of the modes. */
        push(INPUT_TEST);
        assert_int_equal(menu()->page, MENU_MODES);
        go_back();
        push(menus[i].rules == 0 ? INPUT_UP : INPUT_LEFT);
        assert_int_equal(menu()->tag[MENU_GAME], menus[i].body_count + SETTINGS_FEET - 1u);
        push(INPUT_TEST);
        assert_int_equal(menu()->page, MENU_TOP);
    }
}

static void test_the_footer_decrements_a_value_and_restores_the_default(void **state)
{
    (void)state;
    go_to(MENU_SOUND);
    /* No setting is selected yet, so the menu entry that restores a default is disabled. */
    assert_false(menu_enabled(menu()) >> foot(SETTINGS_STANDARD) & 1u);
    take(foot(SETTINGS_DIRECTION));
    take(row_of(MENU_SOUND, SET_VOLUME));
    push(INPUT_TEST);
    assert_int_equal(value(SET_VOLUME), 70);
    take(foot(SETTINGS_STANDARD));
    assert_int_equal(value(SET_VOLUME), 80);
    take(foot(SETTINGS_DIRECTION));
    take(row_of(MENU_SOUND, SET_VOLUME));
    assert_int_equal(value(SET_VOLUME), 85);
}

/* The configuration file or the command line may also change a setting. The menu must then enable
 * the tag that restores the default of this setting. */
static void test_a_setting_changed_elsewhere_enables_its_default(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_CREDIT_MAX] = 5;
    go_to(MENU_MONEY);
    assert_true(menu_enabled(menu()) >> foot(SETTINGS_STANDARD) & 1u);
    take(foot(SETTINGS_STANDARD));
    assert_int_equal(value(SET_CREDIT_MAX), settings_entry(SET_CREDIT_MAX)->standard);
}

static void test_an_unchanged_setting_is_not_shown_as_saved(void **state)
{
    (void)state;
    static struct scene scene;
    go_to(MENU_SOUND);
    save_all();
    core_scene(&core, &scene);
    assert_true(scene.menu.is_saved && !scene.menu.has_turned);
    push(INPUT_TEST);
    /* The ledger entry of a setting is written only when the value has not changed for some
     * seconds. */
    steps(3u * CORE_TICK_HZ);
    save_all();
    core_scene(&core, &scene);
    assert_true(scene.menu.is_saved && scene.menu.has_turned);
    steps(10u * CORE_TICK_HZ);
    core_scene(&core, &scene);
    assert_false(scene.menu.has_turned);
}

/* Steps through all values of each setting upward, continues at the lowest value, and steps down
 * again. Every valid value must appear, and no other value. */
static void test_every_setting_reaches_every_value_of_its_range(void **state)
{
    (void)state;
    const struct menu_scope scope = menu_scope_of(&core.game, &core.config, &output);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        if (setting->group == GROUP_CALIBRATION) {
            continue;
        }
        uint32_t allowed = 0, met = 0;
        for (int32_t v = setting->min; v <= settings_edit_max(&core.config, id); v++) {
            allowed += settings_allows(id, v) != 0;
        }
        settings_edit_set(&scope, id, setting->min);
        do {
            settings_edit_step(&scope, id, 0, 1);
            assert_true(settings_allows(id, value(id)) &&
                        value(id) <= settings_edit_max(&core.config, id));
            met++;
        } while (value(id) != setting->min && met <= allowed);
        assert_int_equal(met, allowed);
        for (uint32_t i = 0; i < allowed; i++) {
            settings_edit_step(&scope, id, 1, 1);
        }
        assert_int_equal(value(id), setting->min);
    }
}

static void test_every_setting_is_on_exactly_one_page(void **state)
{
    (void)state;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const bool is_hidden = id == SET_PIN || settings_entry(id)->group == GROUP_CALIBRATION;
        uint32_t rows = 0;
        for (uint8_t page = 0; page < MENU_PAGE_COUNT; page++) {
            for (uint32_t tag = 0; tag < menu_body_count(page, false); tag++) {
                rows += menu_setting_at(page, false, tag) == id;
            }
        }
        /* Each setting must have one row on one page. The PIN has no row, because it is entered as
         * digits, and the calibration has a page of its own. */
        assert_int_equal(rows, is_hidden ? 0 : 1);
    }
}

static void test_a_held_button_repeats_fast_and_stops_at_the_end(void **state)
{
    (void)state;
    go_to(MENU_GAME);
    point_at(row_of(MENU_GAME, SET_FISH));
    input.held = INPUT_TEST;
    press(INPUT_TEST);
    assert_int_equal(value(SET_FISH), 1);
    steps(CORE_TICK_HZ / 2u - 1u);
    /* A button counts as held after half a second. Until then, the value must have changed only
     * once. */
    assert_int_equal(value(SET_FISH), 1);
    steps(2);
    assert_int_equal(value(SET_FISH), 2);
    steps(HELD_S * CORE_TICK_HZ);
    assert_int_equal(value(SET_FISH), settings_edit_max(&core.config, SET_FISH));
    input.held = 0;
    step();
    push(INPUT_TEST);
    /* A held button stops at the maximum. Only a new press continues at 0, the minimum. */
    assert_int_equal(value(SET_FISH), 0);
}

/* LEFT and RIGHT change the value directly, in both directions. UP, DOWN and SERVICE choose the
 * row. A keyboard or a direction pad reports OK together with UP and DOWN. */
static void test_left_lowers_and_right_raises_the_highlighted_value(void **state)
{
    (void)state;
    const uint32_t first = row_of(MENU_SOUND, SET_VOLUME);
    go_to(MENU_SOUND);
    static const struct {
        uint32_t button;
        int32_t volume;
    } pushes[] = { { INPUT_RIGHT, 85 },
                   { INPUT_LEFT, 80 },
                   { INPUT_LEFT, 75 },
                   { INPUT_LEFT, 70 },
                   { INPUT_RIGHT, 75 } };
    for (size_t i = 0; i < sizeof pushes / sizeof *pushes; i++) {
        push(pushes[i].button);
        assert_int_equal(value(SET_VOLUME), pushes[i].volume);
        assert_int_equal(menu()->tag[MENU_SOUND], first);
    }
    push(INPUT_DOWN | INPUT_OK);
    assert_int_equal(menu()->tag[MENU_SOUND], first + 1u);
    push(INPUT_UP | INPUT_OK);
    assert_int_equal(menu()->tag[MENU_SOUND], first);
    assert_int_equal(value(SET_VOLUME), 75);
    /* At the foot of the page, LEFT and RIGHT move the highlight as on other pages. */
    point_at(foot(SETTINGS_STANDARD));
    push(INPUT_RIGHT);
    assert_int_equal(menu()->tag[MENU_SOUND], foot(SETTINGS_BACK));
    push(INPUT_LEFT);
    push(INPUT_LEFT);
    assert_int_equal(menu()->tag[MENU_SOUND], foot(SETTINGS_DIRECTION));
}

static void test_a_held_left_repeats_down_to_the_smallest_value(void **state)
{
    (void)state;
    go_to(MENU_SOUND);
    input.held = INPUT_LEFT;
    press(INPUT_LEFT);
    assert_int_equal(value(SET_VOLUME), 75);
    steps(CORE_TICK_HZ);
    assert_in_range(value(SET_VOLUME), 45, 65);
    steps(HELD_S * CORE_TICK_HZ);
    assert_int_equal(value(SET_VOLUME), 0);
}

/* Holds the poi above the middle of a box of the canvas. */
static void hold_over(struct layout_box box)
{
    const struct layout_point canvas = pointer_layout_size(0);
    const vec3 tank_m = core.world.tank.size_m;
    input.poi[0] = (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .target.position_m = { tank_m.x * ((box.x + 0.5f * box.width) / canvas.x - 0.5f), ABOVE_M,
                               tank_m.z * ((box.y + 0.5f * box.height) / canvas.y - 0.5f) },
    };
    steps(MENU_TAKE_TICKS);
}

static void dip_there(void)
{
    input.poi[0].target.position_m.y = BELOW_M;
    step();
    input.poi[0].target.position_m.y = ABOVE_M;
    steps(MENU_TAKE_TICKS);
}

static void test_a_dip_on_an_arrow_changes_the_value_in_its_direction(void **state)
{
    (void)state;
    static const uint8_t pages[SETTING_GROUP_COUNT] = { [GROUP_MONEY] = MENU_MONEY,
                                                        [GROUP_GAME] = MENU_GAME,
                                                        [GROUP_SOUND] = MENU_SOUND,
                                                        [GROUP_PICTURE] = MENU_PICTURE };
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        const uint8_t page = pages[setting->group];
        if (page == MENU_TOP || setting->kind == KIND_BITS) {
            continue;
        }
        go_to(page);
        const uint32_t tag = row_of(page, id);
        assert_true(menu_has_arrows(page, 0, tag));
        const struct layout_box row = menu_box(0, page, 0, menu_enabled(menu()), tag);
        const int32_t before = value(id);
        hold_over(menu_arrow_box(row, false));
        dip_there();
        assert_int_not_equal(value(id), before);
        hold_over(menu_arrow_box(row, true));
        dip_there();
        assert_int_equal(value(id), before);
        input.poi[0] = (struct poi_input){ 0 };
        step();
        go_back();
    }
}

static void test_a_poi_under_water_repeats_the_change(void **state)
{
    (void)state;
    go_to(MENU_SOUND);
    hold_over(menu_box(0, MENU_SOUND, 0, menu_enabled(menu()), row_of(MENU_SOUND, SET_VOLUME)));
    input.poi[0].target.position_m.y = BELOW_M;
    step();
    assert_int_equal(value(SET_VOLUME), 85);
    steps(3u * CORE_TICK_HZ);
    assert_int_equal(value(SET_VOLUME), 100);
    steps(CORE_TICK_HZ);
    assert_int_equal(value(SET_VOLUME), 100);
}

static void test_at_least_one_mode_stays_enabled(void **state)
{
    (void)state;
    go_to(MENU_GAME);
    go_to(MENU_MODES);
    for (uint32_t bit = 0; bit < CHOICE_COUNT; bit++) {
        take(bit);
    }
    assert_int_equal(value(SET_MODES), 1 << CHOICE_LAB);
    take(0);
    assert_int_equal(value(SET_MODES), 1 << CHOICE_LAB | 1 << MODE_FESTIVAL);
    assert_int_equal(core.config.modes, value(SET_MODES));
}

static void test_fish_count_players_and_language_apply_at_the_next_attract(void **state)
{
    (void)state;
    go_to(MENU_GAME);
    const uint32_t before = core.world.tank.fish_count;
    take(row_of(MENU_GAME, SET_FISH));
    take(row_of(MENU_GAME, SET_PLAYERS));
    take(row_of(MENU_GAME, SET_LANGUAGE));
    assert_int_equal(core.world.tank.fish_count, before);
    /* The selected language must be used immediately. */
    assert_int_equal(core.game.language, LANGUAGE_EN);
    go_back();
    go_back();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(core.world.tank.fish_count, 1);
    assert_true(core.world.bowl[1].present && !core.world.bowl[2].present);
}

/* ---- The ledger ----------------------------------------------------------------------------- */

static void test_several_changes_of_a_setting_give_one_entry_at_rest(void **state)
{
    (void)state;
    const uint32_t before = output.entry_id;
    go_to(MENU_MONEY);
    point_at(row_of(MENU_MONEY, SET_PRICE));
    for (uint32_t i = 0; i < 12u; i++) {
        push(INPUT_TEST);
    }
    assert_int_equal(output.entry_id, before);
    assert_false(settings_edit_is_saved(&core.game.accounts.ledger, &core.game.settings_edit,
                                        &core.config.persistent.settings));
    steps(SETTINGS_EDIT_REST_TICKS);
    assert_int_equal(output.entry_id, before + 1u);
    assert_int_equal(newest()->kind, LEDGER_SETTING);
    assert_int_equal(newest()->detail | newest()->count << 8, SET_PRICE);
    assert_int_equal(newest()->value, 13);
    assert_false(settings_edit_is_saved(&core.game.accounts.ledger, &core.game.settings_edit,
                                        &core.config.persistent.settings));
    save_all();
    assert_true(settings_edit_is_saved(&core.game.accounts.ledger, &core.game.settings_edit,
                                       &core.config.persistent.settings));
}

static void test_a_change_that_is_reversed_gives_no_entry(void **state)
{
    (void)state;
    const uint32_t before = output.entry_id;
    go_to(MENU_SOUND);
    take(row_of(MENU_SOUND, SET_VOLUME));
    push(INPUT_LEFT);
    steps(CORE_TICK_HZ);
    assert_int_equal(output.entry_id, before);
    assert_true(settings_edit_is_saved(&core.game.accounts.ledger, &core.game.settings_edit,
                                       &core.config.persistent.settings));
}

static void fill_the_ring(void)
{
    while (ledger_has_room(&core.game.accounts.ledger, LEDGER_SETTING)) {
        ledger_write(&core.game.accounts, core.game.tick,
                     &(struct ledger_entry){ .kind = LEDGER_HEALTH }, &output);
    }
}

static void test_a_full_ring_and_a_closed_menu_lose_no_setting(void **state)
{
    (void)state;
    go_to(MENU_SOUND);
    take(row_of(MENU_SOUND, SET_VOLUME));
    fill_the_ring();
    const uint32_t full = output.entry_id;
    go_back();
    go_back();
    steps(5u * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(output.entry_id, full);
    assert_int_equal(core.game.accounts.ledger.uncommitted, 0);
    /* The store has now saved all entries, so the ring buffer has room for the entry of the
     * setting. */
    save_all();
    step();
    assert_int_equal(output.entry_id, full + 1u);
    assert_int_equal(newest()->kind, LEDGER_SETTING);
    assert_int_equal(newest()->value, 85);
}

/* ---- Confirmations -------------------------------------------------------------------------- */

static void test_a_factory_reset_requires_a_confirmation(void **state)
{
    (void)state;
    go_to(MENU_SOUND);
    take(row_of(MENU_SOUND, SET_VOLUME));
    go_back();
    steps(CORE_TICK_HZ);
    core.game.accounts.ledger.balance.paid = 3;
    go_to(MENU_UPKEEP);
    go_to(MENU_FACTORY);
    const uint32_t before = output.entry_id;
    /* CONFIRM_BACK is preselected, so this accidental press resets nothing. */
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_UPKEEP);
    assert_int_equal(output.entry_id, before);
    go_to(MENU_FACTORY);
    take(CONFIRM_YES);
    assert_int_equal(menu()->page, MENU_UPKEEP);
    assert_int_equal(newest()->id, before + 1u);
    assert_int_equal(newest()->kind, LEDGER_FACTORY);
    /* The ledger entry of the reset contains the number of deleted paid credits. These credits
     * count as expired. */
    assert_int_equal(newest()->count, 3);
    assert_int_equal(core.game.accounts.audits.count[AUDIT_EXPIRED], 3);
    assert_int_equal(output.commands[(output.command_count - 1u) % CONTROLLER_COMMAND_MAX].kind,
                     COMMAND_RESTART);
    assert_int_equal(newest()->balance.paid, 0);
    assert_int_equal(core.game.accounts.ledger.balance.paid, 0);
    assert_int_equal(value(SET_VOLUME), 80);
    steps(CORE_TICK_HZ);
    /* One ledger entry resets all settings, so no entries of single settings may follow. */
    assert_int_equal(output.entry_id, before + 1u);
}

static void test_no_reset_happens_without_room_in_the_ledger(void **state)
{
    (void)state;
    go_to(MENU_SOUND);
    take(row_of(MENU_SOUND, SET_VOLUME));
    go_back();
    steps(CORE_TICK_HZ);
    core.game.accounts.ledger.balance.paid = 3;
    go_to(MENU_UPKEEP);
    go_to(MENU_FACTORY);
    fill_the_ring();
    take(CONFIRM_YES);
    /* The ring buffer of unsaved ledger entries is full. Therefore nothing is reset, and the
     * confirmation page stays open. */
    assert_int_equal(menu()->page, MENU_FACTORY);
    assert_int_equal(core.game.accounts.ledger.balance.paid, 3);
    assert_int_equal(value(SET_VOLUME), 85);
}

static void test_a_reset_of_the_audits_is_an_entry_with_the_counts(void **state)
{
    (void)state;
    static const struct {
        uint8_t page, group;
        uint32_t audit;
    } books[] = {
        { MENU_EARNINGS, AUDIT_GROUP_MONEY, AUDIT_COINS_1 },
        { MENU_PLAYS, AUDIT_GROUP_PLAY, AUDIT_CAUGHT },
        { MENU_HOURS, AUDIT_GROUP_PLAY, AUDIT_HOUR + 20 },
        { MENU_MACHINE, AUDIT_GROUP_MACHINE, AUDIT_UP_S },
    };
    go_to(MENU_BOOKS);
    for (size_t i = 0; i < sizeof books / sizeof books[0]; i++) {
        memset(&core.game.accounts.audits, 0, sizeof core.game.accounts.audits);
        core.game.accounts.audits.count[books[i].audit] = 40;
        core.game.accounts.audits.count[books[i].audit + 1u] = 2;
        go_to(books[i].page);
        const uint32_t before = output.entry_id;
        /* BOOK_BACK is preselected, so this press only leaves the page. */
        push(INPUT_TEST);
        go_to(books[i].page);
        take(BOOK_RESET);
        assert_int_equal(menu()->page, MENU_RESET);
        /* CONFIRM_BACK is preselected, so this press resets nothing. */
        push(INPUT_TEST);
        assert_int_equal(menu()->page, books[i].page);
        assert_int_equal(output.entry_id, before);
        take(BOOK_RESET);
        take(CONFIRM_YES);
        assert_int_equal(menu()->page, books[i].page);
        assert_int_equal(output.entry_id, before + 1u);
        assert_int_equal(newest()->kind, LEDGER_RESET);
        assert_int_equal(newest()->detail, books[i].group);
        assert_int_equal(newest()->value, 42);
        save_all();
        go_back();
    }
}

static void test_a_restart_is_requested_once_after_a_delay(void **state)
{
    (void)state;
    go_to(MENU_UPKEEP);
    go_to(MENU_RESTART);
    push(INPUT_TEST);
    assert_int_equal(output.command_count, 0);
    go_to(MENU_RESTART);
    take(CONFIRM_YES);
    assert_int_equal(output.command_count, 1);
    assert_int_equal(output.commands[0].kind, COMMAND_RESTART);
}

/* ---- The PIN -------------------------------------------------------------------------------- */

static void type(uint32_t pin)
{
    for (uint32_t i = 0, digit = 1000; i < MENU_PIN_DIGITS; i++, digit /= 10u) {
        take((pin / digit % 10u + 9u) % 10u);
    }
}

static int setup_locked(void **state)
{
    setup(state);
    settings_reset(&core.config.persistent.settings);
    core.config.persistent.settings.value[SET_PIN] = 407;
    settings_edit_init(&core.game.settings_edit, &core.config);
    input.store_well = 1;
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_PIN);
    return 0;
}

static void test_the_menu_opens_only_with_its_pin(void **state)
{
    (void)state;
    type(407);
    assert_int_equal(menu()->page, MENU_TOP);
}

static void test_each_wrong_pin_doubles_the_delay(void **state)
{
    (void)state;
    uint32_t wait = 5u * CORE_TICK_HZ;
    for (uint32_t tries = 0; tries < 7u; tries++) {
        type(408);
        assert_int_equal(menu()->page, MENU_PIN);
        /* After a wrong PIN there is a delay of at least 5 s, in which the right PIN is rejected
         * too. If entering the digits took longer than the delay, there is nothing to check. */
        type(407);
        if (menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick) > 0) {
            assert_int_equal(menu()->page, MENU_PIN);
        }
        core.game.menu.act_tick = core.game.tick;
        core.game.settings_edit.pin_tick = core.game.tick - wait + 1u;
        assert_int_equal(menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick), 1);
        core.game.settings_edit.pin_tick--;
        assert_int_equal(menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick), 0);
        wait = wait < 160u * CORE_TICK_HZ ? 2u * wait : wait;
        take(PIN_ERASE);
    }
    type(407);
    assert_int_equal(menu()->page, MENU_TOP);
    assert_int_equal(core.game.settings_edit.pin_wrong, 0);
}

static void test_leaving_the_menu_does_not_shorten_the_delay(void **state)
{
    (void)state;
    type(1);
    take(PIN_BACK);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    /* Waits until a new session has started. The delay after the wrong PIN must continue in this
     * session. */
    for (uint32_t i = 0; i < SESSION_FADE_TICKS + 2u; i++) {
        core_tick(&core, &input, &output);
    }
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_PIN);
    assert_true(menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick) > 0);
}

/* After a power cut, the remaining delay must be computed from the stored ledger entries. */
static void test_a_power_cut_does_not_shorten_the_delay(void **state)
{
    (void)state;
    for (uint32_t tries = 0; tries < 3u; tries++) {
        core.game.settings_edit.pin_tick = core.game.tick - 160u * CORE_TICK_HZ;
        type(408);
        assert_int_equal(newest()->kind, LEDGER_PIN);
        assert_int_equal(newest()->detail, 0);
    }
    static struct core_config config;
    config = core.config;
    config.session = (struct game_session){ 0 };
    config.persistent.audits = core.game.accounts.audits;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_PIN);
    assert_in_range(menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick),
                    18u * CORE_TICK_HZ, 20u * CORE_TICK_HZ);
    type(407);
    assert_int_equal(menu()->page, MENU_PIN);
    core.game.settings_edit.pin_tick = core.game.tick - 20u * CORE_TICK_HZ;
    take(PIN_ERASE);
    type(407);
    assert_int_equal(menu()->page, MENU_TOP);
    assert_int_equal(newest()->kind, LEDGER_PIN);
    assert_int_equal(newest()->detail, 1);
    assert_int_equal(core.game.accounts.audits.count[AUDIT_WRONG_PINS], 0);
}

/* The delay must be at most 160 s, however many wrong PINs are stored. */
static void test_the_delay_after_wrong_pins_is_limited(void **state)
{
    (void)state;
    static struct core_config config;
    config = core.config;
    config.persistent.audits.count[AUDIT_WRONG_PINS] = UINT32_MAX;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick),
                     160u * CORE_TICK_HZ);
    core.game.tick += 160u * CORE_TICK_HZ;
    assert_int_equal(menu_pin_wait_ticks(&core.game.settings_edit, core.game.tick), 0);
}

static void test_pin_digits_are_shown_only_where_they_are_entered(void **state)
{
    (void)state;
    static struct scene scene;
    take(3);
    core_scene(&core, &scene);
    assert_int_equal(scene.menu.pin_count, 1);
    assert_int_equal(scene.menu.pin, 0);
    take(PIN_ERASE);
    type(407);
    go_to(MENU_UPKEEP);
    go_to(MENU_NEW_PIN);
    take(3);
    core_scene(&core, &scene);
    assert_int_equal(scene.menu.pin, 4);
}

static void test_a_new_pin_is_required_and_0000_disables_it(void **state)
{
    (void)state;
    type(407);
    go_to(MENU_UPKEEP);
    go_to(MENU_NEW_PIN);
    type(9051);
    /* The stored value is negative, which means that it is a hash. The setting therefore does not
     * reveal the PIN. */
    assert_true(value(SET_PIN) < 0);
    assert_true(pin_matches(value(SET_PIN), 9051));
    assert_int_equal(menu()->page, MENU_UPKEEP);
    go_to(MENU_NEW_PIN);
    type(0);
    assert_int_equal(value(SET_PIN), 0);
    go_back();
    go_back();
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_TOP);
}

static void test_an_unfinished_pin_entry_does_not_block_the_kiosk(void **state)
{
    (void)state;
    steps(MENU_PIN_IDLE_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

#define IN_MENU(test) cmocka_unit_test_setup(test, setup_menu)
#define LOCKED(test) cmocka_unit_test_setup(test, setup_locked)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_MENU(test_an_activation_increments_a_value_and_wraps_around),
        IN_MENU(test_the_level_of_the_menu_is_the_level_of_the_next_round),
        IN_MENU(test_the_menu_of_an_older_format_lacks_the_rows_of_newer_settings),
        IN_MENU(test_the_footer_decrements_a_value_and_restores_the_default),
        IN_MENU(test_a_setting_changed_elsewhere_enables_its_default),
        IN_MENU(test_an_unchanged_setting_is_not_shown_as_saved),
        IN_MENU(test_every_setting_reaches_every_value_of_its_range),
        IN_MENU(test_every_setting_is_on_exactly_one_page),
        IN_MENU(test_a_held_button_repeats_fast_and_stops_at_the_end),
        IN_MENU(test_left_lowers_and_right_raises_the_highlighted_value),
        IN_MENU(test_a_held_left_repeats_down_to_the_smallest_value),
        IN_MENU(test_a_dip_on_an_arrow_changes_the_value_in_its_direction),
        IN_MENU(test_a_poi_under_water_repeats_the_change),
        IN_MENU(test_at_least_one_mode_stays_enabled),
        IN_MENU(test_fish_count_players_and_language_apply_at_the_next_attract),
        IN_MENU(test_several_changes_of_a_setting_give_one_entry_at_rest),
        IN_MENU(test_a_change_that_is_reversed_gives_no_entry),
        IN_MENU(test_a_full_ring_and_a_closed_menu_lose_no_setting),
        IN_MENU(test_a_factory_reset_requires_a_confirmation),
        IN_MENU(test_no_reset_happens_without_room_in_the_ledger),
        IN_MENU(test_a_reset_of_the_audits_is_an_entry_with_the_counts),
        IN_MENU(test_a_restart_is_requested_once_after_a_delay),
        LOCKED(test_the_menu_opens_only_with_its_pin),
        LOCKED(test_a_power_cut_does_not_shorten_the_delay),
        LOCKED(test_the_delay_after_wrong_pins_is_limited),
        LOCKED(test_each_wrong_pin_doubles_the_delay),
        LOCKED(test_leaving_the_menu_does_not_shorten_the_delay),
        LOCKED(test_pin_digits_are_shown_only_where_they_are_entered),
        LOCKED(test_a_new_pin_is_required_and_0000_disables_it),
        LOCKED(test_an_unfinished_pin_entry_does_not_block_the_kiosk),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
