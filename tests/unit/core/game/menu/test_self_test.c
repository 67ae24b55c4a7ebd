/* test_self_test.c -- checks the kiosk's self-test. A row may be shown as good only after its
 * check. The kiosk is ready when all rows are good. Each failure must be named. */
#include <string.h>

#include "core/game/menu/menu_pages.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"
#include "tests/unit/support/menu_tag.h"

static struct scene scene;
static uint8_t state_of[SELF_CHECKS];

/* Health values of a machine that has no fault. */
static const struct scene_machine well = {
    .is_checked = 1,
    .keeps = KEEPS_PROVEN,
    .watch = WATCH_OK,
    .has_backup = 1,
    .backup_min = 12,
    .room_mib = 4096,
    .has_heat = 1,
    .heat_margin_c = 25,
};

static const struct menu *menu(void)
{
    return &core.game.menu;
}

static void push(uint32_t button)
{
    press(button);
    steps(MENU_TAKE_TICKS);
}

static void take(uint32_t tag)
{
    for (uint32_t i = 0; menu()->tag[menu()->page] != tag && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
}

static int setup_page(void **state)
{
    setup(state);
    store_is_late = 0;
    settings_reset(&core.config.persistent.settings);
    settings_edit_init(&core.game.settings_edit, &core.config);
    memset(&scene, 0, sizeof scene);
    scene.devices.frames_a_second = 60;
    scene.devices.machine = well;
    scene.devices.lines[0] = 'x';
    core.config.persistent.settings.value[SET_PLAY] = PLAY_PAID;
    settings_edit_init(&core.game.settings_edit, &core.config);
    input.store_well = 1;
    input.day = 9000;
    push(INPUT_TEST);
    take(menu_tag_of(MENU_SELF_TEST));
    assert_int_equal(menu()->page, MENU_SELF_TEST);
    return 0;
}

static uint32_t judge(void)
{
    menu_show(&core.game, &core.config, &scene.menu);
    return self_test_result(&scene, state_of);
}

/* Reports the newest ledger entry as saved, as a store that works does. */
static void save(void)
{
    input.record_saved_id = output.entry_id;
    step();
}

static void wave(uint32_t slot)
{
    for (uint32_t i = 0; i < 8u; i++) {
        const vec3 at_m = v3(i & 1u ? 0.05f : 0.0f, i & 2u ? 0.12f : 0.07f, i & 4u ? 0.05f : 0.0f);
        input.poi[slot] = (struct poi_input){ .link = POI_SOURCE_LIVE,
                                              .has_wrist = 1,
                                              .target.position_m = at_m };
        step();
    }
}

static void press_all(void)
{
    push(INPUT_START | INPUT_OK);
    push(INPUT_LEFT);
    push(INPUT_RIGHT);
    push(INPUT_SERVICE);
    take(SELF_YES);
    take(SELF_YES);
}

static void drop_a_coin(void)
{
    input.coin_count[0] = 1;
    step();
    input.coin_count[0] = 0;
}

static void try_all(void)
{
    steps(2);
    save();
    wave(0);
    press_all();
    drop_a_coin();
}

static void test_the_result_is_ready_after_every_check(void **state)
{
    (void)state;
    assert_true(judge() < SELF_CHECKS);
    try_all();
    assert_int_equal(judge(), SELF_CHECKS);
    for (uint32_t i = 0; i < SELF_CHECKS; i++) {
        assert_int_equal(state_of[i], SELF_GOOD);
    }
    assert_int_equal(
        core.game.accounts.ledger.balance.units + core.game.accounts.ledger.balance.paid, 0);
}

static void test_a_manual_check_is_requested_until_it_is_done(void **state)
{
    (void)state;
    steps(2);
    save();
    steps(30u * CORE_TICK_HZ);
    judge();
    static const uint8_t asks[] = { SELF_SOUND, SELF_LAMP, SELF_BUTTONS, SELF_COINS };
    for (size_t i = 0; i < sizeof asks; i++) {
        assert_int_equal(state_of[asks[i]], SELF_QUERY);
    }
    /* The check SELF_POIS fails, because no poi is connected. */
    assert_int_equal(state_of[SELF_POIS], SELF_BAD);
    wave(0);
    judge();
    assert_int_equal(state_of[SELF_POIS], SELF_GOOD);
}

static void test_a_store_that_saves_nothing_is_named_within_20_s(void **state)
{
    (void)state;
    store_is_late = 1;
    take(SELF_AGAIN);
    steps(5u * CORE_TICK_HZ);
    judge();
    assert_int_equal(state_of[SELF_STORE], SELF_WAITS);
    steps(6u * CORE_TICK_HZ);
    wave(0);
    press_all();
    drop_a_coin();
    assert_int_equal(judge(), SELF_STORE);
    assert_int_equal(state_of[SELF_STORE], SELF_BAD);
    /* If the store saves the entry later, the check must pass. */
    save();
    assert_int_equal(judge(), SELF_CHECKS);
}

static void test_each_failed_check_is_named(void **state)
{
    (void)state;
    try_all();
    input.day = 0;
    step();
    assert_int_equal(judge(), SELF_CLOCK);
    /* A clock that is not set must give a warning (SELF_WARN), not a failure. */
    assert_int_equal(state_of[SELF_CLOCK], SELF_WARN);
    input.day = 9000;
    step();
    scene.devices.frames_a_second = 12;
    assert_int_equal(judge(), SELF_DISPLAY);
    assert_int_equal(state_of[SELF_DISPLAY], SELF_BAD);
    scene.devices.frames_a_second = 0;
    assert_int_equal(judge(), SELF_DISPLAY);
    assert_int_equal(state_of[SELF_DISPLAY], SELF_WAITS);
    scene.devices.frames_a_second = 60;
    scene.devices.files_refused = 1;
    assert_int_equal(judge(), SELF_FILES);
    scene.devices.files_refused = 0;
    assert_int_equal(judge(), SELF_CHECKS);
    steps(2u * CORE_TICK_HZ);
    /* If the newest pose is 24 ticks old, the controller sends only five reports per second, which
     * is too slow for play. */
    input.poi[0].age_ticks = 24;
    step();
    assert_int_equal(judge(), SELF_POIS);
    assert_int_equal(state_of[SELF_POIS], SELF_BAD);
}

static void test_the_operators_answers_decide_sound_and_lamps(void **state)
{
    (void)state;
    clear_sounds();
    steps(3u * CORE_TICK_HZ);
    assert_in_range(sounds[SOUND_CALL], 2, 4);
    /* The self-test asks about the lamps after it has asked about the sound. */
    assert_false(self_test_shows(&core.game));
    take(SELF_NO);
    judge();
    assert_int_equal(state_of[SELF_SOUND], SELF_BAD);
    uint32_t lit = 0, shut = 0;
    for (uint32_t i = 0; i < 2u * CORE_TICK_HZ; i++) {
        step();
        lit += output.start_lamp;
        shut += output.coin_lockout;
    }
    assert_int_equal(lit, CORE_TICK_HZ);
    assert_int_equal(shut, CORE_TICK_HZ);
    take(SELF_NO);
    judge();
    assert_int_equal(state_of[SELF_LAMP], SELF_BAD);
    assert_false(menu_enabled(menu()) >> SELF_YES & 1u);
    step();
    /* For this check, the operator must insert a test coin, so the coin slot must be open. */
    assert_int_equal(output.coin_lockout, 0);
    take(SELF_AGAIN);
    judge();
    assert_int_equal(state_of[SELF_SOUND], SELF_QUERY);
}

/* Each row has a check, its expected result, and the health values that must cause this result.
 * Limits are tested on both sides. */
static const struct {
    uint8_t check, expected;
    struct scene_machine but;
} health_rows[] = {
    { SELF_BACKUP, SELF_WARN, { .has_backup = 0 } },
    { SELF_BACKUP, SELF_WARN, { .has_backup = 1, .backup_min = SELF_BACKUP_OLD_MIN } },
    { SELF_BACKUP, SELF_GOOD, { .has_backup = 1, .backup_min = SELF_BACKUP_OLD_MIN - 1u } },
    { SELF_DATA, SELF_WAITS, { .keeps = KEEPS_UNKNOWN } },
    { SELF_DATA, SELF_GOOD, { .keeps = KEEPS_PROVEN } },
    { SELF_DATA, SELF_GOOD, { .keeps = KEEPS_FOLDER } },
    { SELF_DATA, SELF_BAD, { .keeps = KEEPS_MEMORY } },
    { SELF_DATA, SELF_BAD, { .keeps = KEEPS_NOT } },
    { SELF_DATA, SELF_BAD, { .keeps = KEEPS_NOWHERE } },
    { SELF_ROOM, SELF_GOOD, { .room_mib = SELF_ROOM_LOW_MIB } },
    { SELF_ROOM, SELF_WARN, { .room_mib = SELF_ROOM_LOW_MIB - 1u } },
    { SELF_ROOM, SELF_WARN, { .room_mib = SELF_ROOM_BAD_MIB } },
    { SELF_ROOM, SELF_BAD, { .room_mib = SELF_ROOM_BAD_MIB - 1u } },
    /* A machine without a temperature sensor must pass the check. */
    { SELF_HEAT, SELF_GOOD, { .has_heat = 0, .heat_margin_c = -5 } },
    { SELF_HEAT, SELF_GOOD, { .has_heat = 1, .heat_margin_c = SELF_HEAT_NEAR_C } },
    { SELF_HEAT, SELF_WARN, { .has_heat = 1, .heat_margin_c = SELF_HEAT_NEAR_C - 1 } },
    { SELF_HEAT, SELF_WARN, { .has_heat = 1, .heat_margin_c = 1 } },
    { SELF_HEAT, SELF_BAD, { .has_heat = 1, .heat_margin_c = 0 } },
    { SELF_WATCHDOG, SELF_GOOD, { .watch = WATCH_OK } },
    { SELF_WATCHDOG, SELF_WARN, { .watch = WATCH_NONE } },
    { SELF_WATCHDOG, SELF_WARN, { .watch = WATCH_NO_LIMIT } },
    { SELF_WATCHDOG, SELF_BAD, { .watch = WATCH_FAIL } },
    { SELF_STORE, SELF_WARN, { .quarantined = 1 } },
    { SELF_CLOCK, SELF_WARN, { .is_clock_back = 1 } },
};

static void test_every_system_health_row_has_every_state(void **state)
{
    (void)state;
    try_all();
    for (size_t i = 0; i < sizeof health_rows / sizeof health_rows[0]; i++) {
        const struct scene_machine *but = &health_rows[i].but;
        struct scene_machine *machine = &scene.devices.machine;
        *machine = well;
        switch (health_rows[i].check) {
        case SELF_BACKUP:
            machine->has_backup = but->has_backup;
            machine->backup_min = but->backup_min;
            break;
        case SELF_DATA:
            machine->keeps = but->keeps;
            break;
        case SELF_ROOM:
            machine->room_mib = but->room_mib;
            break;
        case SELF_HEAT:
            machine->has_heat = but->has_heat;
            machine->heat_margin_c = but->heat_margin_c;
            break;
        case SELF_WATCHDOG:
            machine->watch = but->watch;
            break;
        default:
            machine->quarantined = but->quarantined;
            machine->is_clock_back = but->is_clock_back;
        }
        const uint32_t next = judge();
        assert_int_equal(state_of[health_rows[i].check], health_rows[i].expected);
        assert_int_equal(next, health_rows[i].expected == SELF_GOOD ? (uint32_t)SELF_CHECKS
                                                                    : health_rows[i].check);
        assert_int_equal(self_test_left(state_of), health_rows[i].expected != SELF_GOOD);
    }
}

/* Simulates the worst case: no health values, a store that never responds, and no displayed frames.
 * After 20 s, each of the checks must have failed. */
static void test_no_automatic_check_is_pending_after_20_s(void **state)
{
    (void)state;
    store_is_late = 1;
    take(SELF_AGAIN);
    const uint32_t begin_tick = menu()->self.begin_tick;
    scene.devices.frames_a_second = 0;
    scene.devices.machine = (struct scene_machine){ 0 };
    steps(SELF_TEST_TICKS - 1u - (core.game.tick - begin_tick));
    judge();
    assert_int_equal(scene.menu.self.seconds_left, 1);
    assert_int_equal(state_of[SELF_DATA], SELF_WAITS);
    step();
    judge();
    assert_int_equal(core.game.tick - begin_tick, 20u * CORE_TICK_HZ);
    assert_int_equal(scene.menu.self.seconds_left, 0);
    static const uint8_t silent[] = { SELF_STORE, SELF_BACKUP, SELF_DATA,
                                      SELF_ROOM,  SELF_HEAT,   SELF_DISPLAY };
    for (size_t i = 0; i < sizeof silent; i++) {
        assert_int_equal(state_of[silent[i]], SELF_BAD);
    }
    /* Only the checks of the files and of the clock have passed. */
    assert_int_equal(self_test_left(state_of), SELF_CHECKS - 2u);
}

/* The self-test must not ask for a coin if the kiosk takes no coins, nor for a lamp that has no
 * line. */
static void test_absent_hardware_is_not_checked(void **state)
{
    (void)state;
    judge();
    assert_int_equal(state_of[SELF_COINS], SELF_QUERY);
    assert_int_equal(state_of[SELF_LAMP], SELF_QUERY);
    core.config.persistent.settings.value[SET_PLAY] = PLAY_FREE;
    scene.devices.lines[0] = '\0';
    judge();
    assert_int_equal(state_of[SELF_COINS], SELF_GOOD);
    assert_int_equal(state_of[SELF_LAMP], SELF_GOOD);
    take(SELF_YES); /* Answers that the test sound was heard. */
    take(SELF_NO);  /* Answers that the lamps did not light up. */
    judge();
    assert_int_equal(state_of[SELF_LAMP], SELF_BAD);
}

/* The page must name a failure before a warning. */
static void test_the_worst_result_is_named_first(void **state)
{
    (void)state;
    scene.devices.machine.quarantined = 1;
    scene.devices.files_refused = 1;
    assert_int_equal(judge(), SELF_SOUND);
    try_all();
    assert_int_equal(judge(), SELF_FILES);
    scene.devices.files_refused = 0;
    assert_int_equal(judge(), SELF_STORE);
}

/* The self-test must not ask for a button that has no GPIO line, because nobody can press it. */
static void test_a_button_without_a_line_is_not_requested(void **state)
{
    (void)state;
    take(SELF_YES);
    push(INPUT_SERVICE);
    push(INPUT_START);
    judge();
    assert_int_equal(state_of[SELF_BUTTONS], SELF_QUERY);
    scene.devices.buttons_missing = INPUT_LEFT | INPUT_RIGHT | INPUT_OK;
    judge();
    assert_int_equal(state_of[SELF_BUTTONS], SELF_GOOD);
}

/* To check the store, the self-test writes an entry that repeats a stored value. This entry must
 * not change any setting. */
static void test_the_store_check_entry_repeats_an_existing_value(void **state)
{
    (void)state;
    const struct settings before = core.config.persistent.settings;
    steps(2);
    const struct ledger_entry *entry = &output.entries[menu()->self.entry_id % LEDGER_RING];
    assert_int_equal(entry->id, menu()->self.entry_id);
    assert_int_equal(entry->kind, LEDGER_SETTING);
    assert_int_equal(entry->detail, SET_VOLUME);
    assert_int_equal(entry->value, before.value[SET_VOLUME]);
    assert_memory_equal(&core.config.persistent.settings, &before, sizeof before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_result_is_ready_after_every_check, setup_page),
        cmocka_unit_test_setup(test_a_manual_check_is_requested_until_it_is_done, setup_page),
        cmocka_unit_test_setup(test_a_store_that_saves_nothing_is_named_within_20_s, setup_page),
        cmocka_unit_test_setup(test_each_failed_check_is_named, setup_page),
        cmocka_unit_test_setup(test_every_system_health_row_has_every_state, setup_page),
        cmocka_unit_test_setup(test_no_automatic_check_is_pending_after_20_s, setup_page),
        cmocka_unit_test_setup(test_the_worst_result_is_named_first, setup_page),
        cmocka_unit_test_setup(test_absent_hardware_is_not_checked, setup_page),
        cmocka_unit_test_setup(test_the_operators_answers_decide_sound_and_lamps, setup_page),
        cmocka_unit_test_setup(test_a_button_without_a_line_is_not_requested, setup_page),
        cmocka_unit_test_setup(test_the_store_check_entry_repeats_an_existing_value, setup_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
