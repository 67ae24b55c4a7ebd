/* test_deck.c -- Tests the picture of the rim and the counter that is kept while the camera
 * moves. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "platform/kiosk/output_devices.h"
#include "platform/render/display_gl.h"
#include "tests/unit/support/display_fixture.h"

static double mean_difference(void)
{
    uint64_t sum = 0;
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        sum += (uint64_t)abs(pixels[0][i] - pixels[1][i]);
    }
    return (double)sum / PIXELS_SIZE;
}

/* Moves the camera without a turn by the share `share` of its distance from a place of the
 * water. */
static void come_closer(float share)
{
    const vec3 way = v3_scale(v3_sub(v3(0.2f, 0.0f, 0.1f), scene.view.eye_m), share);
    scene.view.eye_m = v3_add(scene.view.eye_m, way);
    scene.view.target_m = v3_add(scene.view.target_m, way);
}

/* Draws the frame with a new picture of the rim. */
static void draw_anew(uint8_t out[PIXELS_SIZE])
{
    display.renderer.basin.kept = (struct deck_view){ 0 };
    picture(out);
}

/* Expects that the kept picture is that of the camera `view`. */
static void expect_kept(const struct view *view)
{
    assert_true(display.renderer.basin.kept.is_drawn);
    assert_memory_equal(&display.renderer.basin.kept.view, view, sizeof *view);
}

/* Draws the scene with the kept rim and with a new one. The mean difference between the two must be
 * less than `limit` of the difference from pixels[0], which the camera `rest` saw. */
static void expect_similar_rim(const struct view *rest, double limit)
{
    picture(pixels[1]);
    const double moved = mean_difference();
    expect_kept(rest);
    draw_anew(pixels[0]);
    const double changed = mean_difference();
    print_message("mean difference: %.2f from the camera at rest, %.2f from the drawn rim\n", moved,
                  changed);
    assert_true(moved > 5.0 && changed < limit * moved);
}

static void test_a_closer_camera_sees_the_kept_rim_as_it_would_be_drawn(void **state)
{
    (void)state;
    const struct view rest = scene.view;
    scene.phase = PHASE_WORDLESS;
    picture(pixels[0]);
    come_closer(0.1f);
    expect_similar_rim(&rest, 0.05);
}

static void test_a_drifting_camera_sees_the_kept_rim_as_it_would_be_drawn(void **state)
{
    (void)state;
    const struct view rest = scene.view;
    scene.phase = PHASE_WORDLESS;
    picture(pixels[0]);
    scene.view.eye_m = v3_add(scene.view.eye_m, v3(0.045f, 0.02f, 0.03f));
    expect_similar_rim(&rest, 0.1);
}

static void test_a_place_beyond_the_kept_picture_gets_a_new_picture(void **state)
{
    (void)state;
    const struct view rest = scene.view;
    picture(pixels[0]);
    expect_kept(&rest);
    /* The first place is beside the picture, and the second too close. */
    for (uint32_t i = 0; i < 2; i++) {
        scene.view = rest;
        if (i == 0) {
            scene.view.target_m.x += 0.3f;
        } else {
            come_closer(0.5f);
        }
        picture(pixels[0]);
        expect_kept(&scene.view);
        /* On its way back the camera sees a part of the picture at rest. */
        scene.view = rest;
        come_closer(0.1f);
        picture(pixels[0]);
        expect_kept(&rest);
    }
}

static void test_the_picture_of_a_wider_camera_becomes_that_at_rest(void **state)
{
    (void)state;
    const struct view rest = scene.view;
    /* The second of the first cameras is so close that its picture cannot replace that at rest. */
    for (uint32_t i = 0; i < 2; i++) {
        display.renderer.basin.kept = (struct deck_view){ 0 };
        scene.view = rest;
        come_closer(i == 0 ? 0.1f : 0.5f);
        picture(pixels[0]);
        expect_kept(&scene.view);
        scene.view = rest;
        picture(pixels[0]);
        expect_kept(&rest);
        come_closer(0.5f);
        picture(pixels[0]);
        scene.view = rest;
        come_closer(0.1f);
        picture(pixels[0]);
        expect_kept(&rest);
    }
}

static void test_a_turned_screen_gets_the_picture_of_its_own_camera_at_rest(void **state)
{
    (void)state;
    const struct view rests[2] = { scene.view, scene.turned_view };
    for (uint32_t i = 0; i < 4; i++) {
        const bool is_turned = i & 1u;
        scene.view = rests[is_turned];
        assert_int_equal(renderer_resize(&display.renderer, is_turned ? HEIGHT : WIDTH,
                                         is_turned ? WIDTH : HEIGHT),
                         HAL_OK);
        renderer_draw(&display.renderer, &scene);
        expect_kept(&scene.view);
        come_closer(0.5f);
        renderer_draw(&display.renderer, &scene);
        expect_kept(&scene.view);
        scene.view = rests[is_turned];
        come_closer(0.1f);
        renderer_draw(&display.renderer, &scene);
        expect_kept(&rests[is_turned]);
    }
}

static void test_new_render_targets_get_the_picture_of_the_camera_at_rest(void **state)
{
    (void)state;
    const struct view rest = scene.view;
    picture(pixels[0]);
    come_closer(0.1f);
    assert_int_equal(renderer_lower(&display.renderer, 4u), HAL_OK);
    picture(pixels[0]);
    expect_kept(&rest);
    assert_int_equal(renderer_warm_up(&display.renderer, &display.shown, 1u), HAL_OK);
    picture(pixels[0]);
    expect_kept(&rest);
    draw_anew(pixels[1]);
    assert_true(mean_difference() < 1.0);
}

/* Sizes of the picture, one of each usual shape of a screen. */
static const uint32_t sizes_px[][2] = {
    { 160, 90 }, { 120, 90 }, { 210, 90 }, { 90, 160 }, { 90, 120 },
};

/* Plays a round of one player in the tank `preset`, and draws some frames of its camera. The poi
 * circles at the walls. */
static void play_round(uint8_t preset, uint32_t width, uint32_t height)
{
    static const struct output_dimmer dimmer;
    static struct output_camera camera;
    const bool is_turned = height > width;
    const struct view rest = tank_preset_view(tank_preset(preset), is_turned);
    memset(&camera, 0, sizeof camera);
    scene.phase = PHASE_ROUND;
    scene.view = rest;
    scene.tank_size_m = tank_preset(preset)->size_m;
    scene.wall_height_m = tank_preset(preset)->wall_height_m;
    assert_int_equal(renderer_resize(&display.renderer, width, height), HAL_OK);
    renderer_draw(&display.renderer, &scene);
    for (uint32_t step = 0; step < 1200u; step++) {
        const float turn = 0.01f * (float)step;
        scene.poi[0].position_m = v3(0.49f * scene.tank_size_m.x * f_cos(turn), 0.035f,
                                     0.49f * scene.tank_size_m.z * f_sin(turn));
        scene.tick += 2u;
        scene.view = rest;
        output_camera_step(&camera, &dimmer, &scene, is_turned, true, &scene.view);
        if (step % 60u == 59u) {
            renderer_draw(&display.renderer, &scene);
            expect_kept(&rest);
        }
    }
    assert_true(camera.closer[0].at > 0.05f);
}

static void test_the_kept_picture_shows_all_that_the_camera_of_a_round_sees(void **state)
{
    (void)state;
    scene.fish_count = 0;
    scene.poi[0].present = scene.bowl[0].present = 1;
    scene.poi[0].ring_radius_m = 0.04f;
    scene.bowl[0].radius_m = 0.08f;
    scene.bowl[0].depth_m = 0.06f;
    for (uint32_t i = 1; i < POI_MAX; i++) {
        scene.bowl[i].present = 0;
    }
    for (uint32_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        for (uint32_t i = 0; i < sizeof sizes_px / sizeof *sizes_px; i++) {
            play_round((uint8_t)preset, sizes_px[i][0], sizes_px[i][1]);
        }
    }
}

/* Draws the tank `preset` from the camera at rest and from the eight places that are farthest from
 * the rest in attract mode (`drift_m` in output_devices.c). */
static void drift(uint8_t preset, uint32_t width, uint32_t height)
{
    const bool is_turned = height > width;
    const struct view rest = tank_preset_view(tank_preset(preset), is_turned);
    scene.view = rest;
    scene.tank_size_m = tank_preset(preset)->size_m;
    scene.wall_height_m = tank_preset(preset)->wall_height_m;
    assert_int_equal(renderer_resize(&display.renderer, width, height), HAL_OK);
    renderer_draw(&display.renderer, &scene);
    for (uint32_t i = 0; i < 8; i++) {
        const vec3 off_m =
            v3(i & 1u ? 0.045f : -0.045f, i & 2u ? 0.02f : -0.02f, i & 4u ? 0.03f : -0.03f);
        scene.view = rest;
        scene.view.eye_m = v3_add(rest.eye_m, view_to_world(is_turned, off_m));
        renderer_draw(&display.renderer, &scene);
        expect_kept(&rest);
    }
}

static void test_the_kept_picture_shows_all_that_the_drifting_camera_sees(void **state)
{
    (void)state;
    scene.fish_count = 0;
    scene.phase = PHASE_ATTRACT;
    for (uint32_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        for (uint32_t i = 0; i < sizeof sizes_px / sizeof *sizes_px; i++) {
            drift((uint8_t)preset, sizes_px[i][0], sizes_px[i][1]);
        }
    }
}

/* In attract mode, the drifting camera looks aside. */
static void test_the_rim_stays_at_the_tank_while_the_camera_looks_aside(void **state)
{
    (void)state;
    const float *const map = display.renderer.frame.block.shade_map;
    scene.view.eye_m.x += 0.2f;
    picture(pixels[0]);
    assert_true(map[2] == 1.0f && map[3] == 0.0f);
    scene.view = scene.turned_view;
    scene.view.eye_m.z += 0.2f;
    picture(pixels[0]);
    assert_true(map[2] == 0.0f && map[3] == -1.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DISPLAY(test_a_closer_camera_sees_the_kept_rim_as_it_would_be_drawn),
        WITH_DISPLAY(test_a_drifting_camera_sees_the_kept_rim_as_it_would_be_drawn),
        WITH_DISPLAY(test_a_place_beyond_the_kept_picture_gets_a_new_picture),
        WITH_DISPLAY(test_the_picture_of_a_wider_camera_becomes_that_at_rest),
        WITH_DISPLAY(test_a_turned_screen_gets_the_picture_of_its_own_camera_at_rest),
        WITH_DISPLAY(test_new_render_targets_get_the_picture_of_the_camera_at_rest),
        WITH_DISPLAY(test_the_kept_picture_shows_all_that_the_camera_of_a_round_sees),
        WITH_DISPLAY(test_the_kept_picture_shows_all_that_the_drifting_camera_sees),
        WITH_DISPLAY(test_the_rim_stays_at_the_tank_while_the_camera_looks_aside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
