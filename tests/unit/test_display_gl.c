/* test_display_gl.c -- the real display without a screen: pictures, events, sizes and limits. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/game/album.h"
#include "core/morph/morph.h"
#include "core/show.h"
#include "platform/render/display_gl.h"

#define WIDTH 320u
#define HEIGHT 180u
#define PIXELS_SIZE (WIDTH * HEIGHT * 3u)

static struct core core;
static struct scene scene;
static struct display_gl display;
static struct hal_display device;
static uint8_t pixels[2][PIXELS_SIZE];

static bool is_minimised;

/* In SDL's place: its offscreen driver minimises nothing. */
void SDL_GL_GetDrawableSize(SDL_Window *window, int *width, int *height)
{
    SDL_GetWindowSize(window, width, height);
    if (is_minimised) {
        *width = *height = 0;
    }
}

static int open_display(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 60 };
    core_init(&core, &config);
    core_scene(&core, &scene);
    memset(&display, 0, sizeof display);
    display.config =
        (struct display_gl_config){ .width = WIDTH, .height = HEIGHT, .off_screen = true };
    device = display_gl_device(&display);
    return device.ops->open(device.self);
}

static int close_display(void **state)
{
    (void)state;
    device.ops->close(device.self);
    return 0;
}

static void picture(uint8_t out[PIXELS_SIZE])
{
    struct hal_image image = { .rgb = out, .size = PIXELS_SIZE };
    scene.veil = 0.0f; /* A chapter begins in the dark. */
    assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
    assert_int_equal(image.width, WIDTH);
    assert_int_equal(image.height, HEIGHT);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void test_it_says_what_draws_and_how_finely(void **state)
{
    (void)state;
    assert_non_null(strstr(device.ops->describe(device.self), "OpenGL ES 3"));
    assert_non_null(strstr(device.ops->describe(device.self), "320x180, scene "));
}

static void test_the_same_scene_is_the_same_picture(void **state)
{
    (void)state;
    picture(pixels[0]);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static void test_one_fish_a_hole_and_a_wave_each_change_the_picture(void **state)
{
    (void)state;
    scene.fish_count = 0;
    scene.poi[0].present = 1;
    scene.poi[0].ring_radius_m = 0.04f;
    scene.poi[0].position_m = v3(0.0f, 0.05f, 0.0f);
    memset(scene.poi[0].integrity, 255, sizeof scene.poi[0].integrity);
    picture(pixels[0]);
    scene.poi[0].integrity[16 * SHEET_SIDE + 16] = 0;
    scene.poi[0].integrity[16 * SHEET_SIDE + 17] = 0;
    scene.poi[0].integrity[17 * SHEET_SIDE + 16] = 0;
    scene.poi[0].integrity[17 * SHEET_SIDE + 17] = 0;
    picture(pixels[1]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
    scene.fish_count = 1;
    picture(pixels[0]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
    memset(scene.slope[RIPPLE_Z / 2], 100, sizeof scene.slope[0]);
    picture(pixels[1]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* The sum of one colour over the 5 x 5 pixels in the middle. */
static uint32_t middle(const uint8_t rgb[PIXELS_SIZE], uint32_t colour)
{
    uint32_t sum = 0;
    for (uint32_t y = HEIGHT / 2u - 2u; y <= HEIGHT / 2u + 2u; y++) {
        for (uint32_t x = WIDTH / 2u - 2u; x <= WIDTH / 2u + 2u; x++) {
            sum += rgb[(y * WIDTH + x) * 3u + colour];
        }
    }
    return sum;
}

/* One fish of 8 cm, tipped up by 45 degrees with its nose at `nose_y_m`; the eye is over it and
 * looks at a point of its head 3 mm behind the tip. */
static void show_gulper(float nose_y_m, uint8_t place)
{
    struct scene_fish *fish = &scene.fish[0];
    scene.phase = PHASE_WORDLESS;
    scene.fish_count = 1;
    scene.poi[0].present = scene.bowl[0].present = 0;
    memset(scene.slope, 0, sizeof scene.slope);
    fish->angles = (struct angles){ .pitch_rad = 45.0f * F_DEG };
    fish->length_m = 0.08f;
    fish->place = place;
    fish->maturity = 0.0f; /* Grey: no colour is at the end of its scale. */
    fish->position_m = v3(0.0f, nose_y_m - 0.0283f, 0.0f);
    scene.view.target_m = v3(0.0f, nose_y_m - 0.0021f, -0.0262f);
    scene.view.eye_m = v3(0.0f, nose_y_m + 0.15f, 0.02f);
}

static void test_a_snout_above_the_surface_shows_as_in_air_and_below_it_through_water(void **state)
{
    (void)state;
    show_gulper(0.006f, SCENE_IN_TANK);
    picture(pixels[0]);
    show_gulper(0.006f, SCENE_ON_POI);
    picture(pixels[1]);
    for (uint32_t colour = 0; colour < 3; colour++) {
        const int32_t off =
            (int32_t)middle(pixels[0], colour) - (int32_t)middle(pixels[1], colour);
        assert_in_range(off + 100, 0, 200); /* 4 of 255 a pixel. */
    }
    show_gulper(-0.03f, SCENE_IN_TANK);
    picture(pixels[1]);
    print_message("red of a snout: %u in air, %u under 3 cm of water, of 6375\n",
                  middle(pixels[0], 0), middle(pixels[1], 0));
    assert_true(middle(pixels[0], 0) > middle(pixels[1], 0) + 25u * 12u);
}

/* Of the middle column, rows `top` to `bottom`: how much redder than green is the reddest. */
static float reddest(const uint8_t rgb[PIXELS_SIZE], uint32_t top, uint32_t bottom)
{
    float most = 0.0f;
    for (uint32_t y = top; y < bottom; y++) {
        const uint8_t *pixel = rgb + (y * WIDTH + WIDTH / 2u) * 3u;
        most = f_max(most, 1.0f - (float)pixel[1] / f_max((float)pixel[0], 1.0f));
    }
    return most;
}

/* All red, in air, from its left; it fills the middle. */
static float red_in_hand(float age_days)
{
    core_scene(&core, &scene);
    scene.phase = PHASE_WORDLESS;
    scene.poi[0].present = scene.bowl[0].present = 0;
    scene.fish_count = 1;
    scene.fish[0] = (struct scene_fish){
        .position_m = v3(0.0f, 0.12f, 0.0f), .length_m = 0.08f, .place = SCENE_ON_POI,
        .age_days = age_days, .maturity = show_maturity(age_days),
        .progress = life_progress(&species_wakin.card, age_days) };
    scene.view.target_m = v3(0.0f, 0.12f, 0.0f);
    scene.view.eye_m = v3(-0.10f, 0.13f, 0.0f);
    picture(pixels[0]);
    return reddest(pixels[0], HEIGHT / 2u - 3u, HEIGHT / 2u + 3u);
}

/* Alone on the album's page, noted by the game as it notes a catch, so long into its life. */
static float red_in_album(float age_days, float caught_days)
{
    core.tank.fish[0].look = 0;
    core.tank.fish[0].age_days = caught_days;
    core.tank.fish[0].gait = GAIT_BOWL;
    core.tank.fish[0].holder = 0;
    album_clear(&core.game.album);
    album_note(&core, 0, 1);
    core.game.phase = PHASE_ALBUM;
    core_scene(&core, &scene);
    scene.phase_s = 5.0f;
    scene.album.fish[0].age_days = age_days;
    scene.album.fish[0].maturity = show_maturity(age_days);
    scene.album.fish[0].progress = life_progress(&species_wakin.card, age_days);
    scene.album.fish[0].is_caught = 0; /* Its seal is red, too. */
    for (uint32_t i = 0; i < 20; i++) { /* Until its paint is fine. */
        picture(pixels[0]);
    }
    return reddest(pixels[0], HEIGHT / 5u, HEIGHT * 3u / 5u);
}

/* Older than 120 days all are red; younger, each has turned as far as in the tank. */
static void test_on_the_day_it_was_met_a_fish_of_the_album_looks_as_in_the_tank(void **state)
{
    (void)state;
    for (float days = 56.0f; days < 130.0f; days += 8.0f) {
        const float tank = red_in_hand(days), album = red_in_album(days, days);
        print_message("%3.0f days: %.2f in the hand, %.2f in the album\n", (double)days,
                      (double)tank, (double)album);
        assert_true(f_abs(tank - album) < 0.20f);
    }
    assert_true(red_in_album(60.0f, 100.0f) < 0.35f); /* Before that it is young, and dark. */
}

/* A poi that lies level 5 cm over the water; the eye is over its middle. */
static void show_poi(void)
{
    struct scene_poi *const poi = &scene.poi[0];
    scene.phase = PHASE_WORDLESS;
    scene.fish_count = 0;
    scene.bowl[0].present = 0;
    memset(scene.slope, 0, sizeof scene.slope);
    *poi = (struct scene_poi){ .present = 1,
                               .position_m = v3(0.0f, 0.05f, 0.0f),
                               .ring_radius_m = 0.04f,
                               .paper_left = 1.0f };
    memset(poi->wetness, 255, sizeof poi->wetness);
    memset(poi->integrity, 255, sizeof poi->integrity);
    scene.view.target_m = poi->position_m;
    scene.view.eye_m = v3(0.0f, 0.30f, 0.02f);
}

static uint32_t brightness(const uint8_t rgb[PIXELS_SIZE])
{
    return 3u * middle(rgb, 0) + 6u * middle(rgb, 1) + middle(rgb, 2); /* As an eye weighs them. */
}

static void test_more_stress_is_brighter_for_every_eye_and_only_in_practice(void **state)
{
    (void)state;
    show_poi();
    picture(pixels[0]);
    memset(scene.poi[0].stress, 128, sizeof scene.poi[0].stress);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
    uint32_t before = 0;
    scene.poi[0].shows_stress = 1;
    for (uint32_t stress = 0; stress <= 250u; stress += 25u) {
        memset(scene.poi[0].stress, (int)stress, sizeof scene.poi[0].stress);
        picture(pixels[0]);
        assert_true(brightness(pixels[0]) > before);
        before = brightness(pixels[0]);
    }
}

static void test_water_on_a_poi_lies_over_its_paper_and_hides_below_the_surface(void **state)
{
    (void)state;
    show_poi();
    scene.poi[0].sag_m = 0.003f;
    picture(pixels[0]);
    scene.poi[0].water_m = 0.002f;
    picture(pixels[1]);
    assert_true(middle(pixels[0], 0) > middle(pixels[1], 0)); /* Bluer where it is deep. */
    scene.poi[0].position_m.y = -0.04f;
    picture(pixels[1]);
    scene.poi[0].water_m = 0.0f;
    picture(pixels[0]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* How many pixels in the picture are white plastic. */
static uint32_t white_pixels(const uint8_t rgb[PIXELS_SIZE])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PIXELS_SIZE; i += 3u) {
        count += rgb[i] > 190 && rgb[i + 1] > 180 && rgb[i + 2] > 170;
    }
    return count;
}

static void test_players_are_told_apart_without_colours(void **state)
{
    (void)state;
    uint32_t before = 0;
    for (uint8_t owner = 0; owner < POI_MAX; owner++) {
        show_poi();
        scene.poi[0].owner = owner;
        memset(scene.poi[0].integrity, 0, sizeof scene.poi[0].integrity); /* The ring alone. */
        picture(pixels[0]);
        const uint32_t white = white_pixels(pixels[0]);
        print_message("player %d: %u white pixels\n", owner + 1, white);
        assert_true(owner == 0 || white > before + before / 8u);
        before = white;
    }
}

static void test_a_gulp_opens_the_mouth_and_rings_the_water(void **state)
{
    (void)state;
    show_gulper(0.004f, SCENE_IN_TANK);
    picture(pixels[0]);
    scene.fish[0].gape = 1.0f;
    picture(pixels[1]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
    scene.fish[0].gulp = 0.4f;
    picture(pixels[0]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static void test_a_pump_that_runs_bubbles_and_its_stone_stays(void **state)
{
    (void)state;
    show_gulper(-0.06f, SCENE_IN_TANK);
    scene.fish_count = 0;
    scene.pump = (struct scene_pump){ .stone_m = { 0.0f, -0.12f, 0.0f } };
    scene.view.target_m = v3(0.0f, -0.06f, 0.0f);
    scene.view.eye_m = v3(0.0f, 0.2f, 0.1f);
    picture(pixels[0]);
    scene.pump.present = 1;
    picture(pixels[1]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
    scene.pump.runs = 1;
    picture(pixels[0]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static void test_a_tank_can_be_shown_without_a_word(void **state)
{
    (void)state;
    scene.hint = HINT_START;
    scene.phase = PHASE_ATTRACT;
    picture(pixels[0]);
    scene.phase = PHASE_WORDLESS;
    picture(pixels[1]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
    scene.hint = HINT_DIP;
    scene.language = LANGUAGE_EN;
    picture(pixels[0]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static void test_the_fullest_scene_draws_without_an_error(void **state)
{
    (void)state;
    for (uint32_t i = scene.fish_count; i < SCENE_FISH_MAX; i++) {
        scene.fish[i] = scene.fish[i % 60u];
        scene.fish[i].place = (uint8_t)(i % 3u);
        scene.fish[i].look = i * 2654435761u;
    }
    scene.fish_count = SCENE_FISH_MAX;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.bowl[i].present = 1;
        scene.poi[i].owner = scene.bowl[i].owner = (uint8_t)i;
        scene.poi[i].ring_radius_m = 0.04f;
        scene.bowl[i].radius_m = 0.075f;
        scene.bowl[i].depth_m = 0.055f;
        scene.bowl[i].position_m = v3(0.1f * (float)i, 0.01f, 0.0f);
    }
    picture(pixels[0]);
}

static void test_a_picture_needs_a_frame_and_room(void **state)
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

static void test_it_takes_quit_and_leaves_other_devices_their_events(void **state)
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

static void test_the_picture_follows_the_size_of_the_window(void **state)
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

#define SIDE HEIGHT /* Of a square screen: SDL's offscreen surface keeps its first size. */

/* A point of a square picture, where it is after that many quarter turns clockwise. */
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
    device.ops->place(device.self, &(struct showing){ .rotation = rotation, .light = 1.0f });
    for (uint32_t i = 0; i < 20u; i++) { /* Until the album's paint is fine. */
        assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    }
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
    assert_int_equal(image.width, SIDE);
}

/* The whole of what there is: tank, words, a fish on the album's page. */
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

static void test_a_turned_picture_is_the_same_picture_turned(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ATTRACT, PHASE_ALBUM };
    core.tank.fish[0].gait = GAIT_BOWL;
    core.tank.fish[0].holder = 0;
    album_clear(&core.game.album);
    album_note(&core, 0, 1);
    core.game.phase = PHASE_ALBUM;
    core_scene(&core, &scene);
    scene.phase_s = 5.0f;
    memset(scene.slope[RIPPLE_Z / 2], 100, sizeof scene.slope[0]); /* Waves bend the floor. */
    SDL_SetWindowSize(display.window, (int)SIDE, (int)SIDE);
    for (uint32_t i = 0; i < 3u * sizeof phases; i++) {
        show_turned(phases[i / 3u], 1u + i % 3u);
    }
}

static void test_a_screen_is_upright_as_its_picture_is(void **state)
{
    (void)state;
    struct display_events events;
    for (uint32_t rotation = 0; rotation < 4; rotation++) {
        device.ops->place(device.self, &(struct showing){ .rotation = rotation, .light = 1.0f });
        assert_int_equal(device.ops->poll(device.self, &events), HAL_OK);
        assert_int_equal(events.upright, rotation & 1u);
    }
}

static void test_beside_the_picture_the_screen_is_black(void **state)
{
    (void)state;
    const struct showing inset = { .inset_x = 0.1f, .inset_y = 0.2f, .light = 1.0f };
    device.ops->place(device.self, &inset);
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

static void test_half_the_light_is_half_of_each_colour_and_none_is_black(void **state)
{
    (void)state;
    device.ops->place(device.self, &(struct showing){ .light = 1.0f });
    picture(pixels[0]);
    device.ops->place(device.self, &(struct showing){ .light = 0.5f });
    picture(pixels[1]);
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        assert_in_range(pixels[1][i] + 2 - pixels[0][i] / 2, 0, 4);
    }
    device.ops->place(device.self, &(struct showing){ .light = 0.0f });
    picture(pixels[1]);
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        assert_int_equal(pixels[1][i], 0);
    }
}

static void test_it_takes_every_pixel_of_a_dense_screen(void **state)
{
    (void)state;
    assert_true(SDL_GetWindowFlags(display.window) & SDL_WINDOW_ALLOW_HIGHDPI);
}

static void test_a_minimised_window_is_asked_again_and_no_fault(void **state)
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

static void test_a_driver_that_resets_is_gone_and_opened_again_as_it_was(void **state)
{
    (void)state;
    struct display_events events;
    ends = 0;
    display_gl_on_lost(&display, count_end, NULL);
    device.ops->place(device.self, &(struct showing){ .rotation = 2, .light = 1.0f });
    picture(pixels[0]);
    gl_fail(&display.renderer.status, "as if the driver had reset");
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_GONE);
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_GONE);
    assert_int_equal(device.ops->poll(device.self, &events), HAL_ERR_GONE);
    assert_int_equal(events.lost, 0); /* Not for good. */
    assert_int_equal(ends, 0);
    assert_non_null(strstr(device.ops->describe(device.self), "as if the driver had reset"));
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* A socket of a card that is made of files. */
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

static void test_only_sockets_with_a_screen_count(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-drm-XXXXXX";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(connectors_read("/nonexistent").count, 0);
    plug(folder, "renderD128", "connected\n");
    plug(folder, "card1", "connected\n");
    plug(folder, "card1-Writeback-1", "unknown\n");
    plug(folder, "card1-HDMI-A-1", "disconnected\n");
    plug(folder, "card1-HDMI-A-2", "connected\n");
    const struct connectors one = connectors_read(folder);
    assert_int_equal(one.count, 2);
    assert_int_equal(one.connected, 1);
    plug(folder, "card1-HDMI-A-1", "connected\n");
    plug(folder, "card1-HDMI-A-2", "disconnected\n");
    const struct connectors other = connectors_read(folder);
    assert_int_equal(other.connected, 1);
    assert_true(one.which != other.which);
    unmake(folder);
}

/* Polls as if a second had passed since it looked. */
static int look(struct display_events *events)
{
    display.looked_ns -= 2000000000ull;
    return device.ops->poll(device.self, events);
}

/* As on a card without a window system; what draws is off screen all the same. */
static void test_a_screen_that_is_pulled_out_is_gone_until_it_is_back(void **state)
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
    assert_int_equal(look(&events), HAL_OK); /* It may have wobbled. */
    plug(folder, "card0-HDMI-A-1", "connected\n");
    assert_int_equal(look(&events), HAL_OK);
    plug(folder, "card0-HDMI-A-1", "disconnected\n");
    assert_int_equal(look(&events), HAL_OK);
    assert_int_equal(look(&events), HAL_ERR_GONE);
    assert_int_equal(events.lost, 0);
    assert_non_null(strstr(device.ops->describe(device.self), "pulled out"));
    assert_int_equal(device.ops->present(device.self, &scene), HAL_ERR_GONE);
    setenv("SDL_VIDEODRIVER", "kmsdrm", 1);
    display.config.off_screen = false;
    assert_int_equal(device.ops->open(device.self), HAL_ERR_GONE); /* SDL is not even asked. */
    assert_non_null(strstr(device.ops->describe(device.self), "none is plugged in"));
    unsetenv("SDL_VIDEODRIVER");
    display.config.off_screen = true;
    plug(folder, "card0-HDMI-A-1", "connected\n");
    assert_int_equal(device.ops->open(device.self), HAL_OK);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
    unmake(folder);
}

#define WITH_DISPLAY(test) cmocka_unit_test_setup_teardown(test, open_display, close_display)

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DISPLAY(test_it_says_what_draws_and_how_finely),
        WITH_DISPLAY(test_the_same_scene_is_the_same_picture),
        WITH_DISPLAY(test_one_fish_a_hole_and_a_wave_each_change_the_picture),
        WITH_DISPLAY(
            test_a_snout_above_the_surface_shows_as_in_air_and_below_it_through_water),
        WITH_DISPLAY(test_on_the_day_it_was_met_a_fish_of_the_album_looks_as_in_the_tank),
        WITH_DISPLAY(test_more_stress_is_brighter_for_every_eye_and_only_in_practice),
        WITH_DISPLAY(test_water_on_a_poi_lies_over_its_paper_and_hides_below_the_surface),
        WITH_DISPLAY(test_players_are_told_apart_without_colours),
        WITH_DISPLAY(test_a_gulp_opens_the_mouth_and_rings_the_water),
        WITH_DISPLAY(test_a_pump_that_runs_bubbles_and_its_stone_stays),
        WITH_DISPLAY(test_a_tank_can_be_shown_without_a_word),
        WITH_DISPLAY(test_the_fullest_scene_draws_without_an_error),
        WITH_DISPLAY(test_a_picture_needs_a_frame_and_room),
        WITH_DISPLAY(test_it_takes_quit_and_leaves_other_devices_their_events),
        WITH_DISPLAY(test_the_picture_follows_the_size_of_the_window),
        WITH_DISPLAY(test_a_turned_picture_is_the_same_picture_turned),
        WITH_DISPLAY(test_a_screen_is_upright_as_its_picture_is),
        WITH_DISPLAY(test_beside_the_picture_the_screen_is_black),
        WITH_DISPLAY(test_half_the_light_is_half_of_each_colour_and_none_is_black),
        WITH_DISPLAY(test_it_takes_every_pixel_of_a_dense_screen),
        WITH_DISPLAY(test_a_minimised_window_is_asked_again_and_no_fault),
        WITH_DISPLAY(test_a_driver_that_resets_is_gone_and_opened_again_as_it_was),
        cmocka_unit_test(test_only_sockets_with_a_screen_count),
        WITH_DISPLAY(test_a_screen_that_is_pulled_out_is_gone_until_it_is_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
