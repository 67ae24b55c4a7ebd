/* test_board_slots.c -- tests the player slots of the desktop board with SDL's virtual joysticks. A
 * gamepad that is plugged in gets the first slot, but only between two games. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <SDL.h>
#include <cmocka.h>

#include "core/tank/preset.h"
#include "platform/board.h"

static struct hal hal;

static int open_with(uint8_t poi)
{
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    const struct board_options options = {
        .poi = poi,
        .width = 320,
        .height = 240,
        .mute = 1,
        .view = tank_preset(TANK_PRESET_FESTIVAL)->view,
    };
    struct display_events events;
    board_open(&hal, &options);
    return hal.display.ops->poll(hal.display.self, &events) == HAL_ERR_ABSENT;
}

static int open_auto(void **state)
{
    (void)state;
    return open_with(BOARD_POI_AUTO);
}

static int open_mouse(void **state)
{
    (void)state;
    return open_with(BOARD_POI_MOUSE);
}

static int open_pad(void **state)
{
    (void)state;
    return open_with(BOARD_POI_PAD);
}

static int close_board(void **state)
{
    (void)state;
    while (SDL_NumJoysticks() > 0 && SDL_JoystickDetachVirtual(0) == 0) {
    }
    board_close(&hal);
    return 0;
}

static int plug_pad(void)
{
    const int index =
        SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                  SDL_CONTROLLER_BUTTON_DPAD_RIGHT + 1, 0);
    assert_true(index >= 0);
    return index;
}

/* Runs the part of a frame that concerns controllers: assigns the slots and polls every poi.
 * Returns the slots that changed, as a bit set. */
static uint32_t frame(int may_move)
{
    struct display_events events;
    struct controller_status desk;
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    hal.display.ops->poll(hal.display.self, &events);
    hal.controllers.ops->poll(hal.controllers.self, &desk);
    const uint32_t moved = hal.slots.ops->arrange(hal.slots.self, may_move);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (moved & (1u << i)) {
            hal.poi[i].ops->open(hal.poi[i].self);
        }
        hal.poi[i].ops->poll(hal.poi[i].self, samples, HAL_POI_SAMPLES_MAX);
    }
    return moved;
}

static void move_mouse(void)
{
    SDL_Event event = { .type = SDL_MOUSEMOTION };
    event.motion.x = 100;
    event.motion.xrel = 40;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static int slot_has(uint32_t slot, const char *who)
{
    const char *line = hal.poi[slot].ops->describe(hal.poi[slot].self);
    return strncmp(line, who, strlen(who)) == 0;
}

static void test_the_mouse_has_the_first_slot_if_there_is_no_other_controller(void **state)
{
    (void)state;
    struct poi_sample sample;
    assert_int_equal(frame(1), 1u);
    assert_true(slot_has(0, "mouse"));
    assert_string_equal(hal.poi[1].ops->describe(hal.poi[1].self), "");
    assert_int_equal(hal.poi[0].ops->poll(hal.poi[0].self, &sample, 1), 1);
    assert_int_equal(hal.poi[1].ops->open(hal.poi[1].self), HAL_ERR_ABSENT);
}

static void test_a_new_gamepad_gets_the_first_slot_after_the_game(void **state)
{
    (void)state;
    frame(1);
    plug_pad();
    for (uint32_t i = 0; i < 5; i++) {
        assert_int_equal(frame(0), 0u);
    }
    assert_true(slot_has(0, "mouse"));
    assert_int_equal(frame(1), 1u);
    assert_true(slot_has(0, "pad"));
}

/* The mouse is always present, so it gets a slot only when it moves. */
static void test_a_moved_mouse_gets_the_second_slot_beside_a_gamepad(void **state)
{
    (void)state;
    plug_pad();
    frame(1);
    assert_string_equal(hal.poi[1].ops->describe(hal.poi[1].self), "");
    move_mouse();
    frame(1);
    frame(1);
    assert_true(slot_has(0, "pad"));
    assert_true(slot_has(1, "mouse"));
}

/* If a gamepad is unplugged during a round, its slot stays reserved. When the gamepad is plugged in
 * again, it has its slot back within a frame. Between two games, the mouse gets the slot of an
 * absent gamepad. */
static void test_an_unplugged_gamepad_keeps_its_slot_until_the_game_ends(void **state)
{
    (void)state;
    struct poi_sample sample;
    plug_pad();
    frame(1);
    assert_true(slot_has(0, "pad"));
    assert_int_equal(SDL_JoystickDetachVirtual(0), 0);
    assert_int_equal(frame(0), 0u);
    assert_int_equal(hal.poi[0].ops->poll(hal.poi[0].self, &sample, 1), HAL_ERR_GONE);
    plug_pad();
    assert_int_equal(frame(0), 1u);
    assert_int_equal(hal.poi[0].ops->poll(hal.poi[0].self, &sample, 1), 1);
    assert_int_equal(SDL_JoystickDetachVirtual(0), 0);
    assert_int_equal(frame(0), 0u);
    assert_int_equal(frame(1), 1u);
    assert_true(slot_has(0, "mouse"));
}

static void test_the_mouse_option_disables_gamepads(void **state)
{
    (void)state;
    plug_pad();
    frame(1);
    frame(1);
    assert_true(slot_has(0, "mouse"));
    assert_string_equal(hal.poi[1].ops->describe(hal.poi[1].self), "");
}

static void test_the_gamepad_option_waits_for_a_gamepad_and_reports_it(void **state)
{
    (void)state;
    frame(1);
    assert_true(slot_has(0, "no pad yet"));
    assert_int_equal(hal.poi[0].ops->open(hal.poi[0].self), HAL_ERR_ABSENT);
    assert_int_equal(SDL_EventState(SDL_MOUSEMOTION, SDL_QUERY), SDL_IGNORE);
    plug_pad();
    assert_int_equal(frame(1), 1u);
    assert_true(slot_has(0, "pad"));
}

static void test_gamepad_buttons_work_whatever_has_the_first_slot(void **state)
{
    (void)state;
    struct button_sample buttons;
    plug_pad();
    frame(1);
    SDL_Joystick *joystick = SDL_JoystickOpen(0);
    SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_START, 1);
    frame(0);
    hal.buttons.ops->poll(hal.buttons.self, &buttons);
    assert_int_equal(buttons.pressed, INPUT_START);
    SDL_JoystickClose(joystick);
}

/* Joysticks send events without pause. Events that nobody takes from SDL's queue would fill the
 * queue. */
static void test_no_gamepad_event_stays_in_the_queue(void **state)
{
    (void)state;
    plug_pad();
    frame(1);
    SDL_Joystick *joystick = SDL_JoystickOpen(0);
    for (int i = 0; i < 20; i++) {
        SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTX, (Sint16)(1000 * i));
        SDL_JoystickUpdate();
    }
    assert_true(SDL_HasEvents(SDL_JOYAXISMOTION, SDL_CONTROLLERSENSORUPDATE));
    frame(0);
    assert_false(SDL_HasEvents(SDL_JOYAXISMOTION, SDL_CONTROLLERSENSORUPDATE));
    SDL_JoystickClose(joystick);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(
            test_the_mouse_has_the_first_slot_if_there_is_no_other_controller, open_auto,
            close_board),
        cmocka_unit_test_setup_teardown(test_a_new_gamepad_gets_the_first_slot_after_the_game,
                                        open_auto, close_board),
        cmocka_unit_test_setup_teardown(test_a_moved_mouse_gets_the_second_slot_beside_a_gamepad,
                                        open_auto, close_board),
        cmocka_unit_test_setup_teardown(
            test_an_unplugged_gamepad_keeps_its_slot_until_the_game_ends, open_auto, close_board),
        cmocka_unit_test_setup_teardown(test_the_mouse_option_disables_gamepads, open_mouse,
                                        close_board),
        cmocka_unit_test_setup_teardown(test_the_gamepad_option_waits_for_a_gamepad_and_reports_it,
                                        open_pad, close_board),
        cmocka_unit_test_setup_teardown(test_gamepad_buttons_work_whatever_has_the_first_slot,
                                        open_auto, close_board),
        cmocka_unit_test_setup_teardown(test_no_gamepad_event_stays_in_the_queue, open_auto,
                                        close_board),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
