/* test_board_usb.c -- the whole wiring with a poi on USB: board, transport, decoder, frame loop and
 * game, over the stand's bus. Plugged in while the stall is open it gets the first seat; pulled out
 * in mid-round in any of the ways there are, the round waits and goes on, and no credit is lost. */
#include <setjmp.h>
#include <stdarg.h>
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
#include "tests/unit/support/purse.h"
#include "tests/unit/support/usb_kinds.h"

#define FRAME_US 8000
#define FRAMES_MAX 1500u /* Twelve seconds: a machine that is busy with other tests. */

static struct {
    struct storage_sim storage;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t poi;     /* On the stand; */
    uint8_t is_in;    /* while it is plugged in ... */
    uint8_t sequence; /* ... it speaks. */
} stall;

static const struct kiosk_config config = {
    .core = { .seed = 3, .fish_count = 20, .credit_coins = 1 },
};

static int open_stall_at(const char *folder)
{
    stand_begin(NULL);
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    const struct board_options options = {
        .poi = BOARD_POI_AUTO,
        .width = 320,
        .height = 240,
        .mute = 1,
        .data_dir = folder,
        .view = tank_preset(TANK_PRESET_FESTIVAL)->view,
    };
    board_open(&stall.hal, &options);
    stall.is_in = 0;
    return kiosk_init(&stall.kiosk, &stall.hal, &config);
}

static int open_stall(void **state)
{
    (void)state;
    return open_stall_at(NULL);
}

static int close_stall(void **state)
{
    (void)state;
    board_close(&stall.hal);
    assert_int_equal(stand_end(), 0);
    assert_int_equal(stand_breaches(), 0);
    return 0;
}

static void plug(void)
{
    stall.poi = stand_plug(&bench_poi, 1);
    stall.is_in = 1;
}

static void unplug(enum stand_parting how)
{
    stall.is_in = 0;
    stand_unplug(stall.poi, how);
}

/* A hand that hovers over the middle. */
static void say(void)
{
    uint8_t bytes[POI_REPORT_SIZE];
    const struct poi_report report = {
        .target.position_m = v3(0.0f, 0.05f + 0.001f * (float)(stall.sequence % 5), 0.0f),
        .sequence = stall.sequence++,
    };
    poi_report_encode(&report, bytes);
    stand_report(stall.poi, bytes, sizeof bytes);
}

/* Nothing of it is drawn: the picture would take longer than all the rest. */
static void frame(void)
{
    struct hal hal = stall.hal;
    hal.display = null_display("not drawn");
    hal.storage = storage_sim_device(&stall.storage);
    if (stall.is_in) {
        say();
    }
    usleep(FRAME_US);
    assert_int_equal(kiosk_frame(&stall.kiosk, &hal), KIOSK_RUNS);
}

static int sits_on_usb(void)
{
    return stall.kiosk.input.poi[0].link == POI_SOURCE_LIVE && stall.kiosk.input.poi[0].has_wrist;
}

static int is_lost(void)
{
    return stall.kiosk.input.poi[0].link == POI_SOURCE_LOST;
}

static int is_in_round(void)
{
    return stall.kiosk.core.game.phase == PHASE_ROUND;
}

static int is_held(void)
{
    return player_has_poi(&stall.kiosk.core.world, 0);
}

static void until(int (*holds)(void))
{
    for (uint32_t i = 0; i < FRAMES_MAX && !holds(); i++) {
        frame();
    }
    assert_true(holds());
}

static void begin_round(void)
{
    stall.kiosk.input.coin_count[0] = 2;
    frame();
    stall.kiosk.input.pressed = INPUT_START;
    until(is_in_round);
    until(is_held);
}

static void test_a_poi_that_is_plugged_in_gets_the_first_seat_from_the_mouse(void **state)
{
    (void)state;
    frame();
    assert_false(stall.kiosk.input.poi[0].has_wrist);
    assert_int_equal(stall.kiosk.input.poi[0].link, POI_SOURCE_LIVE); /* The mouse. */
    plug();
    until(sits_on_usb);
    assert_int_equal(stall.kiosk.input.poi[1].link,
                     POI_SOURCE_ABSENT); /* Nobody moves the mouse. */
    assert_int_equal(stall.kiosk.faults.poi, 0);
    assert_true(stall.kiosk.report_wait.count > 0);
}

static void test_in_the_middle_of_a_round_the_mouse_keeps_it(void **state)
{
    (void)state;
    begin_round();
    plug();
    for (uint32_t i = 0; i < 100; i++) {
        frame();
        assert_false(stall.kiosk.input.poi[0].has_wrist);
    }
    assert_true(is_in_round());
}

static void test_its_hand_is_made_to_feel_the_water(void **state)
{
    (void)state;
    plug();
    until(sits_on_usb);
    for (uint32_t i = 0; i < FRAMES_MAX && stand_seen(stall.poi).outs == 0; i++) {
        frame();
    }
    const struct stand_seen seen = stand_seen(stall.poi);
    assert_true(seen.outs > 0);
    assert_int_equal(seen.out_size, POI_FEEL_SIZE);
    assert_int_equal(seen.out[0], POI_FEEL_ID);
}

/* The time is told: from the plug to the frame whose input has it again. */
static void lose_and_find(enum stand_parting how)
{
    const uint32_t credits = purse_credits(&stall.kiosk.core);
    unplug(how);
    if (how == STAND_LATE) {
        stand_announce(stall.poi);
    }
    until(is_lost);
    assert_false(is_held());
    for (uint32_t i = 0; i < 20; i++) {
        frame();
        assert_true(is_in_round());
    }
    const uint64_t plugged_ns = clock_device().ops->now_ns(NULL);
    plug();
    until(sits_on_usb);
    const uint64_t back_ns = clock_device().ops->now_ns(NULL) - plugged_ns;
    until(is_held);
    print_message("back in the input after %.1f ms\n", (double)back_ns * 1e-6);
    assert_true(is_in_round());
    assert_int_equal(purse_credits(&stall.kiosk.core), credits);
}

static void test_pulled_out_in_mid_round_the_round_waits_and_goes_on(void **state)
{
    (void)state;
    plug();
    until(sits_on_usb);
    begin_round();
    for (uint32_t i = 0; i < 8; i++) {
        lose_and_find((enum stand_parting)(i % 4u));
    }
}

static int mouse_sits(void)
{
    return stall.kiosk.input.poi[0].link == POI_SOURCE_LIVE && !stall.kiosk.input.poi[0].has_wrist;
}

/* The mouse must not take over a round that a poi began; after it, it may. */
static void test_lost_for_good_the_seat_is_the_mouses_in_the_next_game(void **state)
{
    (void)state;
    plug();
    until(sits_on_usb);
    begin_round();
    unplug(STAND_GONE);
    until(is_lost);
    for (uint32_t i = 0; i < 50; i++) {
        frame();
        assert_true(is_lost());
    }
    stall.kiosk.core.game.phase = PHASE_ATTRACT; /* As after a minute. */
    stall.kiosk.output.phase = PHASE_ATTRACT;
    until(mouse_sits);
}

static void hint_is(const char *text)
{
    assert_string_equal(SDL_GetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES), text);
}

/* From the moment that SDL first looks, and as long as nobody takes the choice back; whom a serial
 * number names is no reason to shut out the others of its kind. */
static void test_what_was_chosen_yesterday_is_barred_from_sdl_from_the_start(void **state)
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
    close_stall(NULL);
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(
            test_a_poi_that_is_plugged_in_gets_the_first_seat_from_the_mouse, open_stall,
            close_stall),
        cmocka_unit_test_setup_teardown(test_in_the_middle_of_a_round_the_mouse_keeps_it,
                                        open_stall, close_stall),
        cmocka_unit_test_setup_teardown(test_its_hand_is_made_to_feel_the_water, open_stall,
                                        close_stall),
        cmocka_unit_test_setup_teardown(test_pulled_out_in_mid_round_the_round_waits_and_goes_on,
                                        open_stall, close_stall),
        cmocka_unit_test_setup_teardown(test_lost_for_good_the_seat_is_the_mouses_in_the_next_game,
                                        open_stall, close_stall),
        cmocka_unit_test(test_what_was_chosen_yesterday_is_barred_from_sdl_from_the_start),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
