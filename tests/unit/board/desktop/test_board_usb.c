/* test_board_usb.c -- tests the complete desktop board with a USB poi on a simulated bus, from the
 * USB transport and the decoder to the frame loop and the game.
 *
 * A poi that is plugged in gets the first slot. If the poi is unplugged during a round, the round
 * pauses. It continues after the poi is back, and no credit is lost. The tests cover all orders of
 * the bus events. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include <SDL.h>

#include "core/game/control/controller.h"
#include "core/game/phases.h"
#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/sim/storage_sim.h"
#include "platform/board.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/balance.h"
#include "tests/unit/support/usb/usb_fixture.h"

#define FRAME_US 8000
/* Timeout in frames: twelve seconds, which is long enough on a machine that also runs other
 * tests. */
#define FRAMES_MAX 1500u

static struct {
    struct storage_sim storage;
    struct hal hal;
    /* Devices of the board, including its real display and store. `hal` is a copy of them in which
     * other devices replace the display and the store. */
    struct hal real;
    struct kiosk kiosk;
    uint32_t poi;     /* Index of the poi on the simulated bus. */
    uint8_t is_in;    /* 1 if the poi is plugged in. */
    uint8_t sequence; /* Sequence number of the next report. */
} rig;

static const struct kiosk_config config = {
    .core = { .seed = 3, .fish_count = 20, .credit_coins = 1 },
};

static int open_stall_at(const char *folder)
{
    usb_sim_begin(NULL);
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    const struct board_options options = {
        .poi = BOARD_POI_AUTO,
        .width = 320,
        .height = 240,
        .mute = 1,
        .data_dir = folder,
        .view = tank_preset(TANK_PRESET_FESTIVAL)->view,
    };
    board_open(&rig.hal, &options);
    rig.is_in = 0;
    const int result = kiosk_init(&rig.kiosk, &rig.hal, &config);
    /* Replaces the display, because drawing would take longer than all other work. */
    rig.real = rig.hal;
    rig.hal.display = null_hal("not drawn").display;
    rig.hal.storage = storage_sim_device(&rig.storage);
    return result;
}

static int open_fixture(void **state)
{
    (void)state;
    return open_stall_at(NULL);
}

static int close_fixture(void **state)
{
    (void)state;
    rig.hal.display = rig.real.display;
    rig.hal.storage = rig.real.storage;
    board_close(&rig.hal);
    assert_int_equal(usb_sim_end(), 0);
    assert_int_equal(usb_sim_breaches(), 0);
    return 0;
}

static void plug(void)
{
    rig.poi = usb_sim_plug(&unbound_poi, 1);
    rig.is_in = 1;
}

static void unplug(enum usb_sim_unplug_order how)
{
    rig.is_in = 0;
    usb_sim_unplug(rig.poi, how);
}

/* Sends the pose of a poi that hovers over the middle of the tank. */
static void send_pose(void)
{
    uint8_t bytes[POI_REPORT_SIZE];
    const struct poi_report report = {
        .target.position_m = v3(0.0f, 0.05f + 0.001f * (float)(rig.sequence % 5), 0.0f),
        .sequence = rig.sequence++,
    };
    poi_report_encode(&report, bytes);
    usb_sim_report(rig.poi, bytes, sizeof bytes);
}

static void frame(void)
{
    if (rig.is_in) {
        send_pose();
    }
    usleep(FRAME_US);
    assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
}

static bool is_on_usb(void)
{
    return rig.kiosk.input.poi[0].link == POI_SOURCE_LIVE && rig.kiosk.input.poi[0].has_wrist;
}

static bool is_lost(void)
{
    return rig.kiosk.input.poi[0].link == POI_SOURCE_LOST;
}

static bool is_in_round(void)
{
    return rig.kiosk.core.game.phase == PHASE_ROUND;
}

static bool is_held(void)
{
    return player_has_poi(&rig.kiosk.core.world, 0);
}

static void until(bool (*holds)(void))
{
    for (uint32_t i = 0; i < FRAMES_MAX && !holds(); i++) {
        frame();
    }
    assert_true(holds());
}

static void begin_round(void)
{
    rig.kiosk.input.coin_count[0] = 2;
    frame();
    rig.kiosk.input.pressed = INPUT_START;
    until(is_in_round);
    until(is_held);
}

static void test_a_new_poi_gets_the_first_slot_of_the_mouse(void **state)
{
    (void)state;
    frame();
    assert_false(rig.kiosk.input.poi[0].has_wrist);
    /* The mouse controls the poi of slot 0. */
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
    plug();
    until(is_on_usb);
    /* The mouse has moved to slot 1. The slot has no input yet, because the mouse was not moved
     * since. */
    assert_int_equal(rig.kiosk.input.poi[1].link, POI_SOURCE_ABSENT);
    assert_int_equal(rig.kiosk.faults.poi, 0);
    assert_true(rig.kiosk.report_wait.count > 0);
}

static void test_the_mouse_keeps_its_slot_during_a_round(void **state)
{
    (void)state;
    begin_round();
    plug();
    for (uint32_t i = 0; i < 100; i++) {
        frame();
        assert_false(rig.kiosk.input.poi[0].has_wrist);
    }
    assert_true(is_in_round());
}

static void test_a_usb_poi_gets_force_output(void **state)
{
    (void)state;
    plug();
    until(is_on_usb);
    for (uint32_t i = 0; i < FRAMES_MAX && usb_sim_seen(rig.poi).outs == 0; i++) {
        frame();
    }
    const struct usb_sim_seen seen = usb_sim_seen(rig.poi);
    assert_true(seen.outs > 0);
    assert_int_equal(seen.out_size, POI_FORCE_SIZE);
    assert_int_equal(seen.out[0], POI_FORCE_ID);
}

/* Unplugs the poi during a round, in the order `how` of bus events, and plugs it in again. Prints
 * the time from plugging in to the first pose that the game receives. */
static void lose_and_find(enum usb_sim_unplug_order how)
{
    const uint32_t credits = balance_credits(&rig.kiosk.core);
    unplug(how);
    if (how == USB_SIM_LATE) {
        usb_sim_announce(rig.poi);
    }
    until(is_lost);
    assert_false(is_held());
    for (uint32_t i = 0; i < 20; i++) {
        frame();
        assert_true(is_in_round());
    }
    const uint64_t plugged_ns = clock_device().ops->now_ns(NULL);
    plug();
    until(is_on_usb);
    const uint64_t back_ns = clock_device().ops->now_ns(NULL) - plugged_ns;
    until(is_held);
    print_message("back in the input after %.1f ms\n", (double)back_ns * 1e-6);
    assert_true(is_in_round());
    assert_int_equal(balance_credits(&rig.kiosk.core), credits);
}

static void test_a_round_pauses_while_the_poi_is_unplugged(void **state)
{
    (void)state;
    plug();
    until(is_on_usb);
    begin_round();
    for (uint32_t i = 0; i < 8; i++) {
        lose_and_find((enum usb_sim_unplug_order)(i % 4u));
    }
}

static bool has_mouse(void)
{
    return rig.kiosk.input.poi[0].link == POI_SOURCE_LIVE && !rig.kiosk.input.poi[0].has_wrist;
}

/* The mouse must not take over the slot of a poi during a round. In the next game it may get the
 * slot. */
static void test_the_mouse_gets_the_slot_of_an_absent_poi_in_the_next_game(void **state)
{
    (void)state;
    plug();
    until(is_on_usb);
    begin_round();
    unplug(USB_SIM_GONE);
    until(is_lost);
    for (uint32_t i = 0; i < 50; i++) {
        frame();
        assert_true(is_lost());
    }
    /* Sets attract mode directly, because the kiosk would return to it only after one minute. */
    rig.kiosk.core.game.phase = PHASE_ATTRACT;
    rig.kiosk.output.phase = PHASE_ATTRACT;
    until(has_mouse);
}

static void hint_is(const char *text)
{
    assert_string_equal(SDL_GetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES), text);
}

/* The stored choices of the operator name the devices that the USB driver uses ("plays"). A choice
 * without a serial number must be hidden from SDL from the start. A choice with the serial number
 * A1 must not be hidden, because SDL would then hide all devices of this product. */
static void test_a_stored_choice_is_excluded_from_sdl_at_the_start(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-board-XXXXXX", command[64], path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/usb.txt", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("plays 054c:09cc\nplays 0e6f:0180:A1\nrests 057e:2009\n", file);
    fclose(file);
    assert_int_equal(open_stall_at(folder), CORE_OK);
    hint_is("0x054c/0x09cc,");
    for (uint32_t i = 0; i < 20; i++) {
        frame();
        hint_is("0x054c/0x09cc,");
    }
    close_fixture(NULL);
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_new_poi_gets_the_first_slot_of_the_mouse,
                                        open_fixture, close_fixture),
        cmocka_unit_test_setup_teardown(test_the_mouse_keeps_its_slot_during_a_round, open_fixture,
                                        close_fixture),
        cmocka_unit_test_setup_teardown(test_a_usb_poi_gets_force_output, open_fixture,
                                        close_fixture),
        cmocka_unit_test_setup_teardown(test_a_round_pauses_while_the_poi_is_unplugged,
                                        open_fixture, close_fixture),
        cmocka_unit_test_setup_teardown(
            test_the_mouse_gets_the_slot_of_an_absent_poi_in_the_next_game, open_fixture,
            close_fixture),
        cmocka_unit_test(test_a_stored_choice_is_excluded_from_sdl_at_the_start),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
