/* test_touch_sdl.c -- tests how the pointer driver handles SDL's touch and mouse events. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <SDL.h>
#include <cmocka.h>

#include "drivers/pointer/mouse_poi.h"
#include "drivers/sim/hal_sim.h"
#include "tests/unit/support/pointer.h"

static struct clock_sim clock_state;
static struct mouse_poi mouse;
static struct hal_poi poi;

static int open_pointer(uint32_t enabled)
{
    clock_state = (struct clock_sim){ .now_ns = 1000 * MS };
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_InitSubSystem(SDL_INIT_VIDEO);
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    mouse_poi_init(&mouse, sim_clock_device(&clock_state), festival_view(), WIDTH, HEIGHT, enabled);
    poi = mouse_poi_devices(&mouse).poi;
    return poi.ops->open(poi.self);
}

static int open_both(void **state)
{
    (void)state;
    return open_pointer(POINTER_FILTER_MOUSE | POINTER_FILTER_TOUCH);
}

static int open_mouse_alone(void **state)
{
    (void)state;
    return open_pointer(POINTER_FILTER_MOUSE);
}

static int open_touch_alone(void **state)
{
    (void)state;
    return open_pointer(POINTER_FILTER_TOUCH);
}

static int close_pointer(void **state)
{
    (void)state;
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return 0;
}

static void push_finger(uint32_t type, SDL_FingerID id, float x, float y)
{
    SDL_Event event = { .type = type };
    event.tfinger.fingerId = id;
    event.tfinger.x = x;
    event.tfinger.y = y;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static void push_motion(int x, int y)
{
    SDL_Event event = { .type = SDL_MOUSEMOTION };
    event.motion.x = x;
    event.motion.y = y;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static void push_button(uint32_t type)
{
    SDL_Event event = { .type = type };
    event.button.button = SDL_BUTTON_LEFT;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static vec3 position_after_ms(uint64_t ms)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    clock_state.now_ns += ms * MS;
    const int count = poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
    assert_true(count > 0);
    return samples[count - 1].target.position_m;
}

static bool is_near(vec3 a, vec3 b)
{
    return f_abs(a.x - b.x) < 0.01f && f_abs(a.z - b.z) < 0.01f;
}

static void test_one_sdl_finger_moves_the_ring_and_a_second_lowers_it(void **state)
{
    (void)state;
    push_finger(SDL_FINGERDOWN, 3, 0.75f, 0.5f);
    vec3 at = position_after_ms(16);
    assert_true(at.y > 0.03f);
    assert_true(at.x > 0.1f);
    push_finger(SDL_FINGERDOWN, 4, 0.1f, 0.1f);
    position_after_ms(16);
    at = position_after_ms(400);
    assert_true(f_abs(at.y - DIP_DEPTH_M) < 0.001f);
    push_finger(SDL_FINGERUP, 4, 0.1f, 0.1f);
    position_after_ms(16);
    at = position_after_ms(600);
    assert_true(f_abs(at.y - DIP_HOVER_M) < 0.001f);
}

static void test_the_device_that_moved_last_controls_the_ring(void **state)
{
    (void)state;
    push_motion(320, 360);
    const vec3 by_mouse = position_after_ms(16);
    push_finger(SDL_FINGERDOWN, 1, 0.75f, 0.5f);
    const vec3 by_finger = position_after_ms(16);
    assert_true(by_finger.x > by_mouse.x + 0.1f);
    push_finger(SDL_FINGERUP, 1, 0.75f, 0.5f);
    assert_true(is_near(position_after_ms(16), by_finger));
    push_motion(320, 360);
    assert_true(is_near(position_after_ms(16), by_mouse));
}

/* Lifting the finger must not lift a ring that the mouse button holds down. */
static void test_the_ring_stays_down_while_mouse_or_finger_holds_it(void **state)
{
    (void)state;
    push_button(SDL_MOUSEBUTTONDOWN);
    push_finger(SDL_FINGERDOWN, 1, 0.5f, 0.5f);
    push_finger(SDL_FINGERDOWN, 2, 0.5f, 0.5f);
    position_after_ms(16);
    push_finger(SDL_FINGERUP, 2, 0.5f, 0.5f);
    push_finger(SDL_FINGERUP, 1, 0.5f, 0.5f);
    position_after_ms(16);
    assert_true(position_after_ms(600).y < -0.04f);
    push_button(SDL_MOUSEBUTTONUP);
    position_after_ms(16);
    assert_true(position_after_ms(600).y > 0.03f);
}

static void test_three_fingers_are_a_start_button(void **state)
{
    (void)state;
    struct button_sample buttons;
    const struct hal_buttons device = mouse_poi_devices(&mouse).buttons;
    for (SDL_FingerID id = 1; id <= 3; id++) {
        push_finger(SDL_FINGERDOWN, id, 0.5f, 0.5f);
    }
    position_after_ms(16);
    assert_int_equal(device.ops->poll(device.self, &buttons), HAL_OK);
    assert_int_equal(buttons.pressed, INPUT_START);
    assert_int_equal(buttons.held, INPUT_START);
    push_finger(SDL_FINGERUP, 2, 0.5f, 0.5f);
    position_after_ms(16);
    device.ops->poll(device.self, &buttons);
    assert_int_equal(buttons.pressed | buttons.held, 0);
}

/* With touch input disabled, touch events must neither move the ring nor stay in the queue. SDL
 * converts them to mouse events, which still work. */
static void test_disabled_touch_events_are_left_to_sdl(void **state)
{
    (void)state;
    const vec3 before = position_after_ms(16);
    assert_string_equal(SDL_GetHint(SDL_HINT_TOUCH_MOUSE_EVENTS), "1");
    push_finger(SDL_FINGERDOWN, 1, 0.9f, 0.5f);
    push_finger(SDL_FINGERDOWN, 2, 0.9f, 0.5f);
    assert_true(is_near(position_after_ms(16), before));
    assert_true(position_after_ms(600).y > 0.03f);
    assert_false(SDL_HasEvents(SDL_FINGERDOWN, SDL_FINGERMOTION));
}

static void test_a_disabled_mouse_moves_nothing(void **state)
{
    (void)state;
    const vec3 before = position_after_ms(16);
    assert_string_equal(SDL_GetHint(SDL_HINT_TOUCH_MOUSE_EVENTS), "0");
    push_motion(100, 100);
    push_button(SDL_MOUSEBUTTONDOWN);
    assert_true(is_near(position_after_ms(16), before));
    assert_true(position_after_ms(600).y > 0.03f);
    assert_false(SDL_HasEvents(SDL_MOUSEMOTION, SDL_MOUSEWHEEL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_one_sdl_finger_moves_the_ring_and_a_second_lowers_it,
                                        open_both, close_pointer),
        cmocka_unit_test_setup_teardown(test_the_device_that_moved_last_controls_the_ring,
                                        open_both, close_pointer),
        cmocka_unit_test_setup_teardown(test_the_ring_stays_down_while_mouse_or_finger_holds_it,
                                        open_both, close_pointer),
        cmocka_unit_test_setup_teardown(test_three_fingers_are_a_start_button, open_both,
                                        close_pointer),
        cmocka_unit_test_setup_teardown(test_disabled_touch_events_are_left_to_sdl,
                                        open_mouse_alone, close_pointer),
        cmocka_unit_test_setup_teardown(test_a_disabled_mouse_moves_nothing, open_touch_alone,
                                        close_pointer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
