/* test_dimmer.c -- Tests the brightness of the display, the pixel shift against burn-in, and the
 * camera in attract mode and in a round. The display is bright during a game, dimmed when idle, and
 * dark at night. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/poi/poi.h"
#include "core/tank/preset.h"
#include "platform/kiosk/output_devices.h"

_Static_assert(CAMERA_HIDDEN_M < POI_OUTER_RADIUS_M, "a poi at a wall is visible");

#define FRAME_NS 16666667ull
#define S 1000000000ull

static struct output_dimmer dimmer;
static struct settings settings;
static struct input input;
static struct display_settings display_settings;
static uint64_t now_ns;
static struct output_camera camera;
static struct scene scene;

static int set_up(void **state)
{
    (void)state;
    memset(&dimmer, 0, sizeof dimmer);
    memset(&input, 0, sizeof input);
    memset(&camera, 0, sizeof camera);
    memset(&scene, 0, sizeof scene);
    settings_reset(&settings);
    now_ns = 77 * S;
    return 0;
}

static void frame(int is_attract)
{
    now_ns += FRAME_NS;
    output_dimmer_notice(&dimmer, &input, is_attract);
    display_settings = output_dimmer_step(&dimmer, &settings, &input, is_attract, now_ns);
    input.pressed = input.coin_count[0] = 0;
}

static void frames(uint64_t seconds, int is_attract)
{
    for (uint64_t end_ns = now_ns + seconds * S; now_ns < end_ns;) {
        frame(is_attract);
    }
}

static void test_the_brightness_follows_the_setting(void **state)
{
    (void)state;
    frame(1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    settings.value[SET_BRIGHTNESS] = 40;
    settings.value[SET_ROTATION] = 3;
    settings.value[SET_OVERSCAN_X] = 25;
    settings.value[SET_OVERSCAN_Y] = 50;
    frame(0);
    assert_float_equal(display_settings.light, 0.4f, 1e-6f);
    assert_int_equal(display_settings.rotation, 3);
    assert_float_equal(display_settings.inset_x, 0.025f, 1e-6f);
    assert_float_equal(display_settings.inset_y, 0.050f, 1e-6f);
}

static void test_an_idle_display_dims_slowly_and_a_coin_restores_it_immediately(void **state)
{
    (void)state;
    settings.value[SET_DIM_AFTER_MIN] = 5;
    settings.value[SET_DIM] = 30;
    frame(1);
    frames(299, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    frames(2, 1);
    assert_true(display_settings.light < 1.0f && display_settings.light > 0.5f);
    frames(4, 1);
    assert_float_equal(display_settings.light, 0.3f, 1e-4f);
    input.coin_count[0] = 1;
    frames(1, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    frames(298, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
}

static void test_the_display_never_dims_in_a_game_or_when_dimming_is_off(void **state)
{
    (void)state;
    settings.value[SET_DIM_AFTER_MIN] = 5;
    frames(600, 0);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    settings.value[SET_DIM_AFTER_MIN] = 0;
    frames(600, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
}

static void test_a_moving_pose_prevents_dimming_and_sensor_noise_does_not(void **state)
{
    (void)state;
    settings.value[SET_DIM_AFTER_MIN] = 5;
    input.poi[0].link = POI_SOURCE_LIVE;
    frame(1);
    for (uint32_t i = 0; i < 310u * 60u; i++) {
        input.poi[0].target.position_m.x = i % 2u ? 0.004f : -0.004f;
        input.poi[0].target.position_m.z = i % 300u ? 0.0f : 0.0f / 0.0f;
        frame(1);
    }
    assert_true(display_settings.light < 0.6f);
    input.poi[0].target.position_m = v3(0.05f, 0.0f, 0.0f);
    frames(1, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
}

static void night(int32_t from, int32_t to, uint16_t day, uint16_t minute)
{
    settings.value[SET_NIGHT_FROM_MIN] = from;
    settings.value[SET_NIGHT_TO_MIN] = to;
    input.day = day;
    input.minute = minute;
}

static void test_the_display_is_dark_at_night_until_an_input(void **state)
{
    (void)state;
    night(22 * 60, 6 * 60, 9700, 23 * 60);
    frame(1);
    frames(DIMMER_NIGHT_IDLE_S + 5u, 1);
    assert_float_equal(display_settings.light, 0.0f, 1e-6f);
    input.pressed = INPUT_START;
    frames(1, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    frames(DIMMER_NIGHT_IDLE_S + 5u, 1);
    assert_float_equal(display_settings.light, 0.0f, 1e-6f);
    night(22 * 60, 6 * 60, 9701, 6 * 60);
    frames(1, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
}

static void test_an_unset_clock_disables_night_mode(void **state)
{
    (void)state;
    settings.value[SET_DIM_AFTER_MIN] = 0;
    night(0, 1425, 0, 600);
    frame(1);
    frames(DIMMER_NIGHT_IDLE_S + 5u, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    night(600, 600, 9700, 600);
    frames(5, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    night(600, 660, 9700, 660);
    frames(5, 1);
    assert_float_equal(display_settings.light, 1.0f, 1e-6f);
    night(600, 660, 9700, 659);
    frames(5, 1);
    assert_float_equal(display_settings.light, 0.0f, 1e-6f);
}

/* Runs 24 hours of attract mode at 20 frames per second. At a height of 720 pixels the picture is
 * shifted by -4 to 4 pixels in each direction, so there are 81 offsets. Counts the used offsets,
 * and measures the longest time at one offset. */
static void test_static_elements_shift_by_one_pixel_every_few_minutes(void **state)
{
    (void)state;
    uint8_t seen[9][9] = { { 0 } };
    uint32_t places = 0, stays = 0, longest = 0;
    int32_t before_x = 0, before_y = 0;
    frame(1);
    for (uint32_t i = 0; i < 24u * 3600u * 20u; i++) {
        now_ns += 50u * 1000000ull;
        display_settings = output_dimmer_step(&dimmer, &settings, &input, 1, now_ns);
        const int32_t x = (int32_t)f_floor(display_settings.shift_x * 720.0f + 0.5f);
        const int32_t y = (int32_t)f_floor(display_settings.shift_y * 720.0f + 0.5f);
        assert_in_range(x + 4, 0, 8);
        assert_in_range(y + 4, 0, 8);
        const int32_t step = (x - before_x) * (x - before_x) + (y - before_y) * (y - before_y);
        assert_in_range(step, 0, 2);
        stays = step ? 0 : stays + 1u;
        longest = stays > longest ? stays : longest;
        places += !seen[y + 4][x + 4];
        seen[y + 4][x + 4] = 1;
        before_x = x;
        before_y = y;
    }
    print_message("%u of 81 offsets, at most %u s at one offset\n", places, longest / 20u);
    assert_true(places > 70u);
    assert_true(longest < 10u * 60u * 20u);
}

static void test_static_elements_do_not_shift_while_the_player_aims(void **state)
{
    (void)state;
    frames(300, 1);
    const struct display_settings before = display_settings;
    frames(600, 0);
    assert_float_equal(display_settings.shift_x, before.shift_x, 1e-7f);
    assert_float_equal(display_settings.shift_y, before.shift_y, 1e-7f);
}

#define TEST(test) cmocka_unit_test_setup(test, set_up)

static const struct view rest = { .eye_m = { 0.0f, 1.0f, 0.7f }, .half_height_tan = 0.25f };

/* Advances the camera by `seconds` and returns its last view. Each view is at most 2 cm from the
 * view before, so that no picture jumps. */
static struct view camera_after(uint32_t seconds)
{
    struct view last = rest, view = rest;
    scene.phase = PHASE_ATTRACT;
    for (uint32_t i = 0; i < seconds * 60u; i++) {
        frame(1);
        scene.tick += 2;
        view = rest;
        output_camera_step(&camera, &dimmer, &scene, false, true, &view);
        assert_true(i == 0 || v3_length(v3_sub(view.eye_m, last.eye_m)) < 0.02f);
        last = view;
    }
    return view;
}

static float way_m(const struct view *view)
{
    return v3_length(v3_sub(view->eye_m, rest.eye_m));
}

static void test_the_camera_drifts_only_after_ten_idle_seconds(void **state)
{
    (void)state;
    struct view view = camera_after(9);
    assert_memory_equal(&view, &rest, sizeof rest);
    view = camera_after(8);
    assert_true(way_m(&view) > 0.005f && way_m(&view) < 0.06f);
    input.pressed = INPUT_START;
    view = camera_after(3);
    assert_memory_equal(&view, &rest, sizeof rest);
}

static void test_the_camera_shows_a_landed_fish_closely_for_a_moment(void **state)
{
    (void)state;
    scene.bowl[2] = (struct scene_bowl){ .present = 1, .position_m = { 0.3f, 0.0f, 0.1f } };
    camera_after(12);
    scene.bowl[2].fish_count = 1;
    struct view view = camera_after(3);
    assert_memory_equal(&view.target_m, &scene.bowl[2].position_m, sizeof view.target_m);
    assert_true(v3_length(v3_sub(view.eye_m, view.target_m)) < 0.5f);
    view = camera_after(4);
    assert_true(way_m(&view) < 0.06f);
    /* If the ticks begin anew, as in the next session, the camera also returns. */
    scene.bowl[2].fish_count = 2;
    camera_after(1);
    scene.tick = 5;
    view = camera_after(3);
    assert_true(way_m(&view) < 0.06f);
}

static void test_the_camera_returns_in_the_frame_of_a_touch(void **state)
{
    (void)state;
    struct view view = rest;
    scene.phase = PHASE_ATTRACT;
    camera = (struct output_camera){ .drift = 0.5f, .seen_tick = scene.tick };
    /* The time of the frame is rounded down to a millisecond, and the time of the touch is not. */
    dimmer.seen_ns = 20u * NS_PER_S;
    dimmer.touched_ns = dimmer.seen_ns + 400000u;
    scene.tick += 2;
    output_camera_step(&camera, &dimmer, &scene, false, true, &view);
    assert_true(camera.drift < 0.5f);
}

static void test_the_camera_rests_in_a_game(void **state)
{
    (void)state;
    struct view view = rest;
    camera_after(20);
    scene.phase = PHASE_ROUND;
    for (uint32_t i = 0; i < 120; i++) {
        frame(0);
        scene.tick += 2;
        view = rest;
        output_camera_step(&camera, &dimmer, &scene, false, true, &view);
    }
    assert_memory_equal(&view, &rest, sizeof rest);
}

/* ---- The camera in a round ------------------------------------------------------------------ */

static struct view tank_rest; /* Camera of the tank at rest. */
static bool is_turned, follows;

/* Begins a round of one player in the tank `preset`. The poi hovers over the middle. */
static void begin_camera_round(uint8_t preset, bool turned)
{
    memset(&camera, 0, sizeof camera);
    memset(&scene, 0, sizeof scene);
    scene.phase = PHASE_ROUND;
    scene.tank_size_m = tank_preset(preset)->size_m;
    scene.bowl[1].present = scene.poi[1].present = 1;
    scene.poi[1].position_m.y = 0.035f;
    is_turned = turned;
    follows = true;
    tank_rest = tank_preset_view(tank_preset(preset), turned);
}

static struct view round_frame(uint32_t ticks)
{
    struct view view = tank_rest;
    frame(0);
    scene.tick += ticks;
    output_camera_step(&camera, &dimmer, &scene, is_turned, follows, &view);
    return view;
}

/* Runs `seconds` of the round at 60 frames a second and returns the last view. */
static struct view round_after(uint32_t seconds)
{
    struct view view = tank_rest;
    for (uint32_t i = 0; i < 60u * seconds; i++) {
        view = round_frame(2);
    }
    return view;
}

/* Returns the position of a point in the picture: -1 to 1 on both axes if it is visible. */
static void seen_at(const struct view *view, vec3 point_m, float *x, float *y)
{
    const struct basis axes = view_basis(view);
    const vec3 body = vec_basis_to_body(&axes, v3_sub(point_m, view->eye_m));
    *y = body.y / -body.z / view->half_height_tan;
    *x = body.x / -body.z / (view->half_height_tan * view->aspect_min);
}

/* Checks that the picture shows the corner of the water in the directions `x` and `z` (-1 or 1) in
 * the player's axes, except for the strips that may be hidden. Checks that the place under each
 * pointer is the place that the picture shows there. */
static void check_corner(const struct view *view, float x, float z, float strip_x_m,
                         float strip_z_m)
{
    const vec3 size_m = view_from_world(is_turned, scene.tank_size_m);
    const float far = is_turned ? CAMERA_FAR_EDGE_TURNED : CAMERA_FAR_EDGE;
    const vec3 corner_m =
        view_to_world(is_turned, v3(x * (0.5f * f_abs(size_m.x) - strip_x_m), 0.0f,
                                    z * (0.5f * f_abs(size_m.z) - (z > 0.0f ? strip_z_m : 0.0f))));
    float across, up;
    seen_at(view, corner_m, &across, &up);
    assert_true(f_abs(across) < CAMERA_SIDE_EDGE + 0.001f);
    assert_true(up > -CAMERA_NEAR_EDGE - 0.001f && up < far + 0.001f);
    const vec3 mapped_m = view_point_on_plane(view, view->aspect_min, across, up, 0.0f);
    assert_true(v3_length(v3_sub(mapped_m, corner_m)) < 1e-4f);
}

static void test_the_camera_comes_closer_and_hides_no_place_of_the_poi(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2u * TANK_PRESET_COUNT; i++) {
        float most = 0.0f;
        begin_camera_round((uint8_t)(i / 2u), i & 1u);
        struct view before = tank_rest;
        for (uint32_t step = 0; step < 1200; step++) {
            /* The poi circles, and jumps once to the opposite corner. */
            const float turn = 0.01f * (float)step + (step < 600 ? 0.0f : 0.5f * F_TAU);
            scene.poi[1].position_m.x = 0.49f * scene.tank_size_m.x * f_cos(turn);
            scene.poi[1].position_m.z = 0.49f * scene.tank_size_m.z * f_sin(turn);
            const struct view view = round_frame(2);
            for (uint32_t corner = 0; corner < 4; corner++) {
                check_corner(&view, corner & 1u ? 1.0f : -1.0f, corner & 2u ? 1.0f : -1.0f,
                             CAMERA_HIDDEN_M, CAMERA_HIDDEN_M);
            }
            assert_true(v3_length(v3_sub(view.eye_m, before.eye_m)) < 0.003f);
            before = view;
            most = f_max(most, camera.closer[0].at);
        }
        assert_true(camera.closer[0].at > 0.05f && most < CAMERA_CLOSER_MAX + 1e-4f);
    }
}

/* The poi goes under water in one corner, far from two walls, and moves to the opposite corner. */
static void test_the_picture_shows_a_poi_that_moves_to_a_wall_under_water(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4u * 2u * TANK_PRESET_COUNT; i++) {
        begin_camera_round((uint8_t)(i / 8u), i & 4u);
        const float x = i & 1u ? 1.0f : -1.0f, z = i & 2u ? 1.0f : -1.0f;
        const vec3 corner_m = v3(x * (0.5f * scene.tank_size_m.x - POI_OUTER_RADIUS_M), 0.0f,
                                 z * (0.5f * scene.tank_size_m.z - POI_OUTER_RADIUS_M));
        scene.poi[1].position_m = v3_sub(v3(0.0f, 0.035f, 0.0f), corner_m);
        round_after(8);
        scene.poi[1].position_m = v3_add(v3(0.0f, -0.05f, 0.0f), corner_m);
        const struct view view = round_after(2);
        float across, up;
        seen_at(&view, scene.poi[1].position_m, &across, &up);
        assert_true(camera.closer[0].at > 0.05f);
        assert_true(f_abs(across) < 1.0f && f_abs(up) < 1.0f);
    }
}

static void test_the_camera_is_closest_over_the_middle_of_the_tank(void **state)
{
    (void)state;
    for (uint32_t turned = 0; turned < 2; turned++) {
        begin_camera_round(TANK_PRESET_FESTIVAL, turned != 0);
        round_after(8);
        assert_true(camera.closer[0].at > CAMERA_CLOSER_MAX - 0.001f);
    }
}

static void test_the_picture_shows_the_whole_water_beside_the_poi(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4u * 2u * TANK_PRESET_COUNT; i++) {
        begin_camera_round((uint8_t)(i / 8u), i & 4u);
        const float x = i & 1u ? 1.0f : -1.0f, z = i & 2u ? 1.0f : -1.0f;
        const vec3 size_m = view_from_world(is_turned, scene.tank_size_m);
        const vec3 hand_m = v3(x * (0.5f * f_abs(size_m.x) - POI_OUTER_RADIUS_M), 0.035f,
                               z * (0.5f * f_abs(size_m.z) - POI_OUTER_RADIUS_M));
        scene.poi[1].position_m = view_to_world(is_turned, hand_m);
        const struct view view = round_after(8);
        check_corner(&view, x, z, 0.0f, 0.0f);
        check_corner(&view, x, -z, 0.0f, CAMERA_HIDDEN_M);
        check_corner(&view, -x, z, CAMERA_HIDDEN_M, 0.0f);
    }
}

static void test_the_camera_leans_to_the_side_of_the_poi(void **state)
{
    (void)state;
    begin_camera_round(TANK_PRESET_OFFICIAL, false);
    scene.poi[1].position_m.x = 0.5f;
    assert_true(round_after(8).eye_m.x > 0.005f);
    scene.poi[1].position_m.x = -0.5f;
    assert_true(round_after(8).eye_m.x < -0.005f);
}

static void test_the_camera_rests_without_ticks_and_while_the_poi_is_under_water(void **state)
{
    (void)state;
    begin_camera_round(TANK_PRESET_FESTIVAL, false);
    struct view before = round_after(1), view = round_frame(0);
    assert_memory_equal(&view, &before, sizeof view);
    scene.poi[1].position_m = v3(0.3f, -0.05f, 0.1f);
    before = round_after(3);
    view = round_after(1);
    assert_true(v3_length(v3_sub(view.eye_m, before.eye_m)) < 1e-5f);
    assert_true(camera.closer[0].at > 0.005f);
}

static void test_the_camera_returns_exactly_after_the_round(void **state)
{
    (void)state;
    begin_camera_round(TANK_PRESET_FESTIVAL, false);
    round_after(5);
    scene.phase = PHASE_RESULT;
    const struct view view = round_after(8);
    assert_memory_equal(&view, &tank_rest, sizeof view);
}

static void test_the_camera_rests_with_two_players_and_if_the_setting_says_so(void **state)
{
    (void)state;
    begin_camera_round(TANK_PRESET_FESTIVAL, false);
    scene.bowl[0].present = scene.poi[0].present = 1;
    struct view view = round_after(3);
    assert_memory_equal(&view, &tank_rest, sizeof view);
    scene.bowl[0].present = 0;
    follows = false;
    view = round_after(3);
    assert_memory_equal(&view, &tank_rest, sizeof view);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_the_brightness_follows_the_setting),
        TEST(test_an_idle_display_dims_slowly_and_a_coin_restores_it_immediately),
        TEST(test_the_display_never_dims_in_a_game_or_when_dimming_is_off),
        TEST(test_a_moving_pose_prevents_dimming_and_sensor_noise_does_not),
        TEST(test_the_display_is_dark_at_night_until_an_input),
        TEST(test_an_unset_clock_disables_night_mode),
        TEST(test_static_elements_shift_by_one_pixel_every_few_minutes),
        TEST(test_static_elements_do_not_shift_while_the_player_aims),
        TEST(test_the_camera_drifts_only_after_ten_idle_seconds),
        TEST(test_the_camera_shows_a_landed_fish_closely_for_a_moment),
        TEST(test_the_camera_returns_in_the_frame_of_a_touch),
        TEST(test_the_camera_rests_in_a_game),
        TEST(test_the_camera_comes_closer_and_hides_no_place_of_the_poi),
        TEST(test_the_picture_shows_a_poi_that_moves_to_a_wall_under_water),
        TEST(test_the_camera_is_closest_over_the_middle_of_the_tank),
        TEST(test_the_picture_shows_the_whole_water_beside_the_poi),
        TEST(test_the_camera_leans_to_the_side_of_the_poi),
        TEST(test_the_camera_rests_without_ticks_and_while_the_poi_is_under_water),
        TEST(test_the_camera_returns_exactly_after_the_round),
        TEST(test_the_camera_rests_with_two_players_and_if_the_setting_says_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
