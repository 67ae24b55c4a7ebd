/* test_renderer.c -- what there is to see is seen, above the water and below it, and told apart. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/game/lab/lab.h"
#include "core/morph/morph.h"
#include "core/scene_helpers.h"
#include "platform/render/display_gl.h"
#include "tests/unit/support/display_stand.h"

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
        const int32_t off = (int32_t)middle(pixels[0], colour) - (int32_t)middle(pixels[1], colour);
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
    scene.fish[0] = (struct scene_fish){ .position_m = v3(0.0f, 0.12f, 0.0f),
                                         .length_m = 0.08f,
                                         .place = SCENE_ON_POI,
                                         .age_days = age_days,
                                         .maturity = scene_maturity(age_days),
                                         .progress = life_progress(&species_wakin.card, age_days) };
    scene.view.target_m = v3(0.0f, 0.12f, 0.0f);
    scene.view.eye_m = v3(-0.10f, 0.13f, 0.0f);
    picture(pixels[0]);
    return reddest(pixels[0], HEIGHT / 2u - 3u, HEIGHT / 2u + 3u);
}

/* Alone on the album's page, noted by the game as it notes a catch, so long into its life. */
static float red_in_album(float age_days, float caught_days)
{
    core.world.tank.fish[0].look = 0;
    core.world.tank.fish[0].age_days = caught_days;
    core.world.tank.fish[0].gait = GAIT_BOWL;
    core.world.tank.fish[0].holder = 0;
    core.game.album = (struct album){ 0 };
    album_note(&core.game.album, &core.world, 0, 1);
    core.game.phase = PHASE_ALBUM;
    core_scene(&core, &scene);
    scene.phase_s = 5.0f;
    scene.album.fish[0].age_days = age_days;
    scene.album.fish[0].maturity = scene_maturity(age_days);
    scene.album.fish[0].progress = life_progress(&species_wakin.card, age_days);
    scene.album.fish[0].is_caught = 0;  /* Its seal is red, too. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DISPLAY(test_one_fish_a_hole_and_a_wave_each_change_the_picture),
        WITH_DISPLAY(test_a_snout_above_the_surface_shows_as_in_air_and_below_it_through_water),
        WITH_DISPLAY(test_on_the_day_it_was_met_a_fish_of_the_album_looks_as_in_the_tank),
        WITH_DISPLAY(test_more_stress_is_brighter_for_every_eye_and_only_in_practice),
        WITH_DISPLAY(test_water_on_a_poi_lies_over_its_paper_and_hides_below_the_surface),
        WITH_DISPLAY(test_players_are_told_apart_without_colours),
        WITH_DISPLAY(test_a_gulp_opens_the_mouth_and_rings_the_water),
        WITH_DISPLAY(test_a_pump_that_runs_bubbles_and_its_stone_stays),
        WITH_DISPLAY(test_a_tank_can_be_shown_without_a_word),
        WITH_DISPLAY(test_the_fullest_scene_draws_without_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
