/* test_gamepad_poi.c -- Tests the gamepad driver with SDL's virtual joysticks and real SDL events,
 * without hardware. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <SDL.h>
#include <cmocka.h>

#include "drivers/gamepad/gamepads.h"
#include "drivers/sim/hal_sim.h"
#include "tests/unit/support/pointer.h"

static struct clock_sim clock_state;
static struct gamepads gamepads;
static uint16_t hum_slow, hum_fast;
static uint32_t hum_count;

static int SDLCALL take_rumble(void *self, Uint16 slow, Uint16 fast)
{
    (void)self;
    hum_slow = slow;
    hum_fast = fast;
    hum_count++;
    return 0;
}

/* Attaches a virtual gamepad with six axes and fifteen buttons. Returns its SDL index. */
static int attach(uint16_t product)
{
    SDL_VirtualJoystickDesc desc = {
        .version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION,
        .type = SDL_JOYSTICK_TYPE_GAMECONTROLLER,
        .naxes = SDL_CONTROLLER_AXIS_MAX,
        .nbuttons = SDL_CONTROLLER_BUTTON_DPAD_RIGHT + 1,
        .vendor_id = 0x1209,
        .product_id = product,
        .name = "Pad of memory",
        .Rumble = take_rumble,
    };
    const int index = SDL_JoystickAttachVirtualEx(&desc);
    assert_true(index >= 0);
    return index;
}

static SDL_Joystick *joystick(uint32_t place)
{
    assert_non_null(gamepads.pad[place].controller);
    return SDL_GameControllerGetJoystick(gamepads.pad[place].controller);
}

/* Returns the SDL index of the gamepad in slot `place` of the driver. */
static int index_of(uint32_t place)
{
    for (int i = 0; i < SDL_NumJoysticks(); i++) {
        if (SDL_JoystickGetDeviceInstanceID(i) == gamepads.pad[place].instance) {
            return i;
        }
    }
    return -1;
}

static void wait_ms(uint64_t ms)
{
    clock_state.now_ns += ms * MS;
    SDL_PumpEvents();
}

static struct poi_sample newest(uint32_t place)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    const struct hal_poi poi = gamepad_poi_devices(&gamepads, place).poi;
    const int count = poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
    assert_true(count > 0);
    return samples[count - 1];
}

static int begin(void **state)
{
    (void)state;
    clock_state = (struct clock_sim){ .now_ns = 1000 * MS };
    hum_count = 0;
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_InitSubSystem(SDL_INIT_VIDEO);
    gamepads_init(&gamepads, sim_clock_device(&clock_state), festival_view());
    return gamepads_open(&gamepads, NULL);
}

static int end(void **state)
{
    (void)state;
    while (SDL_NumJoysticks() > 0 && SDL_JoystickDetachVirtual(0) == 0) {
    }
    gamepads_close(&gamepads);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return 0;
}

static void test_a_gamepad_that_is_plugged_in_is_opened(void **state)
{
    (void)state;
    const struct hal_poi poi = gamepad_poi_devices(&gamepads, 0).poi;
    assert_false(gamepad_poi_is_present(&gamepads.pad[0]));
    assert_int_equal(poi.ops->open(poi.self), HAL_ERR_GONE);
    attach(1);
    wait_ms(16);
    assert_true(gamepad_poi_is_present(&gamepads.pad[0]));
    assert_false(gamepad_poi_is_present(&gamepads.pad[1]));
    assert_int_equal(poi.ops->open(poi.self), HAL_OK);
    assert_non_null(strstr(poi.ops->describe(poi.self), "Pad of memory"));
    assert_non_null(strstr(poi.ops->describe(poi.self), "rumbles"));
}

static void test_a_gamepad_that_was_connected_at_the_start_is_opened(void **state)
{
    (void)state;
    attach(1);
    gamepads_close(&gamepads);
    /* The previous test shut down SDL's joystick subsystem, and SDL then also shut down the game
     * controller subsystem. */
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
    attach(1);
    gamepads_init(&gamepads, sim_clock_device(&clock_state), festival_view());
    assert_int_equal(gamepads_open(&gamepads, NULL), HAL_OK);
    assert_true(gamepad_poi_is_present(&gamepads.pad[0]));
    wait_ms(16);
    assert_true(gamepad_poi_is_present(&gamepads.pad[0]));
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

static void test_the_stick_moves_the_ring_to_the_right_and_the_trigger_dips(void **state)
{
    (void)state;
    attach(1);
    wait_ms(16);
    const vec3 before = newest(0).target.position_m;
    SDL_JoystickSetVirtualAxis(joystick(0), SDL_CONTROLLER_AXIS_LEFTX, 32767);
    wait_ms(16);
    newest(0);
    wait_ms(500);
    const vec3 after = newest(0).target.position_m;
    /* The ring moves at 0.55 m/s, so it has moved by about 0.25 m. */
    assert_true(after.x > before.x + 0.20f && after.x < before.x + 0.29f);
    assert_true(f_abs(after.z - before.z) < 0.02f);
    SDL_JoystickSetVirtualAxis(joystick(0), SDL_CONTROLLER_AXIS_LEFTX, 0);
    SDL_JoystickSetVirtualAxis(joystick(0), SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767);
    wait_ms(16);
    newest(0);
    wait_ms(400);
    assert_true(f_abs(newest(0).target.position_m.y - DIP_DEPTH_M) < 0.001f);
    SDL_JoystickSetVirtualAxis(joystick(0), SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -32768);
    wait_ms(16);
    newest(0);
    wait_ms(600);
    assert_true(f_abs(newest(0).target.position_m.y - DIP_HOVER_M) < 0.001f);
}

static void test_a_press_between_two_polls_is_an_edge(void **state)
{
    (void)state;
    struct button_sample buttons;
    const struct hal_buttons device = gamepad_poi_devices(&gamepads, 0).buttons;
    assert_int_equal(device.ops->poll(device.self, &buttons), HAL_ERR_ABSENT);
    attach(1);
    wait_ms(16);
    gamepads_poll(&gamepads);
    SDL_JoystickSetVirtualButton(joystick(0), SDL_CONTROLLER_BUTTON_START, 1);
    wait_ms(4);
    SDL_JoystickSetVirtualButton(joystick(0), SDL_CONTROLLER_BUTTON_START, 0);
    SDL_JoystickSetVirtualButton(joystick(0), SDL_CONTROLLER_BUTTON_DPAD_LEFT, 1);
    wait_ms(4);
    assert_int_equal(device.ops->poll(device.self, &buttons), HAL_OK);
    assert_int_equal(buttons.pressed, INPUT_START | INPUT_LEFT);
    assert_int_equal(buttons.held, INPUT_LEFT);
    device.ops->poll(device.self, &buttons);
    assert_int_equal(buttons.pressed, 0);
}

static void test_an_unplugged_gamepad_is_gone_and_returns_to_its_own_slot(void **state)
{
    (void)state;
    struct poi_sample sample;
    const struct hal_poi first = gamepad_poi_devices(&gamepads, 0).poi;
    attach(1);
    attach(2);
    wait_ms(16);
    assert_true(gamepad_poi_is_present(&gamepads.pad[0]));
    assert_true(gamepad_poi_is_present(&gamepads.pad[1]));
    char second_guid[GAMEPAD_GUID_SIZE];
    memcpy(second_guid, gamepads.pad[1].guid, sizeof second_guid);
    assert_int_equal(SDL_JoystickDetachVirtual(index_of(0)), 0);
    wait_ms(16);
    assert_int_equal(first.ops->poll(first.self, &sample, 1), HAL_ERR_GONE);
    assert_int_equal(first.ops->set_force(first.self, &(struct poi_force){ 0 }), HAL_ERR_ABSENT);
    assert_int_equal(SDL_JoystickDetachVirtual(index_of(1)), 0);
    wait_ms(16);
    assert_false(gamepad_poi_is_present(&gamepads.pad[1]));
    attach(2);
    wait_ms(16);
    assert_false(gamepad_poi_is_present(&gamepads.pad[0]));
    assert_true(gamepad_poi_is_present(&gamepads.pad[1]));
    assert_string_equal(gamepads.pad[1].guid, second_guid);
    attach(1);
    wait_ms(16);
    assert_int_equal(first.ops->open(first.self), HAL_OK);
    assert_int_equal(first.ops->poll(first.self, &sample, 1), 1);
}

static void test_a_fifth_gamepad_gets_no_slot(void **state)
{
    (void)state;
    for (uint16_t i = 0; i < GAMEPADS_MAX + 1; i++) {
        attach((uint16_t)(i + 1));
        wait_ms(16);
        gamepads_poll(&gamepads);
    }
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        assert_true(gamepad_poi_is_present(&gamepads.pad[i]));
    }
}

static void test_a_device_of_another_driver_is_not_opened(void **state)
{
    (void)state;
    static const struct usb_key bars[] = { { 0x046d, 0xc216, "" }, { 0x1209, 7, "" } };
    gamepads_exclude(&gamepads, bars, 2);
    assert_string_equal(SDL_GetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES),
                        "0x046d/0xc216,0x1209/0x0007,");
    attach(7);
    wait_ms(16);
    assert_false(gamepad_poi_is_present(&gamepads.pad[0]));
    attach(8);
    wait_ms(16);
    assert_true(gamepad_poi_is_present(&gamepads.pad[0]));
    assert_false(gamepad_poi_is_present(&gamepads.pad[1]));
}

/* The operator has assigned one of two equal devices to the HID driver, by its serial number. SDL
 * must still open the other device, so SDL's ignore hint must not contain their common vendor and
 * product id. A device without a readable serial number counts as assigned. */
static void test_one_of_two_equal_gamepads_is_excluded_by_its_serial_number(void **state)
{
    (void)state;
    static const struct usb_key bars[] = { { 0x054c, 0x09cc, "A1" }, { 0x046d, 0xc216, "" } };
    gamepads_exclude(&gamepads, bars, 2);
    assert_string_equal(SDL_GetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES), "0x046d/0xc216,");
    assert_true(gamepads_is_excluded(&gamepads, &(struct usb_key){ 0x054c, 0x09cc, "A1" }));
    assert_false(gamepads_is_excluded(&gamepads, &(struct usb_key){ 0x054c, 0x09cc, "A2" }));
    assert_true(gamepads_is_excluded(&gamepads, &(struct usb_key){ 0x054c, 0x09cc, "" }));
    assert_true(gamepads_is_excluded(&gamepads, &(struct usb_key){ 0x046d, 0xc216, "A2" }));
    assert_false(gamepads_is_excluded(&gamepads, &(struct usb_key){ 0x046d, 0x09cc, "A1" }));
}

/* The operator assigns an open gamepad to the HID driver. The gamepad driver must close the gamepad
 * at once. */
static void test_a_gamepad_that_is_excluded_while_open_is_gone(void **state)
{
    (void)state;
    static const struct usb_key bar = { 0x1209, 8, "" };
    const struct hal_poi poi = gamepad_poi_devices(&gamepads, 0).poi;
    struct poi_sample sample;
    attach(8);
    wait_ms(16);
    newest(0);
    gamepads_exclude(&gamepads, &bar, 1);
    assert_int_equal(poi.ops->poll(poi.self, &sample, 1), HAL_ERR_GONE);
    assert_false(gamepad_poi_is_present(&gamepads.pad[0]));
    gamepads_exclude(&gamepads, &bar, 0);
    assert_string_equal(SDL_GetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES), "");
}

static void test_rumble_follows_the_water_and_equal_values_are_sent_once(void **state)
{
    (void)state;
    const struct hal_poi poi = gamepad_poi_devices(&gamepads, 0).poi;
    const struct poi_force push = { .drag = 0.5f };
    const struct poi_force blow = { .drag = 0.5f, .slap = 1.0f };
    attach(1);
    wait_ms(16);
    gamepads_poll(&gamepads);
    assert_int_equal(poi.ops->set_force(poi.self, &(struct poi_force){ 0 }), HAL_OK);
    assert_int_equal(hum_count, 0);
    poi.ops->set_force(poi.self, &push);
    poi.ops->set_force(poi.self, &push);
    assert_int_equal(hum_count, 1);
    assert_int_equal(hum_slow, 16384);
    assert_int_equal(hum_fast, 0);
    wait_ms(16);
    poi.ops->set_force(poi.self, &blow);
    assert_int_equal(hum_count, 2);
    assert_int_equal(hum_fast, 65535);
    poi.ops->set_force(poi.self, &(struct poi_force){ 0 });
    assert_int_equal(hum_count, 3);
    assert_int_equal(hum_slow + hum_fast, 0);
}

static void push_sensor(SDL_SensorType type, float x, float y, float z)
{
    SDL_Event event = { .type = SDL_CONTROLLERSENSORUPDATE };
    event.csensor.which = gamepads.pad[0].instance;
    event.csensor.sensor = type;
    event.csensor.data[0] = x;
    event.csensor.data[1] = y;
    event.csensor.data[2] = z;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

/* SDL's virtual joysticks have no motion sensors, so the test writes sensor events into SDL's
 * queue. */
static void test_a_gamepad_with_a_gyroscope_tilts_the_ring(void **state)
{
    (void)state;
    attach(1);
    wait_ms(16);
    gamepads_poll(&gamepads);
    push_sensor(SDL_SENSOR_ACCEL, 0.0f, 9.81f, 0.0f);
    wait_ms(16);
    assert_true(f_abs(newest(0).target.angles.pitch_rad) < 0.01f);
    /* The far edge of the gamepad rises at 1 rad/s for 0.4 s. */
    for (uint32_t i = 0; i < 25; i++) {
        push_sensor(SDL_SENSOR_GYRO, 1.0f, 0.0f, 0.0f);
        wait_ms(16);
        newest(0);
    }
    push_sensor(SDL_SENSOR_GYRO, 0.0f, 0.0f, 0.0f);
    wait_ms(100);
    newest(0);
    wait_ms(100);
    const float pitch_rad = newest(0).target.angles.pitch_rad;
    assert_true(pitch_rad > 0.28f && pitch_rad < 0.42f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_gamepad_that_is_plugged_in_is_opened, begin, end),
        cmocka_unit_test_setup_teardown(test_a_gamepad_that_was_connected_at_the_start_is_opened,
                                        begin, end),
        cmocka_unit_test_setup_teardown(
            test_the_stick_moves_the_ring_to_the_right_and_the_trigger_dips, begin, end),
        cmocka_unit_test_setup_teardown(test_a_press_between_two_polls_is_an_edge, begin, end),
        cmocka_unit_test_setup_teardown(
            test_an_unplugged_gamepad_is_gone_and_returns_to_its_own_slot, begin, end),
        cmocka_unit_test_setup_teardown(test_a_fifth_gamepad_gets_no_slot, begin, end),
        cmocka_unit_test_setup_teardown(test_a_device_of_another_driver_is_not_opened, begin, end),
        cmocka_unit_test_setup_teardown(
            test_one_of_two_equal_gamepads_is_excluded_by_its_serial_number, begin, end),
        cmocka_unit_test_setup_teardown(test_a_gamepad_that_is_excluded_while_open_is_gone, begin,
                                        end),
        cmocka_unit_test_setup_teardown(
            test_rumble_follows_the_water_and_equal_values_are_sent_once, begin, end),
        cmocka_unit_test_setup_teardown(test_a_gamepad_with_a_gyroscope_tilts_the_ring, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
