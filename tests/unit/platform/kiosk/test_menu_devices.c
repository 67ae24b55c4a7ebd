/* test_menu_devices.c -- Tests the operator's menu, which has two buttons. In the menu, the
 * operator also teaches the kiosk the axes of a controller.
 *
 * The tests send button presses and raw HID reports, and check the scene and the pose of the ring.
 * The decoder, the mapping store and the frame loop are real. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/menu/menu_pages.h"
#include "core/tank/preset.h"
#include "drivers/hid/controller_manager.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/hid_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/menu_tag.h"

#define FRAME_NS 16666667ull
#define ROW 2u
#define MIDDLE 0.5f

static struct rig {
    struct clock_sim clock;
    struct display_sim display;
    struct hid_wire wire;
    struct hid_device_list_sim device_list;
    struct hid_mapping_store book;
    struct poi_hid poi;
    struct controller_manager desk;
    struct storage_sim storage;
    struct hal hal;
    struct kiosk kiosk;
    struct button_sample buttons; /* Button sample of the next frame. */
    float x, z;                   /* Stick position, each axis in [0, 1]. */
    uint8_t trigger;
    uint32_t lockout, input_coin_pulses, ticket_pulses, lamp; /* Levels and pulse counts that the
                                                                 kiosk last sent to the cabinet. */
} rig;

/* ---- Simulated cabinet with buttons and switches -------------------------------------------- */

static int poll_buttons(void *self, struct button_sample *out)
{
    (void)self;
    *out = rig.buttons;
    rig.buttons = (struct button_sample){ 0 };
    return HAL_OK;
}

static const char *describe_buttons(void *self)
{
    (void)self;
    return "two buttons and a slot";
}

static int set_switch(void *self, enum hal_switch which, bool active)
{
    (void)self;
    *(which == HAL_START_LAMP ? &rig.lamp : &rig.lockout) = (uint32_t)active;
    return HAL_OK;
}

static int pulse_switch(void *self, enum hal_switch which, uint32_t count)
{
    (void)self;
    *(which == HAL_TICKET ? &rig.ticket_pulses : &rig.input_coin_pulses) += count;
    return HAL_OK;
}

static void send_stick(void)
{
    wire_put(&rig.wire, -1, USAGE_X, wire_share(&rig.wire, -1, USAGE_X, rig.x));
    wire_put(&rig.wire, -1, USAGE_Y, wire_share(&rig.wire, -1, USAGE_Y, rig.z));
    wire_send(&rig.wire, wire_put(&rig.wire, -1, USAGE_BUTTON + 1u, rig.trigger));
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        rig.clock.now_ns += FRAME_NS;
        send_stick();
        assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
    }
}

static void push(uint32_t button)
{
    rig.buttons.pressed = button;
    frames(10);
}

static const struct scene_menu *shown(void)
{
    return &rig.display.scene.menu;
}

static void point_at(uint32_t tag)
{
    for (uint32_t i = 0; i < MENU_TAG_MAX && shown()->tag != tag; i++) {
        push(INPUT_SERVICE);
    }
    assert_int_equal(shown()->tag, tag);
}

static uint32_t pending(void *self, enum hal_switch which)
{
    (void)self;
    (void)which;
    return 0;
}

static int set_up(void **state)
{
    static const struct hal_buttons_ops buttons = { poll_buttons, describe_buttons };
    static const struct hal_switches_ops switches = { set_switch, pulse_switch, describe_buttons,
                                                      pending };
    static const struct kiosk_config config = {
        .core = { .seed = 5, .fish_count = 8, .round_s = 10, .credit_coins = 2 }
    };
    struct hid_port_sim *const slots[POI_MAX] = { &rig.wire.port };
    struct poi_hid *const pois[POI_MAX] = { &rig.poi };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.lockout = 1; /* The coin slot is locked until the kiosk opens it. */
    rig.x = rig.z = MIDDLE;
    rig.clock.now_ns = FRAME_NS;
    wire_load(&rig.wire, &rig.clock, "025-ci-xusb-flightstick");
    snprintf(rig.wire.face.identity.name, HID_TEXT_SIZE, "Flight Stick");
    hid_port_sim_plug(&rig.wire.port, NULL); /* Takes the controller out of player slot 0. The next
                                                lines connect it without a slot. */
    hid_device_list_sim_init(&rig.device_list, slots);
    hid_device_list_sim_plug(&rig.device_list, ROW, &rig.wire.face);
    hid_mapping_store_open(&rig.book, NULL, NULL, NULL);
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.hal.display = sim_display_device(&rig.display);
    rig.hal.storage = storage_sim_device(&rig.storage);
    rig.hal.buttons = (struct hal_buttons){ .ops = &buttons };
    rig.hal.switches = (struct hal_switches){ .ops = &switches };
    poi_hid_init(&rig.poi, &rig.wire.port.port, rig.hal.clock, hid_mapping_store_mapper(&rig.book),
                 &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.hal.controllers = controller_manager_init(
        &rig.desk, hid_device_list_sim_device(&rig.device_list), &rig.book, pois);
    rig.hal.poi[0] = poi_hid_devices(&rig.poi).poi;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    frames(2);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    hid_mapping_store_close(&rig.book);
    return 0;
}

static void open_the_row(void)
{
    push(INPUT_TEST);
    assert_int_equal(rig.display.scene.phase, PHASE_MENU);
    point_at(menu_tag_of(MENU_DEVICES));
    push(INPUT_TEST);
    point_at(menu_tag_of(MENU_CONTROLLERS));
    push(INPUT_TEST);
    assert_int_equal(shown()->page, MENU_CONTROLLERS);
    point_at(ROW);
    push(INPUT_TEST);
    assert_int_equal(shown()->page, MENU_CONTROLLER);
}

/* ---- Tests of the quit key, restarts and a late store --------------------------------------- */

static void test_the_quit_key_goes_back_in_the_menu_and_otherwise_ends_the_program(void **state)
{
    (void)state;
    static const uint8_t pages[] = { MENU_CONTROLLERS, MENU_DEVICES, MENU_TOP };
    open_the_row();
    for (uint32_t i = 0; i < sizeof pages; i++) {
        rig.buttons.quit = 1;
        push(0);
        assert_int_equal(shown()->page, pages[i]);
    }
    assert_int_equal(shown()->pressed_count[1], 0); /* The menu page counts presses of LEFT (index
                                                       1). The quit key must not be counted
                                                       there. */
    rig.buttons.quit = 1;
    push(0);
    assert_int_equal(rig.display.scene.phase, PHASE_ATTRACT);
    rig.buttons.quit = 1;
    assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
    rig.buttons.quit = 1;
    assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_QUIT);
}

static void test_a_confirmed_restart_ends_the_loop_and_is_not_a_controller_command(void **state)
{
    (void)state;
    enum kiosk_end end = KIOSK_RUNS;
    push(INPUT_TEST);
    point_at(menu_tag_of(MENU_UPKEEP));
    push(INPUT_TEST);
    point_at(menu_tag_of(MENU_RESTART));
    push(INPUT_TEST);
    push(INPUT_SERVICE); /* SERVICE moves the selection from the answer "back" to the answer
                            "yes". */
    assert_int_equal(shown()->tag, CONFIRM_YES);
    rig.buttons.pressed = INPUT_TEST;
    /* 400 frames are more than 6 s, and the restart waits for the store for at most 5 s. */
    for (uint32_t i = 0; i < 400u && end == KIOSK_RUNS; i++) {
        rig.clock.now_ns += FRAME_NS;
        end = kiosk_frame(&rig.kiosk, &rig.hal);
    }
    assert_int_equal(end, KIOSK_RESTART);
    assert_int_equal(rig.device_list.choose_count + rig.device_list.release_count, 0);
}

/* The store opens only after the kiosk has started. The store then gets the credits that were paid
 * before, and the session restarts. Both must wait until no player and no menu is active. The
 * simulated store needs 30 polls to accept the credits. */
static void test_a_store_that_opens_late_restarts_the_session_when_idle(void **state)
{
    (void)state;
    struct balance *balance = &rig.kiosk.core.game.accounts.ledger.balance;
    push(INPUT_TEST);
    assert_int_equal(rig.display.scene.phase, PHASE_MENU);
    rig.storage.needs_restart = true;
    rig.storage.late_polls = 30;
    balance->paid = 1;
    balance->unlogged = 3;
    frames(10);
    assert_int_equal(rig.storage.late_balance.paid, 0);
    rig.buttons.quit = 1;
    frames(10);
    assert_int_equal(rig.storage.late_balance.paid, 1);
    assert_int_equal(rig.storage.late_balance.unlogged, 3);
    balance->unlogged = 4;
    enum kiosk_end end = KIOSK_RUNS;
    for (uint32_t i = 0; i < 100u && end == KIOSK_RUNS; i++) {
        rig.clock.now_ns += FRAME_NS;
        end = kiosk_frame(&rig.kiosk, &rig.hal);
    }
    assert_int_equal(end, KIOSK_RESTART);
    assert_int_equal(rig.storage.late_balance.paid, 1);
    assert_int_equal(rig.storage.late_balance.unlogged, 4);
}

/* ---- Tests of the names of devices in the menu ---------------------------------------------- */

static void test_controller_and_line_names_are_filled_only_in_the_menu(void **state)
{
    (void)state;
    assert_string_equal(rig.display.scene.devices.lines, "");
    open_the_row();
    assert_non_null(strstr(rig.display.scene.devices.controller[ROW], "Flight Stick"));
    assert_string_equal(rig.display.scene.devices.controller[0], "");
    assert_string_equal(rig.display.scene.devices.lines, "two buttons and a slot");
    assert_int_equal(shown()->controllers.state[ROW], CONTROLLER_FREE);
}

/* ---- Tests of the selection of a controller ------------------------------------------------- */

static void test_a_selected_controller_plays_and_a_released_one_does_not(void **state)
{
    (void)state;
    open_the_row();
    point_at(ROW_CHOOSE);
    push(INPUT_TEST);
    assert_int_equal(rig.device_list.choose_count, 1);
    frames(90); /* The kiosk tries to open an empty slot once a second, so the controller is open
                   after 90 frames. */
    assert_int_equal(shown()->controllers.state[ROW], CONTROLLER_ACTIVE);
    assert_int_equal(rig.kiosk.samplers[0].link, POI_SOURCE_LIVE);
    point_at(ROW_RELEASE);
    push(INPUT_TEST);
    assert_int_equal(rig.device_list.release_count, 1);
    frames(90);
    assert_int_equal(rig.device_list.choose_count, 1);
    assert_int_equal(rig.device_list.release_count, 1); /* Each of the commands must be sent only
                                                           once. */
}

/* ---- Tests of learning the mapping of a stick ----------------------------------------------- */

static void show_step(uint8_t step, float x, float z, uint8_t trigger)
{
    assert_int_equal(shown()->controllers.learn_step, step);
    rig.x = x;
    rig.z = z;
    rig.trigger = trigger;
    frames(60);
    point_at(LEARNS_NEXT);
    push(INPUT_TEST);
}

/* Teaches the kiosk a stick that is mounted backwards, so that the learned x axis is reversed. */
static void learn_backwards(void)
{
    open_the_row();
    point_at(ROW_LEARN);
    push(INPUT_TEST);
    assert_int_equal(shown()->page, MENU_LEARN);
    frames(90);
    show_step(LEARN_REST, MIDDLE, MIDDLE, 0);
    show_step(LEARN_LEFT, 1.0f, MIDDLE, 0);
    show_step(LEARN_RIGHT, 0.0f, MIDDLE, 0);
    show_step(LEARN_FAR, MIDDLE, 1.0f, 0);
    show_step(LEARN_NEAR, MIDDLE, 0.0f, 0);
    show_step(LEARN_DIP, MIDDLE, MIDDLE, 1);
    rig.trigger = 0;
    frames(30);
    assert_int_equal(shown()->controllers.learn_step, LEARN_TRY);
}

/* Moves the stick right. Returns the resulting change of the ring's x position in metres. */
static float way_right_m(void)
{
    rig.x = rig.z = MIDDLE;
    frames(60);
    const float before_m = rig.kiosk.input.poi[0].target.position_m.x;
    rig.x = 1.0f;
    frames(60);
    const float after_m = rig.kiosk.input.poi[0].target.position_m.x;
    rig.x = MIDDLE;
    return after_m - before_m;
}

static void test_a_learned_stick_mapping_is_used_for_play(void **state)
{
    (void)state;
    learn_backwards();
    assert_true(way_right_m() < -0.02f); /* The operator can try the learned mapping before it is
                                            saved, so a stick that is moved right already moves the
                                            ring left. */
    point_at(LEARNS_KEEP);
    push(INPUT_TEST);
    frames(5);
    assert_int_equal(shown()->page, MENU_CONTROLLERS);
    assert_int_equal(shown()->controllers.learn_step, LEARN_NONE);
    assert_non_null(hid_mapping_store_find(&rig.book, &rig.wire.face.identity));
    assert_true(way_right_m() < -0.02f);
}

static void test_an_unsaved_mapping_is_discarded(void **state)
{
    (void)state;
    learn_backwards();
    point_at(LEARNS_END);
    push(INPUT_TEST);
    frames(5);
    assert_int_equal(shown()->page, MENU_CONTROLLER);
    assert_null(hid_mapping_store_find(&rig.book, &rig.wire.face.identity));
    /* A learned controller has no slot until the operator selects it. */
    assert_int_equal(shown()->controllers.state[ROW], CONTROLLER_FREE);
    point_at(ROW_CHOOSE);
    push(INPUT_TEST);
    frames(90);
    assert_true(way_right_m() > 0.02f);
}

static void test_unplugging_a_stick_while_learning_fails_and_the_menu_continues(void **state)
{
    (void)state;
    open_the_row();
    point_at(ROW_LEARN);
    push(INPUT_TEST);
    frames(90);
    show_step(LEARN_REST, MIDDLE, MIDDLE, 0);
    hid_device_list_sim_plug(&rig.device_list, ROW, NULL);
    frames(10);
    assert_int_equal(shown()->controllers.learn_step, LEARN_FAILED);
    point_at(LEARNS_END);
    push(INPUT_TEST);
    assert_int_equal(shown()->page, MENU_CONTROLLER);
    frames(2);
    /* The row of the unplugged controller is empty. */
    assert_int_equal(shown()->controllers.state[ROW], CONTROLLER_NONE);
    point_at(ROW_BACK);
    push(INPUT_TEST);
    assert_int_equal(shown()->page, MENU_CONTROLLERS);
}

/* ---- Tests of the coin slot and the coin meter ---------------------------------------------- */

static void drop(uint32_t coins)
{
    rig.buttons.coin_count[0] = coins;
    frames(2);
}

static void go_back(void)
{
    point_at(menu_tag_count(shown()->page, false) - 1u);
    push(INPUT_TEST);
}

static void test_the_coin_slot_opens_for_test_or_play_and_the_meter_counts_all_coins(void **state)
{
    (void)state;
    assert_int_equal(rig.lockout, 1); /* The coin slot is locked because no controller works. */
    push(INPUT_TEST);
    assert_int_equal(rig.lockout, 1); /* The coin slot stays locked, because no credit can be bought
                                         while the menu is open. */
    point_at(menu_tag_of(MENU_DEVICES));
    push(INPUT_TEST);
    point_at(menu_tag_of(MENU_LINES));
    push(INPUT_TEST);
    assert_int_equal(rig.lockout, 0); /* On this page the operator tests the coin slot, so the slot
                                         is open. */
    drop(7);
    assert_int_equal(shown()->test_coins, 7);
    assert_int_equal(rig.input_coin_pulses, 7);
    assert_int_equal(rig.display.scene.credit.credits + rig.display.scene.credit.units, 0);
    go_back();
    assert_int_equal(rig.lockout, 1);
    go_back();
    go_back();
    open_the_row();
    point_at(ROW_CHOOSE);
    push(INPUT_TEST);
    frames(90);
    drop(1); /* The slot has just been locked. A coin that was already falling still counts as a
                test coin. */
    for (uint32_t i = 0; i < 4; i++) {
        go_back();
    }
    assert_int_equal(rig.display.scene.phase, PHASE_ATTRACT);
    assert_int_equal(rig.lockout, 0);
    drop(3);
    assert_int_equal(rig.input_coin_pulses, 11);
    assert_int_equal(rig.display.scene.credit.credits, 1);
    assert_int_equal(rig.display.scene.credit.units, 1);
    frames(30);
    assert_int_equal(rig.input_coin_pulses, 11);
}

#define IN_CABINET(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_CABINET(test_controller_and_line_names_are_filled_only_in_the_menu),
        IN_CABINET(test_a_confirmed_restart_ends_the_loop_and_is_not_a_controller_command),
        IN_CABINET(test_a_store_that_opens_late_restarts_the_session_when_idle),
        IN_CABINET(test_the_quit_key_goes_back_in_the_menu_and_otherwise_ends_the_program),
        IN_CABINET(test_a_selected_controller_plays_and_a_released_one_does_not),
        IN_CABINET(test_a_learned_stick_mapping_is_used_for_play),
        IN_CABINET(test_an_unsaved_mapping_is_discarded),
        IN_CABINET(test_unplugging_a_stick_while_learning_fails_and_the_menu_continues),
        IN_CABINET(test_the_coin_slot_opens_for_test_or_play_and_the_meter_counts_all_coins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
