/* test_poi_touch.c -- fingers on glass: who leads, what two of them and what three mean; then as
 * SDL's own events through the driver. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <SDL.h>
#include <cmocka.h>

#include "core/base/rng.h"
#include "core/game/control/input_validation.h"
#include "drivers/pointer/mouse_poi.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "tests/unit/support/pointer.h"

/* ---- Fingers -------------------------------------------------------------------------------- */

static struct touch_fingers fingers;

static int finger(enum touch_kind kind, int64_t id, float x, float y)
{
    const struct touch_event event = { .kind = (uint8_t)kind, .id = id, .x = x, .y = y };
    return touch_fingers_take(&fingers, &event);
}

static int clean_glass(void **state)
{
    (void)state;
    fingers = (struct touch_fingers){ 0 };
    return 0;
}

static void test_one_finger_leads_and_a_second_dips(void **state)
{
    (void)state;
    assert_true(finger(TOUCH_DOWN, 7, 0.25f, 0.5f));
    assert_true(fingers.x == 0.25f && fingers.y == 0.5f);
    assert_false(fingers.dips);
    finger(TOUCH_DOWN, 8, 0.9f, 0.9f);
    assert_true(fingers.dips);
    assert_true(fingers.x == 0.25f && fingers.y == 0.5f);
    assert_false(finger(TOUCH_MOVE, 8, 0.8f, 0.8f)); /* Where the second lies is no matter. */
    assert_true(finger(TOUCH_MOVE, 7, 0.3f, 0.5f));
    assert_true(fingers.x == 0.3f);
    finger(TOUCH_UP, 8, 0.8f, 0.8f);
    assert_false(fingers.dips);
}

/* Else the ring would leap to the finger that was to dip it. */
static void test_when_the_leader_lifts_the_ring_stays(void **state)
{
    (void)state;
    finger(TOUCH_DOWN, 1, 0.2f, 0.2f);
    finger(TOUCH_DOWN, 2, 0.9f, 0.9f);
    finger(TOUCH_UP, 1, 0.2f, 0.2f);
    finger(TOUCH_MOVE, 2, 0.7f, 0.7f);
    finger(TOUCH_DOWN, 3, 0.6f, 0.6f);
    assert_true(fingers.x == 0.2f && fingers.y == 0.2f);
    assert_true(fingers.dips);
    finger(TOUCH_UP, 2, 0.7f, 0.7f);
    finger(TOUCH_UP, 3, 0.6f, 0.6f);
    assert_false(fingers.dips);
    finger(TOUCH_DOWN, 4, 0.5f, 0.6f);
    assert_true(fingers.x == 0.5f && fingers.y == 0.6f);
}

static void test_three_fingers_press_start_once(void **state)
{
    (void)state;
    finger(TOUCH_DOWN, 1, 0.2f, 0.2f);
    finger(TOUCH_DOWN, 2, 0.3f, 0.2f);
    assert_false(touch_fingers_start(&fingers));
    finger(TOUCH_DOWN, 3, 0.4f, 0.2f);
    finger(TOUCH_DOWN, 4, 0.5f, 0.2f);
    assert_true(touch_fingers_start(&fingers));
    assert_false(touch_fingers_start(&fingers));
    finger(TOUCH_UP, 4, 0.5f, 0.2f);
    finger(TOUCH_UP, 3, 0.4f, 0.2f);
    finger(TOUCH_DOWN, 5, 0.4f, 0.2f);
    assert_true(touch_fingers_start(&fingers));
}

/* A panel may forget a lifting, tell one twice, or speak of fingers that never came down. */
static void test_a_panel_that_tells_nonsense_leads_nowhere(void **state)
{
    (void)state;
    assert_false(finger(TOUCH_UP, 9, 0.1f, 0.1f));
    assert_false(finger(TOUCH_MOVE, 9, 0.1f, 0.1f));
    assert_false(finger(TOUCH_DOWN, 9, 0.0f / 0.0f, 0.1f));
    assert_int_equal(fingers.count, 0);
    finger(TOUCH_DOWN, 1, -5.0f, 1e30f);
    assert_true(fingers.x == 0.0f && fingers.y == 1.0f);
    finger(TOUCH_DOWN, 1, 0.5f, 0.5f);
    assert_int_equal(fingers.count, 1);
    for (int64_t id = 2; id < 30; id++) {
        finger(TOUCH_DOWN, id, 0.5f, 0.5f);
    }
    assert_int_equal(fingers.count, TOUCH_FINGER_MAX);
    for (int64_t id = 1; id < 30; id++) {
        finger(TOUCH_UP, id, 0.5f, 0.5f);
    }
    assert_int_equal(fingers.count, 0);
    assert_false(fingers.dips);
}

static void test_any_events_leave_a_place_on_the_glass(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 100000; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ 6, i, 0, RNG_TEST });
        const uint32_t any = rng_u32((struct rng_key){ 6, i, 1, RNG_TEST });
        float x;
        memcpy(&x, &any, sizeof x);
        finger((enum touch_kind)(bits % 3u), (int64_t)((bits >> 8) % 14u), x,
               (float)(bits >> 16) / 65536.0f);
        assert_true(fingers.count <= TOUCH_FINGER_MAX);
        assert_true(fingers.x >= 0.0f && fingers.x <= 1.0f);
        assert_true(fingers.y >= 0.0f && fingers.y <= 1.0f);
        assert_int_equal(fingers.dips, fingers.count >= TOUCH_DIP_FINGERS);
    }
}

/* ---- The twin ------------------------------------------------------------------------------- */

#define SCRIPT 1000u
static struct touch_event script[SCRIPT];
static struct clock_sim twin_clock;
static struct touch_sim sim;
static struct hal_poi twin;

/* One finger strolls, a second is put down and lifted twice a second. */
static int begin_twin(void **state)
{
    (void)state;
    twin_clock = (struct clock_sim){ .now_ns = 1000 * MS };
    sim_touch_init(&sim, sim_clock_device(&twin_clock), stall_view(), WIDTH, HEIGHT);
    for (uint32_t i = 0; i < SCRIPT; i++) {
        const int second = i > 0 && i % 30 == 0;
        script[i] = (struct touch_event){
            .time_ns = (1000 + 8 * (uint64_t)i) * MS,
            .kind = (uint8_t)(i == 0             ? TOUCH_DOWN
                              : second && i % 60 ? TOUCH_DOWN
                              : second           ? TOUCH_UP
                                                 : TOUCH_MOVE),
            .id = second ? 2 : 1,
            .x = 0.5f + 0.3f * f_sin((float)i * 0.02f),
            .y = 0.5f + 0.2f * f_cos((float)i * 0.03f),
        };
    }
    sim.events = script;
    sim.feed.count = SCRIPT;
    twin = sim_touch_device(&sim);
    return twin.ops->open(twin.self);
}

/* Plays the rest of the script; every sample is a hand's. Returns the last answer. */
static int play_out(void)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    struct poi_sample last = { 0 };
    int result = 0;
    for (uint32_t i = 0; i < 560 && result >= 0; i++) {
        twin_clock.now_ns += 16 * MS;
        result = twin.ops->poll(twin.self, samples, HAL_POI_SAMPLES_MAX);
        for (int k = 0; k < result; k++) {
            assert_true(input_pose_is_finite(&samples[k].target));
            assert_true(samples[k].time_ns >= last.time_ns);
            last = samples[k];
        }
    }
    return result;
}

static void test_a_script_of_fingers_strolls_and_dips(void **state)
{
    (void)state;
    uint32_t dips = 0;
    float before_m = POINTER_HOVER_M;
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    for (uint32_t i = 0; i < 500; i++) {
        twin_clock.now_ns += 16 * MS;
        const int count = twin.ops->poll(twin.self, samples, HAL_POI_SAMPLES_MAX);
        const float height_m = samples[count - 1].target.position_m.y;
        dips += before_m >= 0.0f && height_m < 0.0f;
        before_m = height_m;
    }
    assert_int_equal(dips, 17); /* Of 33 changes every other one goes down. */
}

/* Doubled, leaping, spoilt, liftings kept back: a hand all the same, and at the end of it all the
 * glass is usable again. */
static void test_a_bad_panel_is_still_a_hand(void **state)
{
    (void)state;
    sim.feed.double_every = 3;
    sim.mute_every = 4;
    sim.feed.jump_at = 77;
    sim.feed.spoil_from = 200;
    sim.feed.spoil_to = 800;
    sim.feed.silent_from_ns = 3000 * MS;
    sim.feed.silent_to_ns = 4000 * MS;
    play_out();
    assert_int_equal(sim.feed.next, SCRIPT);
    for (int64_t id = 0; id < 16; id++) {
        const struct touch_event up = { .kind = TOUCH_UP, .id = id };
        touch_fingers_take(&sim.fingers, &up);
        const struct touch_event other = { .kind = TOUCH_UP, .id = -id };
        touch_fingers_take(&sim.fingers, &other);
    }
    assert_int_equal(sim.fingers.count, 0);
    assert_false(sim.fingers.dips);
}

static void test_it_may_be_unplugged_at_any_event(void **state)
{
    (void)state;
    struct poi_sample sample;
    for (uint32_t at = 0; at < SCRIPT; at++) {
        begin_twin(state);
        sim.feed.unplug_at = at;
        sim.feed.replug_ns = UINT64_MAX;
        assert_int_equal(play_out(), HAL_ERR_GONE);
        assert_int_equal(sim.feed.next, at);
        assert_int_equal(twin.ops->open(twin.self), HAL_ERR_GONE);
        sim.feed.replug_ns = twin_clock.now_ns;
        assert_int_equal(twin.ops->open(twin.self), HAL_OK);
        assert_int_equal(twin.ops->poll(twin.self, &sample, 1), 1);
        assert_false(sim.fingers.dips);
    }
}

/* ---- SDL's events --------------------------------------------------------------------------- */

static struct clock_sim clock_state;
static struct mouse_poi mouse;
static struct hal_poi poi;

static int open_pointer(uint32_t heeds)
{
    clock_state = (struct clock_sim){ .now_ns = 1000 * MS };
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_InitSubSystem(SDL_INIT_VIDEO);
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    mouse_poi_init(&mouse, sim_clock_device(&clock_state), stall_view(), WIDTH, HEIGHT, heeds);
    poi = mouse_poi_device(&mouse);
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

static vec3 hand_after_ms(uint64_t ms)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    clock_state.now_ns += ms * MS;
    const int count = poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
    assert_true(count > 0);
    return samples[count - 1].target.position_m;
}

static int is_near(vec3 a, vec3 b)
{
    return f_abs(a.x - b.x) < 0.01f && f_abs(a.z - b.z) < 0.01f;
}

static void test_a_finger_leads_the_ring_and_a_second_lets_it_down(void **state)
{
    (void)state;
    push_finger(SDL_FINGERDOWN, 3, 0.75f, 0.5f);
    vec3 at = hand_after_ms(16);
    assert_true(at.y > 0.03f);
    assert_true(at.x > 0.1f);
    push_finger(SDL_FINGERDOWN, 4, 0.1f, 0.1f);
    hand_after_ms(16);
    at = hand_after_ms(400);
    assert_true(f_abs(at.y - POINTER_DIP_M) < 0.001f);
    push_finger(SDL_FINGERUP, 4, 0.1f, 0.1f);
    hand_after_ms(16);
    at = hand_after_ms(600);
    assert_true(f_abs(at.y - POINTER_HOVER_M) < 0.001f);
}

static void test_whoever_moved_last_leads(void **state)
{
    (void)state;
    push_motion(320, 360);
    const vec3 by_mouse = hand_after_ms(16);
    push_finger(SDL_FINGERDOWN, 1, 0.75f, 0.5f);
    const vec3 by_finger = hand_after_ms(16);
    assert_true(by_finger.x > by_mouse.x + 0.1f);
    push_finger(SDL_FINGERUP, 1, 0.75f, 0.5f);
    assert_true(is_near(hand_after_ms(16), by_finger));
    push_motion(320, 360);
    assert_true(is_near(hand_after_ms(16), by_mouse));
}

/* A finger that lifts does not lift what the button holds down. */
static void test_mouse_and_fingers_each_hold_the_ring_down(void **state)
{
    (void)state;
    push_button(SDL_MOUSEBUTTONDOWN);
    push_finger(SDL_FINGERDOWN, 1, 0.5f, 0.5f);
    push_finger(SDL_FINGERDOWN, 2, 0.5f, 0.5f);
    hand_after_ms(16);
    push_finger(SDL_FINGERUP, 2, 0.5f, 0.5f);
    push_finger(SDL_FINGERUP, 1, 0.5f, 0.5f);
    hand_after_ms(16);
    assert_true(hand_after_ms(600).y < -0.04f);
    push_button(SDL_MOUSEBUTTONUP);
    hand_after_ms(16);
    assert_true(hand_after_ms(600).y > 0.03f);
}

static void test_three_fingers_are_a_start_button(void **state)
{
    (void)state;
    struct button_sample buttons;
    const struct hal_buttons device = mouse_poi_buttons(&mouse);
    for (SDL_FingerID id = 1; id <= 3; id++) {
        push_finger(SDL_FINGERDOWN, id, 0.5f, 0.5f);
    }
    hand_after_ms(16);
    assert_int_equal(device.ops->poll(device.self, &buttons), HAL_OK);
    assert_int_equal(buttons.pressed, INPUT_START);
    assert_int_equal(buttons.held, INPUT_START);
    push_finger(SDL_FINGERUP, 2, 0.5f, 0.5f);
    hand_after_ms(16);
    device.ops->poll(device.self, &buttons);
    assert_int_equal(buttons.pressed | buttons.held, 0);
}

/* They neither lead nor stay in the queue; SDL's own mouse of them does what a mouse does. */
static void test_fingers_that_are_not_heeded_are_left_to_sdl(void **state)
{
    (void)state;
    const vec3 before = hand_after_ms(16);
    assert_string_equal(SDL_GetHint(SDL_HINT_TOUCH_MOUSE_EVENTS), "1");
    push_finger(SDL_FINGERDOWN, 1, 0.9f, 0.5f);
    push_finger(SDL_FINGERDOWN, 2, 0.9f, 0.5f);
    assert_true(is_near(hand_after_ms(16), before));
    assert_true(hand_after_ms(600).y > 0.03f);
    assert_false(SDL_HasEvents(SDL_FINGERDOWN, SDL_FINGERMOTION));
}

static void test_a_mouse_that_is_not_heeded_leads_nowhere(void **state)
{
    (void)state;
    const vec3 before = hand_after_ms(16);
    assert_string_equal(SDL_GetHint(SDL_HINT_TOUCH_MOUSE_EVENTS), "0");
    push_motion(100, 100);
    push_button(SDL_MOUSEBUTTONDOWN);
    assert_true(is_near(hand_after_ms(16), before));
    assert_true(hand_after_ms(600).y > 0.03f);
    assert_false(SDL_HasEvents(SDL_MOUSEMOTION, SDL_MOUSEWHEEL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_one_finger_leads_and_a_second_dips, clean_glass),
        cmocka_unit_test_setup(test_when_the_leader_lifts_the_ring_stays, clean_glass),
        cmocka_unit_test_setup(test_three_fingers_press_start_once, clean_glass),
        cmocka_unit_test_setup(test_a_panel_that_tells_nonsense_leads_nowhere, clean_glass),
        cmocka_unit_test_setup(test_any_events_leave_a_place_on_the_glass, clean_glass),
        cmocka_unit_test_setup(test_a_script_of_fingers_strolls_and_dips, begin_twin),
        cmocka_unit_test_setup(test_a_bad_panel_is_still_a_hand, begin_twin),
        cmocka_unit_test_setup(test_it_may_be_unplugged_at_any_event, begin_twin),
        cmocka_unit_test_setup_teardown(test_a_finger_leads_the_ring_and_a_second_lets_it_down,
                                        open_both, close_pointer),
        cmocka_unit_test_setup_teardown(test_whoever_moved_last_leads, open_both, close_pointer),
        cmocka_unit_test_setup_teardown(test_mouse_and_fingers_each_hold_the_ring_down, open_both,
                                        close_pointer),
        cmocka_unit_test_setup_teardown(test_three_fingers_are_a_start_button, open_both,
                                        close_pointer),
        cmocka_unit_test_setup_teardown(test_fingers_that_are_not_heeded_are_left_to_sdl,
                                        open_mouse_alone, close_pointer),
        cmocka_unit_test_setup_teardown(test_a_mouse_that_is_not_heeded_leads_nowhere,
                                        open_touch_alone, close_pointer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
