/* test_board.c -- tests the keys and the events of the desktop board. Keys can end the program, and
 * events that the board does not use must not fill SDL's queue. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <SDL.h>
#include <cmocka.h>

#include "core/tank/preset.h"
#include "platform/board.h"

static struct hal hal;

/* Opens an invisible window with SDL's off-screen video driver. */
static int open_with(uint8_t keyboard)
{
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    const struct board_options options = {
        .poi = BOARD_POI_BOT,
        .keyboard = keyboard,
        .width = 320,
        .height = 240,
        .mute = 1,
        .view = tank_preset(TANK_PRESET_FESTIVAL)->view,
    };
    struct display_events events;
    board_open(&hal, &options);
    return hal.display.ops->poll(hal.display.self, &events) == HAL_ERR_ABSENT;
}

static int open_board(void **state)
{
    (void)state;
    return open_with(BOARD_KEYBOARD_ON);
}

static int open_cabinet(void **state)
{
    (void)state;
    return open_with(BOARD_KEYBOARD_OFF);
}

static int close_board(void **state)
{
    (void)state;
    board_close(&hal);
    return 0;
}

static void push_key(SDL_Keycode code)
{
    SDL_Event event = { .type = SDL_KEYDOWN };
    event.key.keysym.sym = code;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static void test_keys_work_in_the_demo_of_the_bots(void **state)
{
    (void)state;
    struct button_sample buttons;
    push_key(SDLK_ESCAPE);
    push_key(SDLK_SPACE);
    hal.buttons.ops->poll(hal.buttons.self, &buttons);
    assert_int_equal(buttons.quit, 1);
    assert_int_equal(buttons.pressed, INPUT_START);
}

static void test_an_unused_mouse_does_not_fill_the_event_queue(void **state)
{
    (void)state;
    static const Uint32 types[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                    SDL_MOUSEWHEEL };
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        assert_int_equal(SDL_EventState(types[i], SDL_QUERY), SDL_IGNORE);
    }
}

/* While bots play the demo, the key F must have no function. During a game it holds a fan over the
 * water. Full screen is toggled only by F11. */
static void test_there_is_no_fan_in_the_demo_of_the_bots(void **state)
{
    (void)state;
    struct button_sample buttons;
    struct shade_input shade;
    push_key(SDLK_f);
    hal.buttons.ops->poll(hal.buttons.self, &buttons);
    assert_int_equal(buttons.full_screen, 0);
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        assert_int_equal(hal.fan[i].ops->open(hal.fan[i].self), HAL_ERR_ABSENT);
        assert_int_equal(hal.fan[i].ops->poll(hal.fan[i].self, &shade), HAL_ERR_ABSENT);
    }
    push_key(SDLK_F11);
    hal.buttons.ops->poll(hal.buttons.self, &buttons);
    assert_int_equal(buttons.full_screen, 1);
}

/* In a cabinet, a visitor may plug in a keyboard. The keys of this keyboard must not insert coins,
 * open the menu or end the program. */
static void test_in_a_cabinet_no_key_has_a_function(void **state)
{
    static const SDL_Keycode keys[] = { SDLK_ESCAPE, SDLK_q,  SDLK_SPACE, SDLK_5,   SDLK_6, SDLK_7,
                                        SDLK_F2,     SDLK_F3, SDLK_F4,    SDLK_F11, SDLK_l };
    static const Uint32 types[] = { SDL_KEYDOWN, SDL_KEYUP, SDL_TEXTINPUT };
    static const struct button_sample nothing;
    struct button_sample buttons = { 0 };
    (void)state;
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        push_key(keys[i]);
    }
    hal.buttons.ops->poll(hal.buttons.self, &buttons);
    assert_memory_equal(&buttons, &nothing, sizeof nothing);
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        /* The type is ignored, so SDL does not put its events into the queue. */
        assert_int_equal(SDL_EventState(types[i], SDL_QUERY), SDL_IGNORE);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_keys_work_in_the_demo_of_the_bots),
        cmocka_unit_test(test_an_unused_mouse_does_not_fill_the_event_queue),
        cmocka_unit_test(test_there_is_no_fan_in_the_demo_of_the_bots),
    };
    const struct CMUnitTest in_cabinet[] = {
        cmocka_unit_test(test_in_a_cabinet_no_key_has_a_function),
    };
    const int failed = cmocka_run_group_tests(tests, open_board, close_board);
    return failed + cmocka_run_group_tests(in_cabinet, open_cabinet, close_board);
}
