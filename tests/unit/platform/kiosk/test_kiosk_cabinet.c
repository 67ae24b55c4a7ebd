/* test_kiosk_cabinet.c -- Tests the commands that the frame loop sends to controllers and to the
 * switches of a cabinet.
 *
 * Each command, switch level and pulse must reach its driver exactly once, even if a frame is long
 * or the driver returns HAL_ERR_BUSY. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/menu/menu_pages.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"

#define MS 1000000ull
#define FRAME_NS 16666667ull
#define SAMPLES 24u
#define ORDERS_MAX 32u
#define ROW 3u

static struct rig {
    struct clock_sim clock;
    struct storage_sim storage;
    struct hal hal;
    struct kiosk kiosk;
    struct button_sample buttons; /* Button sample of the next frame. */
    vec3 at_m[SAMPLES];           /* Positions of the poi that the controller reports in the next
                                     frame, at equal time intervals. */
    uint64_t frame_ns;
    struct controller_command commands[ORDERS_MAX];
    uint32_t command_count;
    int answer; /* Value that each call of the simulated switches returns. */
    uint32_t asked[HAL_SWITCH_COUNT], level[HAL_SWITCH_COUNT], pulses[HAL_SWITCH_COUNT];
} rig;

/* ---- Simulated devices of the test ---------------------------------------------------------- */

static int poll_pose(void *self, struct poi_sample *out, uint32_t max)
{
    (void)self;
    for (uint32_t i = 0; i < SAMPLES && i < max; i++) {
        out[i] = (struct poi_sample){
            .time_ns = rig.clock.now_ns - (SAMPLES - 1u - i) * (rig.frame_ns / SAMPLES),
            .was_stamped = 1,
            .has_wrist = 1,
            .target.position_m = rig.at_m[i],
        };
    }
    return (int)SAMPLES;
}

static int open_controller(void *self)
{
    (void)self;
    return HAL_OK;
}

static int set_force(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_OK;
}

static void look(void *self, const struct view *view,
                 const struct display_settings *display_settings, bool scoops)
{
    (void)self;
    (void)view;
    (void)display_settings;
    (void)scoops;
}

static const char *describe(void *self)
{
    (void)self;
    return "a cabinet of paper";
}

static int poll_buttons(void *self, struct button_sample *out)
{
    (void)self;
    *out = rig.buttons;
    rig.buttons = (struct button_sample){ 0 };
    return HAL_OK;
}

static int poll_controllers(void *self, struct controller_status *out)
{
    (void)self;
    *out = (struct controller_status){ .state[ROW] = CONTROLLER_FREE };
    return HAL_OK;
}

static const char *name(void *self, uint32_t row)
{
    (void)self;
    return row == ROW ? "a stick" : "";
}

static int accept_command(void *self, const struct controller_command *order)
{
    (void)self;
    assert_true(rig.command_count < ORDERS_MAX);
    rig.commands[rig.command_count++] = *order;
    return HAL_OK;
}

static int set(void *self, enum hal_switch which, bool active)
{
    (void)self;
    rig.asked[which]++;
    rig.level[which] = rig.answer == HAL_OK ? (uint32_t)active : rig.level[which];
    return rig.answer;
}

static int pulse(void *self, enum hal_switch which, uint32_t count)
{
    (void)self;
    rig.asked[which]++;
    rig.pulses[which] += rig.answer == HAL_OK ? count : 0u;
    return rig.answer;
}

/* ---- Set-up and frames of the simulated cabinet --------------------------------------------- */

static void hold_pose_at(vec3 at_m)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        rig.at_m[i] = at_m;
    }
}

static uint32_t pending(void *self, enum hal_switch which)
{
    (void)self;
    (void)which;
    return 0;
}

static int set_up(void **state)
{
    static const struct hal_poi_ops poi = { open_controller, poll_pose, set_force, look, describe };
    static const struct hal_buttons_ops buttons = { poll_buttons, describe };
    static const struct hal_controllers_ops desk = { poll_controllers, name, accept_command,
                                                     describe };
    static const struct hal_switches_ops switches = { set, pulse, describe, pending };
    static const struct kiosk_config config = {
        .core = { .seed = 5, .fish_count = 8, .round_s = 10, .credit_coins = 1, .ticket_fish = 1 },
    };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.frame_ns = FRAME_NS;
    rig.level[HAL_COIN_LOCKOUT] = 1;       /* The slot is locked until the kiosk sets this
                                              switch. */
    hold_pose_at(v3(-0.4f, 0.06f, -0.3f)); /* The poi is held at a place where no menu shows an
                                              item. */
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.hal.poi[0] = (struct hal_poi){ .ops = &poi };
    rig.hal.storage = storage_sim_device(&rig.storage);
    rig.hal.buttons = (struct hal_buttons){ .ops = &buttons };
    rig.hal.controllers = (struct hal_controllers){ .ops = &desk };
    rig.hal.switches = (struct hal_switches){ .ops = &switches };
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    return 0;
}

static void frame(uint64_t ns)
{
    rig.frame_ns = ns;
    rig.clock.now_ns += ns;
    assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        frame(FRAME_NS);
    }
}

static void push(uint32_t button)
{
    rig.buttons.pressed = button;
    frames(10);
}

/* ---- Tests of commands to controllers ------------------------------------------------------- */

static vec3 over_tag(uint32_t tag, float y_m)
{
    const struct menu *menu = &rig.kiosk.core.game.menu;
    const struct layout_point canvas = pointer_layout_size(menu->upright);
    const struct layout_box box =
        menu_box(menu->upright, menu->page, false, menu_enabled(menu), tag);
    const vec3 size_m = rig.kiosk.core.world.tank.size_m;
    return v3(size_m.x * ((box.x + 0.5f * box.width) / canvas.x - 0.5f), y_m,
              size_m.z * ((box.y + 0.5f * box.height) / canvas.y - 0.5f));
}

/* Opens the menu page of the only controller and moves the poi over the menu item `tag`. Then
 * selects the first item with the buttons. */
static void open_controller_page(uint32_t tag)
{
    for (uint32_t i = 0; i < 4u; i++) { /* The first press opens the menu. Each other press opens
                                           the page of the first menu item. */
        push(INPUT_TEST);
    }
    assert_int_equal(rig.kiosk.scene.menu.page, MENU_CONTROLLER);
    hold_pose_at(over_tag(tag, 0.06f));
    frames(10);
    while (rig.kiosk.scene.menu.tag != ROW_CHOOSE) {
        push(INPUT_SERVICE);
    }
}

/* A frame of 0.5 s has 60 ticks. TEST is pressed in the first tick and gives the command CHOOSE.
 * The poi dips in the middle of the frame, which gives the command LEARN. Both commands must reach
 * the driver, in this order. */
static void test_all_commands_of_the_longest_frame_are_sent_in_order(void **state)
{
    (void)state;
    open_controller_page(ROW_LEARN);
    for (uint32_t i = SAMPLES / 2u; i < SAMPLES; i++) {
        rig.at_m[i].y = -0.05f;
    }
    rig.buttons.pressed = INPUT_TEST;
    const uint32_t tick = rig.kiosk.core.game.tick;
    frame(500 * MS);
    assert_int_equal(rig.kiosk.core.game.tick - tick, FRAME_PACER_TICKS_MAX);
    assert_int_equal(rig.command_count, 2);
    assert_int_equal(rig.commands[0].kind, COMMAND_CHOOSE);
    assert_int_equal(rig.commands[1].kind, COMMAND_LEARN);
    assert_int_equal(rig.commands[1].row, ROW);
    frames(10);
    assert_int_equal(rig.command_count, 2);
}

/* The poi dips six times in each frame of 0.5 s, so a menu item is chosen several times. Every
 * command of the core must reach the driver. */
static void test_a_trembling_pose_over_a_menu_tag_loses_no_command(void **state)
{
    (void)state;
    open_controller_page(ROW_CHOOSE);
    for (uint32_t i = 0; i < SAMPLES; i++) {
        rig.at_m[i].y = i % 4u < 2u ? 0.06f : -0.05f;
    }
    for (uint32_t i = 1; i <= 5u; i++) {
        rig.buttons.pressed = INPUT_TEST;
        frame(500 * MS);
        assert_int_equal(rig.command_count, rig.kiosk.core.game.menu.command_count);
    }
    assert_in_range(rig.command_count, 15, 25);
    for (uint32_t i = 0; i < rig.command_count; i++) {
        assert_int_equal(rig.commands[i].kind, COMMAND_CHOOSE);
        assert_int_equal(rig.commands[i].row, ROW);
    }
}

/* ---- Tests of switches (coin lockout, meters) ----------------------------------------------- */

static void drop(uint32_t coins)
{
    rig.buttons.coin_count[0] = coins;
    frames(1);
}

static void test_an_accepted_switch_level_is_sent_once(void **state)
{
    (void)state;
    rig.buttons.held = INPUT_DOOR; /* While the door is open, the coin slot must be locked. */
    drop(3);
    assert_int_equal(rig.level[HAL_COIN_LOCKOUT], 1);
    assert_int_equal(rig.asked[HAL_COIN_LOCKOUT], 0);
    assert_int_equal(rig.pulses[HAL_COIN_COUNTER], 3);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 1);
    frames(10);
    assert_int_equal(rig.level[HAL_COIN_LOCKOUT], 0);
    assert_int_equal(rig.asked[HAL_COIN_LOCKOUT], 1);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 1);
}

static void test_a_busy_switch_is_retried_each_frame_without_a_fault(void **state)
{
    (void)state;
    frames(10);
    memset(rig.asked, 0, sizeof rig.asked);
    rig.answer = HAL_ERR_BUSY;
    drop(2);
    frames(4);
    drop(1);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 6);
    assert_int_equal(rig.kiosk.faults.switches, 0);
    rig.answer = HAL_OK;
    frames(5);
    assert_int_equal(rig.pulses[HAL_COIN_COUNTER], 3);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 7);
}

static void test_a_failing_switch_is_retried_each_second(void **state)
{
    (void)state;
    frames(10);
    assert_int_equal(rig.level[HAL_COIN_LOCKOUT], 0);
    memset(rig.asked, 0, sizeof rig.asked);
    rig.answer = HAL_ERR_IO;
    push(INPUT_TEST); /* While the menu is open, the coin slot must be locked. */
    drop(1);
    frames(190); /* The switches have failed for about 3.3 s. Each command is retried once a second,
                    so it was sent at 0, 1, 2 and 3 s. */
    assert_int_equal(rig.asked[HAL_COIN_LOCKOUT], 4);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 4);
    assert_true(rig.kiosk.faults.switches >= 8);
    rig.answer = HAL_OK;
    drop(1);
    frames(60);
    assert_int_equal(rig.level[HAL_COIN_LOCKOUT], 1);
    assert_int_equal(rig.pulses[HAL_COIN_COUNTER], 2);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 5);
}

static void test_an_obsolete_switch_command_is_not_retried(void **state)
{
    (void)state;
    frames(10);
    memset(rig.asked, 0, sizeof rig.asked);
    rig.answer = HAL_ERR_IO;
    rig.buttons.held = INPUT_DOOR;
    frames(1);
    assert_int_equal(rig.asked[HAL_COIN_LOCKOUT], 1);
    rig.answer = HAL_OK;
    frames(120); /* The door is closed again before the retry, so the lockout command is
                    obsolete. */
    assert_int_equal(rig.asked[HAL_COIN_LOCKOUT], 1);
    assert_int_equal(rig.level[HAL_COIN_LOCKOUT], 0);
}

static void test_an_absent_switch_is_never_retried(void **state)
{
    (void)state;
    frames(10);
    memset(rig.asked, 0, sizeof rig.asked);
    rig.answer = HAL_ERR_ABSENT;
    drop(2);
    frames(120);
    assert_int_equal(rig.asked[HAL_COIN_COUNTER], 1);
    assert_int_equal(rig.kiosk.faults.switches, 0);
}

static int next_of_a_replay(void *self, struct input *out)
{
    (void)self;
    *out = (struct input){ .coin_count[0] = 1,
                           .store_well = 1,
                           .record_saved_id = rig.kiosk.output.entry_id,
                           .poi[0].link = POI_SOURCE_LIVE };
    return 1;
}

/* The kiosk plays back a recording, so the core gets the recorded coins, and none that is inserted
 * now. The coin slot must therefore stay locked. The coin meter must not advance, because it
 * counted these coins during the recording. */
static void test_a_replay_does_not_drive_the_coin_lockout_or_the_meters(void **state)
{
    (void)state;
    rig.kiosk.config.source = (struct kiosk_source){ .next = next_of_a_replay };
    frames(20); /* 20 frames are 40 ticks with one coin each. The core requests the lockout only at
                   99 credits. */
    assert_true(rig.kiosk.output.coins_counted > 0);
    assert_int_equal(rig.kiosk.output.coin_lockout, 0);
    assert_int_equal(rig.level[HAL_COIN_LOCKOUT], 1);
    assert_int_equal(rig.pulses[HAL_COIN_COUNTER], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_all_commands_of_the_longest_frame_are_sent_in_order, set_up),
        cmocka_unit_test_setup(test_a_trembling_pose_over_a_menu_tag_loses_no_command, set_up),
        cmocka_unit_test_setup(test_an_accepted_switch_level_is_sent_once, set_up),
        cmocka_unit_test_setup(test_a_busy_switch_is_retried_each_frame_without_a_fault, set_up),
        cmocka_unit_test_setup(test_a_failing_switch_is_retried_each_second, set_up),
        cmocka_unit_test_setup(test_an_obsolete_switch_command_is_not_retried, set_up),
        cmocka_unit_test_setup(test_an_absent_switch_is_never_retried, set_up),
        cmocka_unit_test_setup(test_a_replay_does_not_drive_the_coin_lockout_or_the_meters, set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
