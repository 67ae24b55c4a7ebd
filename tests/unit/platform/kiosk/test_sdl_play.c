/* test_sdl_play.c -- Tests games that are played with a gamepad, by touch and with a mouse.
 *
 * The input comes from SDL's virtual joystick and from events of fingers and mouse. The drivers and
 * the frame loop are real, and fish must reach the bowl. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <SDL.h>
#include <cmocka.h>

#include "core/game/control/controller.h"
#include "core/game/mode_tags.h"
#include "core/tank/preset.h"
#include "drivers/gamepad/gamepads.h"
#include "drivers/null.h"
#include "drivers/pointer/mouse_poi.h"
#include "drivers/sim/hal_sim.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/calm_fish.h"

#define FRAME_NS 16666667ull
#define WIDTH 1280u
#define HEIGHT 720u

/* Simulated player: the target position of the ring, and the device that moves the ring. */
static struct sdl_player {
    struct clock_sim clock;
    struct gamepads gamepads;
    struct mouse_poi pointer;
    struct hal hal;
    struct kiosk kiosk;
    void (*send)(void); /* Function that sends the SDL events of the device, which move the ring
                          towards `over_m`. */
    vec3 over_m;
    uint8_t dips;
    float x, y; /* Position in the window of the finger that moves the ring. */
    uint8_t second_is_down;
} player;

static const struct view *festival_view(void)
{
    return &tank_preset(TANK_PRESET_FESTIVAL)->view;
}

static vec3 ring_m(void)
{
    return player.kiosk.core.world.poi[0].position_m;
}

static void frame(void)
{
    player.clock.now_ns += FRAME_NS;
    player.send();
    SDL_PumpEvents();
    kiosk_frame(&player.kiosk, &player.hal);
    assert_false(controller_is_lost(&player.kiosk.core.world, 0));
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        frame();
    }
}

/* ---- Simulated gamepad and finger ----------------------------------------------------------- */

static SDL_Joystick *joystick(void)
{
    return SDL_GameControllerGetJoystick(player.gamepads.pad[0].controller);
}

/* Returns the stick deflection for a distance of `way_m` to the target. The deflection is greater
 * than the dead zone (15 % of the range) at once, and is full from 8 cm on. */
static Sint16 push_of(float way_m)
{
    const float push = f_clamp(way_m / 0.08f, -1.0f, 1.0f);
    return (Sint16)((push > 0.0f ? 4900.0f : push < 0.0f ? -4900.0f : 0.0f) + push * 27800.0f);
}

static void send_pad(void)
{
    const vec3 way = v3_sub(player.over_m, ring_m());
    SDL_JoystickSetVirtualAxis(joystick(), SDL_CONTROLLER_AXIS_LEFTX, push_of(way.x));
    SDL_JoystickSetVirtualAxis(joystick(), SDL_CONTROLLER_AXIS_LEFTY, push_of(way.z));
    SDL_JoystickSetVirtualButton(joystick(), SDL_CONTROLLER_BUTTON_A, player.dips);
}

static void to_window(vec3 point, float *x, float *y)
{
    const struct basis axes = view_basis(festival_view());
    const vec3 body = vec_basis_to_body(&axes, v3_sub(point, festival_view()->eye_m));
    const float aspect = (float)WIDTH / (float)HEIGHT;
    const float tan_y = view_half_height_tan(festival_view(), aspect);
    *x = 0.5f * (body.x / -body.z / (tan_y * aspect) + 1.0f);
    *y = 0.5f * (1.0f - body.y / -body.z / tan_y);
}

static void push_finger(uint32_t type, SDL_FingerID id, float x, float y)
{
    SDL_Event event = { .type = type };
    event.tfinger.fingerId = id;
    event.tfinger.x = x;
    event.tfinger.y = y;
    assert_int_equal(SDL_PushEvent(&event), 1);
}

/* Slides the finger towards the screen position of the target. Under water the finger moves at half
 * the speed. */
static void send_fingers(void)
{
    float x;
    float y;
    const float pace = player.dips ? 0.0035f : 0.0070f;
    const float plane_m = player.dips ? DIP_DEPTH_M : 0.0f;
    to_window(v3(player.over_m.x, plane_m, player.over_m.z), &x, &y);
    player.x += f_clamp(x - player.x, -pace, pace);
    player.y += f_clamp(y - player.y, -pace, pace);
    push_finger(SDL_FINGERMOTION, 1, player.x, player.y);
    if (player.dips != player.second_is_down) {
        push_finger(player.dips ? SDL_FINGERDOWN : SDL_FINGERUP, 2, 0.9f, 0.9f);
        player.second_is_down = player.dips;
    }
}

/* ---- Rounds of the simulated player --------------------------------------------------------- */

static void begin_round(uint32_t seed)
{
    const struct kiosk_config config = { .core = { .seed = seed, .fish_count = 300 } };
    player.over_m = v3(0.0f, DIP_HOVER_M, 0.0f);
    player.dips = 0;
    assert_int_equal(kiosk_init(&player.kiosk, &player.hal, &config), CORE_OK);
    frames(20);
    player.kiosk.input.pressed = INPUT_START;
    while (player.kiosk.core.game.phase != PHASE_ROUND) {
        frame();
        assert_true(player.kiosk.core.game.tick < 10 * CORE_TICK_HZ);
    }
}

static const struct fish *choose(void)
{
    return calmest_fish(&player.kiosk.core.world.tank, ring_m(), DIP_DEPTH_M);
}

static void go_to(vec3 over_m, float near_m, uint32_t frames_max)
{
    player.over_m = over_m;
    for (uint32_t i = 0; i < frames_max; i++) {
        const vec3 way = v3_sub(over_m, ring_m());
        if (v3_length(v3(way.x, 0.0f, way.z)) < near_m) {
            return;
        }
        frame();
    }
}

/* Makes one attempt to scoop a fish. Dips the ring beside the fish, moves the ring below the fish,
 * lifts the fish and carries it over the bowl. If `flies` is 1, the target follows the ring during
 * the lift, so that the ring rises straight up. */
static void try_once(int flies)
{
    const struct fish *fish = choose();
    if (!fish) {
        frames(20);
        return;
    }
    const float side = fish->position_m.x > 0.0f ? -0.08f : 0.08f;
    go_to(v3_add(fish->position_m, v3(side, 0.0f, 0.0f)), 0.015f, 150);
    player.dips = 1;
    frames(22);
    for (uint32_t i = 0; i < 45; i++) {
        player.over_m = fish->position_m;
        frame();
    }
    player.dips = 0;
    for (uint32_t i = 0; i < 35; i++) {
        player.over_m = flies ? ring_m() : player.over_m;
        frame();
    }
    if (player.kiosk.core.world.poi[0].carried_count > 0) {
        const vec3 bowl_m = player.kiosk.core.world.bowl[0].position_m;
        go_to(v3(bowl_m.x, DIP_HOVER_M, bowl_m.z), 0.012f, 200);
        frames(100);
    }
}

static uint32_t landed_in(uint32_t rounds, int flies, const char *what)
{
    uint32_t landed = 0;
    for (uint32_t seed = 1; seed <= rounds; seed++) {
        begin_round(seed);
        for (uint32_t i = 0; i < 12 && player.kiosk.core.game.phase == PHASE_ROUND; i++) {
            try_once(flies);
        }
        landed += player.kiosk.core.game.player[0].caught;
    }
    print_message("%s: %u fish in %u rounds\n", what, landed, rounds);
    return landed;
}

/* ---- Time from START to the first dip ------------------------------------------------------- */

/* Moves the mouse in a straight line to (x, y) in the window, in 0.3 s. */
static void glide_mouse(float x, float y)
{
    const float from_x = player.x, from_y = player.y;
    for (int32_t i = 1; i <= 18; i++) {
        player.x = from_x + (x - from_x) * (float)i / 18.0f;
        player.y = from_y + (y - from_y) * (float)i / 18.0f;
        SDL_Event event = { .type = SDL_MOUSEMOTION };
        event.motion.x = (Sint32)player.x;
        event.motion.y = (Sint32)player.y;
        assert_int_equal(SDL_PushEvent(&event), 1);
        frame();
    }
}

static void push_button(uint32_t type)
{
    SDL_Event event = { .type = type };
    event.button.button = SDL_BUTTON_LEFT;
    assert_int_equal(SDL_PushEvent(&event), 1);
    frames(12);
}

static void click_mouse(void)
{
    push_button(SDL_MOUSEBUTTONDOWN);
    push_button(SDL_MOUSEBUTTONUP);
}

static void send_nothing(void)
{
}

/* Plays with a mouse from START to the first dip. The visitor waits for `look_s` seconds in the
 * selection of game modes, and then clicks on the wooden tag `tag`. If `tag` is MODE_TAG_COUNT, the
 * visitor clicks without moving the pointer. Returns the time in seconds. */
static float start_to_dip_s(uint32_t tag, float look_s)
{
    const struct kiosk_config config = { .core = { .seed = 1,
                                                   .fish_count = 300,
                                                   .modes = (1u << CHOICE_COUNT) - 1u,
                                                   .level = LEVEL_NORMAL } };
    const struct core *core = &player.kiosk.core;
    assert_int_equal(kiosk_init(&player.kiosk, &player.hal, &config), CORE_OK);
    glide_mouse(900.0f, 650.0f);
    frames(20);
    player.kiosk.input.pressed = INPUT_START;
    const uint32_t start = core->game.tick;
    frames(1u + (uint32_t)(look_s * 60.0f));
    assert_int_equal(core->game.phase, PHASE_MODE_SELECT);
    if (tag < MODE_TAG_COUNT) {
        const struct layout_box box = mode_tag_box(false, (1u << MODE_TAG_COUNT) - 1u, tag);
        glide_mouse(box.x + 0.5f * box.width, box.y + 0.5f * box.height);
    }
    click_mouse();
    assert_int_equal(core->game.phase, PHASE_READY);
    glide_mouse(640.0f, 330.0f);
    /* The click on the tag is a dip, but not the dip that ends the ghost. */
    assert_int_equal(core->lessons.player[0].ghost.state, GHOST_RUNS);
    while (core->world.poi[0].immersed <= 0.0f || core->game.phase != PHASE_ROUND) {
        click_mouse();
        assert_true(core->game.tick - start < 30u * CORE_TICK_HZ);
    }
    return (float)(core->game.tick - start) * CORE_TICK_S;
}

/* ---- A whole game --------------------------------------------------------------------------- */

/* Moves the mouse towards the screen position of the target. The left button dips the ring. */
static void send_mouse(void)
{
    float x, y;
    const float pace = player.dips ? 4.5f : 9.0f;
    const float plane_m = player.dips ? DIP_DEPTH_M : 0.0f;
    to_window(v3(player.over_m.x, plane_m, player.over_m.z), &x, &y);
    player.x += f_clamp(x * (float)WIDTH - player.x, -pace, pace);
    player.y += f_clamp(y * (float)HEIGHT - player.y, -pace, pace);
    SDL_Event event = { .type = SDL_MOUSEMOTION };
    event.motion.x = (Sint32)player.x;
    event.motion.y = (Sint32)player.y;
    assert_int_equal(SDL_PushEvent(&event), 1);
    if (player.dips != player.second_is_down) {
        SDL_Event button = { .type = player.dips ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP };
        button.button.button = SDL_BUTTON_LEFT;
        assert_int_equal(SDL_PushEvent(&button), 1);
        player.second_is_down = player.dips;
    }
}

static void wait_for(uint8_t phase, uint32_t seconds_max)
{
    for (uint32_t i = 0; i < seconds_max * 60u && player.kiosk.core.game.phase != phase; i++) {
        frame();
    }
    assert_int_equal(player.kiosk.core.game.phase, phase);
}

/* ---- Tests ---------------------------------------------------------------------------------- */

static void open_mouse(void)
{
    mouse_poi_init(&player.pointer, player.hal.clock, festival_view(), WIDTH, HEIGHT,
                   POINTER_FILTER_MOUSE);
    player.hal.poi[0] = mouse_poi_devices(&player.pointer).poi;
    player.send = send_nothing;
}

static int begin(void **state)
{
    (void)state;
    memset(&player, 0, sizeof player);
    player.clock.now_ns = 1000000000ull;
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    SDL_InitSubSystem(SDL_INIT_VIDEO);
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    player.hal = null_hal(NULL);
    player.hal.clock = sim_clock_device(&player.clock);
    return 0;
}

static int end(void **state)
{
    (void)state;
    while (SDL_NumJoysticks() > 0 && SDL_JoystickDetachVirtual(0) == 0) {
    }
    gamepads_close(&player.gamepads);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return 0;
}

static void test_a_gamepad_player_lands_fish(void **state)
{
    (void)state;
    gamepads_init(&player.gamepads, player.hal.clock, festival_view());
    assert_int_equal(gamepads_open(&player.gamepads, NULL), HAL_OK);
    assert_true(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                          SDL_CONTROLLER_BUTTON_DPAD_RIGHT + 1, 0) >= 0);
    gamepads_poll(&player.gamepads);
    assert_non_null(player.gamepads.pad[0].controller);
    player.hal.poi[0] = gamepad_poi_devices(&player.gamepads, 0).poi;
    player.send = send_pad;
    assert_true(landed_in(4, 1, "a pad") >= 4);
}

static void test_a_touch_player_lands_fish(void **state)
{
    (void)state;
    mouse_poi_init(&player.pointer, player.hal.clock, festival_view(), WIDTH, HEIGHT,
                   POINTER_FILTER_TOUCH);
    player.hal.poi[0] = mouse_poi_devices(&player.pointer).poi;
    player.send = send_fingers;
    player.x = player.y = 0.5f;
    push_finger(SDL_FINGERDOWN, 1, player.x, player.y);
    assert_true(landed_in(4, 0, "fingers") >= 4);
}

static void test_a_mouse_dips_within_eight_seconds_of_start_after_one_choice(void **state)
{
    (void)state;
    open_mouse();
    for (uint32_t tag = 0; tag < MODE_TAG_LEVELS; tag++) {
        const float taken_s = start_to_dip_s(tag, 2.0f);
        print_message("from START to the first dip: %.1f s\n", (double)taken_s);
        assert_true(taken_s <= 8.0f);
        assert_int_equal(player.kiosk.core.game.player[0].level, mode_tags[tag].level);
        assert_int_equal(player.kiosk.core.game.mode, MODE_FESTIVAL);
    }
    assert_true(start_to_dip_s(MODE_TAG_COUNT, 0.6f) <= 6.0f);
    assert_int_equal(player.kiosk.core.game.player[0].level, LEVEL_NORMAL);
}

static void test_one_mouse_plays_from_start_to_the_album(void **state)
{
    (void)state;
    open_mouse();
    start_to_dip_s(0, 2.0f);
    player.send = send_mouse;
    player.over_m = v3(0.0f, DIP_HOVER_M, 0.0f);
    frames(30);
    while (player.kiosk.core.game.phase == PHASE_ROUND) {
        try_once(0);
    }
    const uint32_t caught = player.kiosk.core.game.player[0].caught;
    print_message("a mouse: %u fish at level easy\n", caught);
    assert_true(caught > 0);
    player.dips = 0;
    wait_for(PHASE_RESULT, 5);
    wait_for(PHASE_ALBUM, 30);
    assert_int_equal(player.kiosk.core.game.album.fish_count,
                     caught < ALBUM_FISH_MAX ? caught : ALBUM_FISH_MAX);
    wait_for(PHASE_ATTRACT, 60);
}

/* Opens the kiosk with the settings `dip` and `reach`, and begins a round by START. */
static void play_with_settings(int32_t dip, int32_t reach)
{
    struct kiosk_config kiosk = { .core = { .seed = 1, .fish_count = 40 } };
    struct settings *settings = &kiosk.core.persistent.settings;
    settings_reset(settings);
    settings->value[SET_DIP] = dip;
    settings->value[SET_REACH] = reach;
    assert_int_equal(kiosk_init(&player.kiosk, &player.hal, &kiosk), CORE_OK);
    glide_mouse(640.0f, 400.0f);
    player.kiosk.input.pressed = INPUT_START;
    wait_for(PHASE_ROUND, 20);
}

static void test_the_setting_dip_reaches_the_mouse(void **state)
{
    (void)state;
    const struct poi *poi = &player.kiosk.core.world.poi[0];
    open_mouse();
    for (int32_t by_click = 0; by_click < 2; by_click++) {
        play_with_settings(by_click, 100);
        click_mouse();
        frames(60);
        assert_int_equal(poi->immersed > 0.5f, by_click);
        click_mouse();
        frames(60);
        assert_true(poi->immersed < 0.5f);
    }
}

static void test_the_setting_reach_reaches_the_mouse(void **state)
{
    (void)state;
    float z_m[2];
    open_mouse();
    for (int32_t i = 0; i < 2; i++) {
        play_with_settings(0, i == 0 ? 100 : 60);
        glide_mouse(640.0f, 0.45f * (float)HEIGHT);
        frames(60);
        z_m[i] = ring_m().z;
    }
    /* With a reach of 60 %, the player moves the pointer only in the lower 60 % of the picture. At
     * 45 % of the height from the top, the pointer is close to the upper end of this part. */
    print_message("the ring is at %.2f m, and at %.2f m with a reach of 60 %%\n", (double)z_m[0],
                  (double)z_m[1]);
    assert_true(z_m[1] < z_m[0] - 0.1f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_gamepad_player_lands_fish, begin, end),
        cmocka_unit_test_setup_teardown(test_a_touch_player_lands_fish, begin, end),
        cmocka_unit_test_setup_teardown(
            test_a_mouse_dips_within_eight_seconds_of_start_after_one_choice, begin, end),
        cmocka_unit_test_setup_teardown(test_one_mouse_plays_from_start_to_the_album, begin, end),
        cmocka_unit_test_setup_teardown(test_the_setting_dip_reaches_the_mouse, begin, end),
        cmocka_unit_test_setup_teardown(test_the_setting_reach_reaches_the_mouse, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
