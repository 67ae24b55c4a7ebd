/* test_fan.c -- Tests the fan, a second tool of the player that casts a shadow on the water. Mouse
 * events and a key move the fan through the driver, the frame loop and the core. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <SDL.h>
#include <cmocka.h>

#include "drivers/null.h"
#include "drivers/pointer/buttons_keyboard.h"
#include "drivers/pointer/mouse_poi.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/pointer.h"

#define SWING_MS ((uint64_t)(POINTER_FAN_SWING_S * 1000.0f))

/* ---- Tests of the driver: the mouse and the key of the fan ---------------------------------- */

static struct clock_sim fixture_clock;
static struct mouse_poi mouse;
static struct buttons_keyboard keyboard;

static int open_mouse(void **state)
{
    (void)state;
    SDL_setenv("SDL_VIDEODRIVER", "dummy", 1);
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        return -1;
    }
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    fixture_clock.now_ns = 1000 * MS;
    mouse_poi_init(&mouse, sim_clock_device(&fixture_clock), festival_view(), WIDTH, HEIGHT,
                   POINTER_FILTER_MOUSE);
    const struct hal_poi device = mouse_poi_devices(&mouse).poi;
    const int opened = device.ops->open(device.self);
    /* Opens the device twice, because the kiosk may open a device again after a loss. */
    return opened != HAL_OK ? -1 : device.ops->open(device.self);
}

static int close_mouse(void **state)
{
    (void)state;
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return 0;
}

static void push_key(uint32_t type, SDL_Keycode code)
{
    SDL_Event event = { .type = type };
    event.key.keysym.sym = code;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

static void push_motion(int x_px, int y_px)
{
    SDL_Event event = { .type = SDL_MOUSEMOTION };
    event.motion.x = x_px;
    event.motion.y = y_px;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

/* Polls the devices in the order of the frame loop. The buttons come first, because their poll
 * removes the key events from SDL's queue. */
static struct shade_input poll_hands(uint64_t ms)
{
    const struct hal_buttons buttons = buttons_keyboard_device(&keyboard);
    const struct hal_poi hand = mouse_poi_devices(&mouse).poi;
    const struct hal_fan other = mouse_poi_devices(&mouse).fan;
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    struct button_sample pressed;
    struct shade_input shade;
    fixture_clock.now_ns += ms * MS;
    assert_int_equal(buttons.ops->poll(buttons.self, &pressed), HAL_OK);
    assert_int_equal(pressed.full_screen, 0);
    assert_true(hand.ops->poll(hand.self, samples, HAL_POI_SAMPLES_MAX) > 0);
    assert_int_equal(other.ops->poll(other.self, &shade), HAL_OK);
    return shade;
}

static void test_key_f_activates_the_fan_while_pressed(void **state)
{
    (void)state;
    push_motion(400, 300);
    assert_int_equal(poll_hands(16).present, 0);
    push_key(SDL_KEYDOWN, SDLK_f);
    poll_hands(16);
    const struct shade_input held = poll_hands(SWING_MS + 1);
    assert_int_equal(held.present, 1);
    assert_float_equal(held.x_m, on_water(400.0f, 300.0f).x, 1e-5f);
    assert_float_equal(held.z_m, on_water(400.0f, 300.0f).z, 1e-5f);
    push_key(SDL_KEYDOWN, SDLK_g);
    push_key(SDL_KEYUP, SDLK_g);
    push_motion(600, 300);
    assert_float_equal(poll_hands(16).x_m, on_water(600.0f, 300.0f).x, 1e-5f);
    push_key(SDL_KEYUP, SDLK_f);
    poll_hands(16);
    assert_int_equal(poll_hands(SWING_MS + 1).present, 0);
}

/* ---- Tests of the fan in the frame loop ----------------------------------------------------- */

#define SEEN_MAX 1024u
#define FRAME_NS 16666667ull

static struct rig {
    struct clock_sim clock;
    struct pointer_sim poi;
    struct hal hal;
    struct kiosk kiosk;
    struct pointer_report reports[256];
    struct shade_input seen[SEEN_MAX];
    uint32_t seen_count;
} rig;

static void keep_shade(void *self, const struct input *input, const struct core *core)
{
    (void)self;
    (void)core;
    assert_true(rig.seen_count < SEEN_MAX);
    rig.seen[rig.seen_count++] = input->shade[0];
}

static int open_fixture(void **state)
{
    const struct kiosk_config config = {
        .core = { .seed = 5, .fish_count = 40 },
        .tap = { .tick = keep_shade },
    };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    pointer_sim_init(&rig.poi, rig.hal.clock, festival_view());
    rig.poi.reports = rig.reports;
    rig.hal.poi[0] = pointer_sim_devices(&rig.poi).poi;
    rig.hal.fan[0] = pointer_sim_devices(&rig.poi).fan;
    return kiosk_init(&rig.kiosk, &rig.hal, &config);
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        rig.clock.now_ns += FRAME_NS;
        assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
    }
}

static void lead_fan(float x_px, float y_px, uint32_t buttons)
{
    const uint64_t ms = rig.clock.now_ns / MS;
    rig.reports[rig.poi.feed.count++] = report(ms, x_px, y_px, buttons);
}

/* The mouse moves 4 pixels per frame, and a frame has two ticks. The core must receive a step of 2
 * pixels in every tick, instead of 4 pixels in every second tick. */
static void test_each_tick_has_an_interpolated_fan_position(void **state)
{
    (void)state;
    lead_fan(300.0f, 300.0f, POINTER_FAN);
    frames(60);
    for (uint32_t i = 0; i < 60; i++) {
        lead_fan(300.0f + 4.0f * (float)i, 300.0f, POINTER_FAN);
        frames(1);
    }
    const float step_m = 0.5f * (on_water(304.0f, 300.0f).x - on_water(300.0f, 300.0f).x);
    for (uint32_t i = rig.seen_count - 100; i < rig.seen_count; i++) {
        assert_float_equal(rig.seen[i].x_m - rig.seen[i - 1].x_m, step_m, 1e-5f);
    }
    const struct shade *shade = &rig.kiosk.core.world.tank.shade[0];
    assert_float_equal(shade->edge_m_s, step_m * (float)CORE_TICK_HZ, 0.01f);
}

static void test_the_scene_shows_the_fan_at_its_simulated_position(void **state)
{
    (void)state;
    lead_fan(500.0f, 320.0f, POINTER_FAN);
    frames(60);
    const struct scene_fan *shown = &rig.kiosk.scene.fan[0];
    const struct shade_cast *felt = &rig.kiosk.core.world.tank.shade[0].cast;
    assert_int_equal(shown->present, 1);
    assert_float_equal(shown->x_m, on_water(500.0f, 320.0f).x, 1e-5f);
    assert_true(shown->x_m == felt->x_m && shown->z_m == felt->z_m);
    assert_true(shown->radius_m == felt->radius_m && shown->dark == felt->dark);
    lead_fan(500.0f, 320.0f, 0);
    frames(60);
    assert_int_equal(rig.kiosk.scene.fan[0].present, 0);
}

static void test_an_unplugged_fan_disappears_and_reconnects(void **state)
{
    (void)state;
    lead_fan(500.0f, 320.0f, POINTER_FAN);
    frames(60);
    rig.poi.feed.unplug_at = rig.poi.feed.count;
    rig.poi.feed.replug_ns = rig.clock.now_ns + 1500 * MS;
    lead_fan(500.0f, 330.0f, POINTER_FAN);
    frames(2);
    assert_int_equal(rig.kiosk.scene.fan[0].present, 0);
    assert_true(rig.kiosk.faults.shade > 0);
    frames(180);
    assert_int_equal(rig.kiosk.scene.fan[0].present, 1);
}

static int broken_poll(void *self, struct shade_input *out)
{
    *out = *(const struct shade_input *)self;
    return HAL_OK;
}

static int broken_open(void *self)
{
    (void)self;
    return HAL_OK;
}

static void test_a_non_finite_fan_pose_is_rejected_and_counted(void **state)
{
    static const struct hal_fan_ops ops = { .open = broken_open, .poll = broken_poll };
    struct shade_input reading = { 1, 0.1f, 0.1f, 0.1f };
    (void)state;
    rig.hal.fan[1] = (struct hal_fan){ .ops = &ops, .self = &reading };
    const struct kiosk_config config = { .core = { .seed = 5, .fish_count = 40 } };
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    frames(2);
    assert_float_equal(rig.kiosk.scene.fan[1].x_m, 0.1f, 0.0f);
    static const float broken[] = { NAN, INFINITY, -INFINITY, 2000.0f };
    for (size_t i = 0; i < 4; i++) {
        reading = (struct shade_input){ 1, broken[i], 0.1f, 0.1f };
        frames(1);
        reading = (struct shade_input){ 1, 0.1f, broken[i], 0.1f };
        frames(1);
        reading = (struct shade_input){ 1, 0.1f, 0.1f, broken[i] };
        frames(1);
    }
    assert_int_equal(rig.kiosk.faults.shade, 12);
    /* All 12 invalid poses were rejected, so the fan is still at x = 0.1 m. */
    assert_float_equal(rig.kiosk.scene.fan[1].x_m, 0.1f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_key_f_activates_the_fan_while_pressed, open_mouse,
                                        close_mouse),
        cmocka_unit_test_setup(test_each_tick_has_an_interpolated_fan_position, open_fixture),
        cmocka_unit_test_setup(test_the_scene_shows_the_fan_at_its_simulated_position,
                               open_fixture),
        cmocka_unit_test_setup(test_an_unplugged_fan_disappears_and_reconnects, open_fixture),
        cmocka_unit_test_setup(test_a_non_finite_fan_pose_is_rejected_and_counted, open_fixture),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
