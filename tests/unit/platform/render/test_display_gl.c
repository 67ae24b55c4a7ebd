/* test_display_gl.c -- Tests the real display driver without a screen: events, sizes, connectors,
 * limits, and the rotation of the picture. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/game/lab/lab.h"
#include "core/game/menu/menu.h"
#include "platform/render/display_gl.h"
#include "tests/unit/support/display_fixture.h"

static bool is_minimised;

/* Replaces SDL's function in this test program, because SDL's offscreen driver cannot minimise a
 * window. */
void SDL_GL_GetDrawableSize(SDL_Window *window, int *width, int *height)
{
    SDL_GetWindowSize(window, width, height);
    if (is_minimised) {
        *width = *height = 0;
    }
}

static void test_the_display_description_names_the_renderer_and_the_quality(void **state)
{
    (void)state;
    assert_non_null(strstr(device.ops->describe(device.self), "OpenGL ES 3"));
    assert_non_null(strstr(device.ops->describe(device.self), "320x180, scene "));
}

static void test_equal_scenes_give_equal_pictures(void **state)
{
    (void)state;
    picture(pixels[0]);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static void test_reading_a_picture_needs_a_frame_and_a_buffer(void **state)
{
    (void)state;
    struct hal_image image = { .rgb = pixels[0], .size = PIXELS_SIZE };
    assert_int_equal(device.ops->capture(device.self, &image), HAL_ERR_IO);
    assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    image.size = PIXELS_SIZE - 1u;
    assert_int_equal(device.ops->capture(device.self, &image), HAL_ERR_IO);
    image.size = PIXELS_SIZE;
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
}

static void test_the_display_consumes_quit_events_and_leaves_other_events(void **state)
{
    (void)state;
    struct display_events events;
    SDL_Event event = { .type = SDL_MOUSEMOTION };
    SDL_PushEvent(&event);
    event.type = SDL_KEYDOWN;
    SDL_PushEvent(&event);
    assert_int_equal(device.ops->poll(device.self, &events), HAL_OK);
    assert_int_equal(events.quit, 0);
    event.type = SDL_QUIT;
    SDL_PushEvent(&event);
    assert_int_equal(device.ops->poll(device.self, &events), HAL_OK);
    assert_int_equal(events.quit, 1);
    assert_int_equal(events.lost, 0);
    assert_true(SDL_HasEvent(SDL_MOUSEMOTION));
    assert_true(SDL_HasEvent(SDL_KEYDOWN));
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
}

static void test_the_picture_has_the_size_of_the_window(void **state)
{
    (void)state;
    picture(pixels[0]);
    SDL_SetWindowSize(display.window, 200, 160);
    struct hal_image image = { .rgb = pixels[1], .size = PIXELS_SIZE };
    assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
    assert_int_equal(image.width, 200);
    assert_int_equal(image.height, 160);
    assert_non_null(strstr(device.ops->describe(device.self), "200x160"));
}

/* Some window managers ignore the minimum size of a window. A window of any size must therefore be
 * drawn without an error. */
static void test_a_window_of_a_few_pixels_is_drawn_into(void **state)
{
    (void)state;
    static const int sides[][2] = { { 1, 1 }, { 3, 200 }, { 200, 3 }, { 8, 8 } };
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_ROUND, PHASE_MENU };
    alarm(60);
    for (uint32_t i = 0; i < 12u; i++) {
        SDL_SetWindowSize(display.window, sides[i % 4u][0], sides[i % 4u][1]);
        scene.phase = phases[i / 4u];
        scene.menu.page = MENU_CARD;
        assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    alarm(0);
}

static uint32_t steps_drawn;

static void count_step(void *context, enum render_step step)
{
    (void)context;
    (void)step;
    steps_drawn++;
}

static void test_on_demand_drawing_skips_frames_without_a_picture(void **state)
{
    (void)state;
    picture(pixels[0]);
    display.config.on_demand = true;
    display.renderer.on_step = count_step;
    for (uint32_t i = 0; i < 50u; i++) {
        assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    }
    assert_int_equal(steps_drawn, 0);
    picture(pixels[1]);
    assert_true(steps_drawn > 0);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* A hint fades in from the frame in which it first occurs. The display may skip this frame because
 * no picture was requested, but the fade-in must begin all the same. */
static void test_a_picture_on_demand_shows_the_hint_of_skipped_frames(void **state)
{
    (void)state;
    scene.phase = PHASE_ROUND;
    scene.hint = HINT_TORN;
    for (uint32_t way = 0; way < 2u; way++) {
        display.renderer.ui.memory.hint = HINT_NONE;
        display.config.on_demand = way != 0;
        scene.tick = 1000;
        assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
        scene.tick = 1000 + CORE_TICK_HZ;
        picture(pixels[way]);
    }
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* The picture is square, so that a rotation does not change its size. SDL's offscreen surface
 * cannot change its size. */
#define SIDE HEIGHT

/* Returns the index of the first byte of a pixel. (x, y) is the pixel's position before the square
 * picture is rotated by `rotation` clockwise quarter turns. */
static uint32_t turned_at(uint32_t rotation, uint32_t x, uint32_t y)
{
    for (uint32_t i = 0; i < rotation; i++) {
        const uint32_t left = x;
        x = SIDE - 1u - y;
        y = left;
    }
    return (y * SIDE + x) * 3u;
}

static void square(uint8_t rgb[PIXELS_SIZE], uint32_t rotation)
{
    struct hal_image image = { .rgb = rgb, .size = PIXELS_SIZE };
    device.ops->set_transform(device.self,
                              &(struct display_settings){ .rotation = rotation, .light = 1.0f });
    /* 20 frames are enough to refine the texture of the fish on the album page completely. */
    for (uint32_t i = 0; i < 20u; i++) {
        assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    }
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
    assert_int_equal(image.width, SIDE);
}

/* Draws the page `phase` with and without a rotation. Rotates one picture back, and asserts that
 * both pictures are equal except for small rounding errors. */
static void show_turned(uint8_t phase, uint32_t rotation)
{
    uint64_t sum = 0;
    scene.phase = phase;
    square(pixels[0], 0);
    square(pixels[1], rotation);
    for (uint32_t i = 0; i < SIDE * SIDE * 3u; i++) {
        const uint32_t at = i / 3u;
        const int32_t a = pixels[0][i];
        const int32_t b = pixels[1][turned_at(rotation, at % SIDE, at / SIDE) + i % 3u];
        sum += (uint64_t)(a > b ? a - b : b - a);
    }
    const float mean = (float)sum / (float)(SIDE * SIDE * 3u);
    print_message("phase %u, %u quarters: mean difference %.2f of 255\n", phase, rotation,
                  (double)mean);
    assert_true(mean < 1.5f);
}

static void test_a_rotated_display_shows_the_same_picture_rotated(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_ALBUM };
    core.world.tank.fish[0].gait = GAIT_BOWL;
    core.world.tank.fish[0].holder = 0;
    core.game.album = (struct album){ 0 };
    album_note(&core.game.album, &core.world, 0, 1);
    core.game.phase = PHASE_ALBUM;
    core_scene(&core, &scene);
    scene.phase_s = 5.0f;
    memset(scene.slope[RIPPLE_Z / 2], 100, sizeof scene.slope[0]); /* Adds waves, which distort the
                                                                      floor of the tank. */
    SDL_SetWindowSize(display.window, (int)SIDE, (int)SIDE);
    for (uint32_t i = 0; i < 3u * sizeof phases; i++) {
        show_turned(phases[i / 3u], 1u + i % 3u);
    }
}

static void test_a_rotated_screen_is_reported_as_portrait(void **state)
{
    (void)state;
    struct display_events events;
    for (uint32_t rotation = 0; rotation < 4; rotation++) {
        device.ops->set_transform(
            device.self, &(struct display_settings){ .rotation = rotation, .light = 1.0f });
        assert_int_equal(device.ops->poll(device.self, &events), HAL_OK);
        assert_int_equal(events.upright, rotation & 1u);
    }
}

static void test_the_screen_is_black_outside_the_picture(void **state)
{
    (void)state;
    const struct display_settings inset = { .inset_x = 0.1f, .inset_y = 0.2f, .light = 1.0f };
    device.ops->set_transform(device.self, &inset);
    picture(pixels[0]);
    uint32_t lit = 0;
    for (uint32_t y = 0; y < HEIGHT; y++) {
        for (uint32_t x = 0; x < WIDTH; x++) {
            const uint8_t *pixel = pixels[0] + (y * WIDTH + x) * 3u;
            const int is_inside = x >= 32u && x < WIDTH - 32u && y >= 36u && y < HEIGHT - 36u;
            lit += is_inside && pixel[0] + pixel[1] + pixel[2] > 0;
            assert_true(is_inside || pixel[0] + pixel[1] + pixel[2] == 0);
        }
    }
    assert_true(lit > 256u * 108u * 9u / 10u);
}

static void test_brightness_scales_each_colour_and_zero_is_black(void **state)
{
    (void)state;
    device.ops->set_transform(device.self, &(struct display_settings){ .light = 1.0f });
    picture(pixels[0]);
    device.ops->set_transform(device.self, &(struct display_settings){ .light = 0.5f });
    picture(pixels[1]);
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        assert_in_range(pixels[1][i] + 2 - pixels[0][i] / 2, 0, 4);
    }
    device.ops->set_transform(device.self, &(struct display_settings){ .light = 0.0f });
    picture(pixels[1]);
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        assert_int_equal(pixels[1][i], 0);
    }
}

static void test_a_high_density_screen_is_drawn_at_its_full_resolution(void **state)
{
    (void)state;
    assert_true(SDL_GetWindowFlags(display.window) & SDL_WINDOW_ALLOW_HIGHDPI);
}

static void test_a_minimised_window_is_retried_without_a_fault(void **state)
{
    (void)state;
    picture(pixels[0]);
    is_minimised = true;
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_BUSY);
    is_minimised = false;
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static uint32_t ends;

static void count_end(void *context)
{
    (void)context;
    ends++;
}

static void test_a_reset_of_the_graphics_driver_reopens_the_display(void **state)
{
    (void)state;
    struct display_events events;
    ends = 0;
    display_gl_on_lost(&display, count_end, NULL);
    device.ops->set_transform(device.self,
                              &(struct display_settings){ .rotation = 2, .light = 1.0f });
    picture(pixels[0]);
    gl_fail(&display.renderer.status, "as if the driver had reset");
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_GONE);
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_GONE);
    assert_int_equal(device.ops->poll(device.self, &events), HAL_ERR_GONE);
    /* The kiosk can reopen a lost display, so the program must not end. */
    assert_int_equal(events.lost, 0);
    assert_int_equal(ends, 0);
    assert_non_null(strstr(device.ops->describe(device.self), "as if the driver had reset"));
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* Creates the files of a connector as in /sys/class/drm. `status` is the connection status of the
 * connector. */
static void plug(const char *folder, const char *socket, const char *status)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, socket);
    mkdir(path, 0700);
    snprintf(path, sizeof path, "%s/%s/status", folder, socket);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(status, file);
    fclose(file);
}

static void unmake(const char *folder)
{
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

static void test_only_connectors_with_a_monitor_are_counted(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-drm-XXXXXX";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(screen_connectors("/nonexistent").count, 0);
    plug(folder, "renderD128", "connected\n");
    plug(folder, "card1", "connected\n");
    plug(folder, "card1-Writeback-1", "unknown\n");
    plug(folder, "card1-HDMI-A-1", "disconnected\n");
    plug(folder, "card1-HDMI-A-2", "connected\n");
    const struct connectors one = screen_connectors(folder);
    assert_int_equal(one.count, 2);
    assert_int_equal(one.connected, 1);
    plug(folder, "card1-HDMI-A-1", "connected\n");
    plug(folder, "card1-HDMI-A-2", "disconnected\n");
    const struct connectors other = screen_connectors(folder);
    assert_int_equal(other.connected, 1);
    assert_true(one.which != other.which);
    unmake(folder);
}

/* Polls the display after moving the time of its last check two seconds into the past. The poll
 * therefore checks the connectors again. */
static int look(struct display_events *events)
{
    display.connectors_read_ns -= 2000000000ull;
    return device.ops->poll(device.self, events);
}

/* `is_bare` simulates a machine without a window system, on which the display must check whether
 * its screen is connected. */
static void test_an_unplugged_screen_is_gone_until_it_returns(void **state)
{
    (void)state;
    struct display_events events;
    char folder[] = "/tmp/kingyo-drm-XXXXXX";
    assert_non_null(mkdtemp(folder));
    plug(folder, "card0-HDMI-A-1", "connected\n");
    display.config.sockets = folder;
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    display.is_bare = true;
    picture(pixels[0]);
    assert_int_equal(look(&events), HAL_OK);
    plug(folder, "card0-HDMI-A-1", "disconnected\n");
    /* The screen was missing in one check only, which may be a short interruption, so the display
     * is not lost yet. */
    assert_int_equal(look(&events), HAL_OK);
    plug(folder, "card0-HDMI-A-1", "connected\n");
    assert_int_equal(look(&events), HAL_OK);
    plug(folder, "card0-HDMI-A-1", "disconnected\n");
    assert_int_equal(look(&events), HAL_OK);
    assert_int_equal(look(&events), HAL_ERR_GONE);
    assert_int_equal(events.lost, 0);
    assert_non_null(strstr(device.ops->describe(device.self), "unplugged"));
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_GONE);
    setenv("SDL_VIDEODRIVER", "kmsdrm", 1);
    display.config.off_screen = false;
    /* Without a screen, open() must fail before it calls SDL, and must name the missing screen as
     * the reason. */
    assert_int_equal(device.ops->open(device.self), HAL_ERR_GONE);
    assert_non_null(strstr(device.ops->describe(device.self), "no screen is connected"));
    unsetenv("SDL_VIDEODRIVER");
    display.config.off_screen = true;
    plug(folder, "card0-HDMI-A-1", "connected\n");
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
    unmake(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DISPLAY(test_the_display_description_names_the_renderer_and_the_quality),
        WITH_DISPLAY(test_equal_scenes_give_equal_pictures),
        WITH_DISPLAY(test_reading_a_picture_needs_a_frame_and_a_buffer),
        WITH_DISPLAY(test_the_display_consumes_quit_events_and_leaves_other_events),
        WITH_DISPLAY(test_the_picture_has_the_size_of_the_window),
        WITH_DISPLAY(test_a_window_of_a_few_pixels_is_drawn_into),
        WITH_DISPLAY(test_on_demand_drawing_skips_frames_without_a_picture),
        WITH_DISPLAY(test_a_picture_on_demand_shows_the_hint_of_skipped_frames),
        WITH_DISPLAY(test_a_rotated_display_shows_the_same_picture_rotated),
        WITH_DISPLAY(test_a_rotated_screen_is_reported_as_portrait),
        WITH_DISPLAY(test_the_screen_is_black_outside_the_picture),
        WITH_DISPLAY(test_brightness_scales_each_colour_and_zero_is_black),
        WITH_DISPLAY(test_a_high_density_screen_is_drawn_at_its_full_resolution),
        WITH_DISPLAY(test_a_minimised_window_is_retried_without_a_fault),
        WITH_DISPLAY(test_a_reset_of_the_graphics_driver_reopens_the_display),
        cmocka_unit_test(test_only_connectors_with_a_monitor_are_counted),
        WITH_DISPLAY(test_an_unplugged_screen_is_gone_until_it_returns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
