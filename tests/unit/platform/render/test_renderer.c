/* test_renderer.c -- Tests that each element of a scene changes the picture, above and below the
 * water. Also tests that players can distinguish similar elements. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "core/game/lab/lab.h"
#include "core/morph/morph.h"
#include "core/scene_helpers.h"
#include "platform/render/display_gl.h"
#include "tests/unit/support/display_fixture.h"

static void test_a_fish_a_hole_and_a_wave_each_change_the_picture(void **state)
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

static uint64_t sum_of(const uint8_t rgb[PIXELS_SIZE])
{
    uint64_t sum = 0;
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        sum += rgb[i];
    }
    return sum;
}

static void test_the_tank_is_bright_and_warm_under_a_bulb_by_night_and_even_by_day(void **state)
{
    (void)state;
    const float corner_x = -0.5f * scene.tank_size_m.x, corner_z = -0.5f * scene.tank_size_m.z;
    const struct frame_block *const block = &display.renderer.frame.block;
    float bulb[3], corner[3];
    scene.fish_count = 0;
    picture(pixels[0]);
    frame_lamp_light(block, -block->sky_glow[2], block->sky_glow[3], bulb);
    frame_lamp_light(block, corner_x, corner_z, corner);
    assert_true(bulb[0] > 2.0f * corner[0] && bulb[0] > bulb[2]);
    display.renderer.frame.is_day = true;
    picture(pixels[1]);
    frame_lamp_light(block, -block->sky_glow[2], block->sky_glow[3], bulb);
    frame_lamp_light(block, corner_x, corner_z, corner);
    assert_memory_equal(bulb, corner, sizeof bulb);
    assert_true(sum_of(pixels[1]) > sum_of(pixels[0]) + sum_of(pixels[0]) / 10u);
}

/* Returns the largest difference of green between two pixels that are 4 mm apart, as a fraction of
 * the mean green, in the middle of an empty tank of this depth by day. */
static float sharpness_of_floor(float depth_m)
{
    uint32_t sum = 0, change = 0, count = 0;
    scene.phase = PHASE_WORDLESS;
    scene.fish_count = 0;
    scene.poi[0].present = scene.bowl[0].present = scene.pump.present = 0;
    scene.tank_size_m.y = depth_m;
    scene.view.target_m = v3(0.0f, -depth_m, 0.0f);
    scene.view.eye_m = v3(0.0f, 0.4f - depth_m, 0.02f);
    display.renderer.frame.is_day = true;
    picture(pixels[0]);
    for (uint32_t y = HEIGHT / 4u; y < HEIGHT * 3u / 4u; y++) {
        for (uint32_t x = WIDTH / 4u; x < WIDTH * 3u / 4u; x++) {
            const uint8_t *const green = pixels[0] + (y * WIDTH + x) * 3u + 1u;
            sum += green[0];
            const uint32_t step = (uint32_t)abs(green[9] - green[0]);
            change = step > change ? step : change;
            count++;
        }
    }
    return (float)change * (float)count / (float)sum;
}

static void test_caustics_are_softer_in_deeper_water(void **state)
{
    (void)state;
    const float shallow = sharpness_of_floor(0.02f), deep = sharpness_of_floor(0.12f);
    print_message("sharpness of caustics: %.2f at 2 cm, %.2f at 12 cm\n", (double)shallow,
                  (double)deep);
    assert_true(deep > 0.0f && shallow > 1.25f * deep);
}

/* Returns the sum of one colour channel over the row of pixels at the top of the picture. */
static uint32_t sum_of_top(const uint8_t rgb[PIXELS_SIZE], uint32_t colour)
{
    uint32_t sum = 0;
    for (uint32_t x = 0; x < WIDTH; x++) {
        sum += rgb[x * 3u + colour];
    }
    return sum;
}

static void test_a_street_with_lamps_by_night_and_bright_by_day_is_behind_the_tank(void **state)
{
    (void)state;
    scene.phase = PHASE_WORDLESS;
    picture(pixels[0]);
    assert_true(sum_of_top(pixels[0], 0) > sum_of_top(pixels[0], 2) + WIDTH * 10u);
    assert_true(sum_of_top(pixels[0], 0) > WIDTH * 50u);
    const struct display_settings day = { .light = 1.0f, .is_day = 1 };
    device.ops->set_transform(device.self, &day);
    picture(pixels[1]);
    assert_true(sum_of_top(pixels[1], 2) > 2u * sum_of_top(pixels[0], 2));
}

/* Returns the number of pixels in the middle quarter of `rgb` that are more red than blue. Writes
 * the pixel with the most red to `hottest`. */
static uint32_t warm_pixels(const uint8_t rgb[PIXELS_SIZE], uint8_t hottest[3])
{
    uint32_t warm = 0;
    memset(hottest, 0, 3);
    for (uint32_t y = HEIGHT / 4u; y < HEIGHT * 3u / 4u; y++) {
        for (uint32_t x = WIDTH / 4u; x < WIDTH * 3u / 4u; x++) {
            const uint8_t *const pixel = rgb + (y * WIDTH + x) * 3u;
            warm += pixel[0] > pixel[2];
            if (pixel[0] > hottest[0]) {
                memcpy(hottest, pixel, 3);
            }
        }
    }
    return warm;
}

/* Draws water without fish, poi and bowl. */
static void picture_of_water(bool is_day)
{
    scene.phase = PHASE_WORDLESS;
    scene.fish_count = 0;
    scene.poi[0].present = scene.bowl[0].present = 0;
    display.renderer.frame.is_day = is_day;
    picture(pixels[0]);
}

static void test_reflections_of_lanterns_are_small_bright_and_warm(void **state)
{
    (void)state;
    uint8_t hottest[3];
    picture_of_water(false);
    const uint32_t warm = warm_pixels(pixels[0], hottest);
    print_message("reflections: brightest red %u with blue %u, warm pixels %u of %u\n", hottest[0],
                  hottest[2], warm, PIXELS_SIZE / 12u);
    assert_in_range(warm, 1, PIXELS_SIZE / 120u);
    assert_true(hottest[0] > 200u && 20u * hottest[2] < 17u * hottest[0]);
}

static void test_lanterns_have_no_reflections_by_day(void **state)
{
    (void)state;
    uint8_t hottest[3];
    picture_of_water(true);
    assert_int_equal(warm_pixels(pixels[0], hottest), 0);
}

/* Returns the sum of one colour channel over the 5 x 5 pixels in the middle of the picture. */
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

/* Returns the redness of the still water in the middle of the tank, seen from `eye_m`: its red
 * divided by its blue. */
static float redness_from(vec3 eye_m)
{
    scene.phase = PHASE_WORDLESS;
    scene.fish_count = 0;
    scene.poi[0].present = scene.bowl[0].present = scene.pump.present = 0;
    memset(scene.slope, 0, sizeof scene.slope);
    scene.view.target_m = v3(0.0f, 0.0f, 0.0f);
    scene.view.eye_m = eye_m;
    picture(pixels[0]);
    return (float)middle(pixels[0], 0) / (float)middle(pixels[0], 2);
}

static void test_water_at_rest_has_a_warm_sheen_at_a_flat_angle(void **state)
{
    (void)state;
    const float above = redness_from(v3(0.1f, 0.6f, 0.02f));
    const float flat = redness_from(v3(0.1f, 0.50f, 0.42f));
    print_message("red / blue of the water: %.2f from above, %.2f at a flat angle\n", (double)above,
                  (double)flat);
    assert_true(flat > 1.06f * above);
}

/* Returns the number of pixels of a dark grey in the middle third of the picture. */
static uint32_t dark_grey_pixels(const uint8_t rgb[PIXELS_SIZE])
{
    uint32_t count = 0;
    for (uint32_t y = HEIGHT / 3u; y < HEIGHT * 2u / 3u; y++) {
        for (uint32_t x = WIDTH / 3u; x < WIDTH * 2u / 3u; x++) {
            const uint8_t *const at = rgb + (y * WIDTH + x) * 3u;
            count += at[0] < 140u && abs(at[0] - at[2]) < 25 && abs(at[0] - at[1]) < 25;
        }
    }
    return count;
}

static void test_the_water_of_a_bowl_is_clear_and_its_fish_cast_shadows(void **state)
{
    (void)state;
    const struct display_settings day = { .light = 1.0f, .is_day = 1 };
    struct scene_bowl *const bowl = &scene.bowl[0];
    device.ops->set_transform(device.self, &day);
    scene.phase = PHASE_WORDLESS;
    scene.poi[0].present = 0;
    bowl->present = 1;
    bowl->position_m = v3(0.0f, 0.012f, 0.0f);
    scene.view.target_m = bowl->position_m;
    scene.view.eye_m = v3(0.0f, 0.40f, 0.10f);
    scene.fish_count = 0;
    picture(pixels[0]);
    const int32_t red = (int32_t)middle(pixels[0], 0), blue = (int32_t)middle(pixels[0], 2);
    assert_true(red > 25 * 120 && abs(red - blue) < red / 10);
    scene.fish_count = 1;
    scene.fish[0].place = SCENE_IN_BOWL;
    scene.fish[0].length_m = 0.06f;
    scene.fish[0].position_m = v3(0.0f, -0.01f, 0.0f);
    scene.fish[0].angles = (struct angles){ 0 };
    picture(pixels[1]);
    assert_true(dark_grey_pixels(pixels[1]) > dark_grey_pixels(pixels[0]) + 30u);
}

/* Returns the number of pixels in the colour of the first player's band. */
static uint32_t pink_pixels(const uint8_t rgb[PIXELS_SIZE])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PIXELS_SIZE; i += 3) {
        count += rgb[i] > rgb[i + 1] + 50u && rgb[i + 2] > rgb[i + 1] + 10u;
    }
    return count;
}

static void test_a_white_bowl_has_a_line_in_a_colour_only_among_several_players(void **state)
{
    (void)state;
    scene.phase = PHASE_WORDLESS;
    scene.fish_count = 0;
    scene.poi[0].present = 0;
    scene.bowl[0].present = 1;
    scene.bowl[0].position_m = v3(0.0f, 0.012f, 0.0f);
    scene.view.target_m = scene.bowl[0].position_m;
    scene.view.eye_m = v3(0.0f, 0.30f, 0.20f);
    for (uint32_t day = 0; day < 2; day++) {
        struct display_settings settings = { .light = 1.0f, .is_day = day };
        scene.bowl[1] = (struct scene_bowl){ 0 };
        device.ops->set_transform(device.self, &settings);
        picture(pixels[0]);
        const uint32_t colour = pink_pixels(pixels[0]);
        const int32_t grey = (int32_t)middle(pixels[0], 0);
        settings.has_white_bowls = 1;
        device.ops->set_transform(device.self, &settings);
        picture(pixels[1]);
        const int32_t bright = (int32_t)middle(pixels[1], 0);
        assert_int_equal(pink_pixels(pixels[1]), 0);
        assert_true(bright > grey && abs(bright - (int32_t)middle(pixels[1], 2)) < bright / 8);
        scene.bowl[1] = scene.bowl[0];
        scene.bowl[1].position_m.x = 0.4f; /* Outside the picture. */
        picture(pixels[1]);
        const uint32_t line = pink_pixels(pixels[1]);
        assert_true(line > 10u && line < colour / 2u);
    }
}

/* Sets up a scene with one fish of 8 cm that is pitched up by 45 degrees and has its nose at
 * `nose_y_m`. The camera looks down at a point of the head 3 mm behind the nose. */
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
    fish->maturity = 0.0f; /* An immature fish is grey, so that no colour channel reaches its
                              maximum. */
    fish->position_m = v3(0.0f, nose_y_m - 0.0283f, 0.0f);
    scene.view.target_m = v3(0.0f, nose_y_m - 0.0021f, -0.0262f);
    scene.view.eye_m = v3(0.0f, nose_y_m + 0.15f, 0.02f);
}

static void test_a_snout_is_drawn_as_in_air_above_the_surface_and_as_in_water_below(void **state)
{
    (void)state;
    show_gulper(0.006f, SCENE_IN_TANK);
    picture(pixels[0]);
    show_gulper(0.006f, SCENE_ON_POI);
    picture(pixels[1]);
    for (uint32_t colour = 0; colour < 3; colour++) {
        const int32_t off = (int32_t)middle(pixels[0], colour) - (int32_t)middle(pixels[1], colour);
        /* The two sums over 25 pixels may differ by 100, which is 4 of 255 for each pixel. */
        assert_in_range(off + 100, 0, 200);
    }
    show_gulper(-0.03f, SCENE_IN_TANK);
    picture(pixels[1]);
    print_message("red of a snout: %u in air, %u under 3 cm of water, of 6375\n",
                  middle(pixels[0], 0), middle(pixels[1], 0));
    assert_true(middle(pixels[0], 0) > middle(pixels[1], 0) + 25u * 12u);
}

/* Returns the redness of the reddest pixel of the middle column in the rows from `top` to `bottom`.
 * The redness is 0 if red equals green, and 1 if there is no green. */
static float reddest(const uint8_t rgb[PIXELS_SIZE], uint32_t top, uint32_t bottom)
{
    float most = 0.0f;
    for (uint32_t y = top; y < bottom; y++) {
        const uint8_t *pixel = rgb + (y * WIDTH + WIDTH / 2u) * 3u;
        most = f_max(most, 1.0f - (float)pixel[1] / f_max((float)pixel[0], 1.0f));
    }
    return most;
}

/* Returns the redness of a fish that is `age_days` old and lies on a poi, out of the water. The
 * camera sees its left side, and the fish fills the middle of the picture. */
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

/* Returns the redness that the album page shows at `age_days` for a fish that was caught at
 * `caught_days`. */
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
    /* Removes the red seal with which the album marks the day of the catch, and the red bow of a
     * present, because only the fish may be red. */
    scene.album.fish[0].is_caught = scene.album.fish[0].is_present = 0;
    /* 20 frames are enough to refine the texture of the fish completely. */
    for (uint32_t i = 0; i < 20; i++) {
        picture(pixels[0]);
    }
    return reddest(pixels[0], HEIGHT / 5u, HEIGHT * 3u / 5u);
}

/* A goldfish turns red between about 60 and 120 days. If it was caught at such an age, the album
 * must show about the same redness as the tank. */
static void test_an_album_fish_on_its_catch_day_is_drawn_as_in_the_tank(void **state)
{
    (void)state;
    for (float days = 56.0f; days < 130.0f; days += 8.0f) {
        const float tank = red_in_hand(days), album = red_in_album(days, days);
        print_message("%3.0f days: %.2f in air, %.2f in the album\n", (double)days, (double)tank,
                      (double)album);
        assert_true(f_abs(tank - album) < 0.20f);
    }
    /* The fish was caught at 100 days. For the age of 60 days, the album must show it dark. */
    assert_true(red_in_album(60.0f, 100.0f) < 0.35f);
}

/* Sets up a scene with a level poi 5 cm above the water. The camera is above its middle. */
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
    /* Returns the brightness. The weights 3, 6 and 1 of red, green and blue approximate the
     * sensitivity of the human eye. */
    return 3u * middle(rgb, 0) + 6u * middle(rgb, 1) + middle(rgb, 2);
}

/* Draws the middle of a tank at night from above, with one grown fish at half the depth or without
 * fish. */
static void show_night_water(uint32_t fish_count)
{
    scene.phase = PHASE_WORDLESS;
    scene.poi[0].present = scene.bowl[0].present = scene.pump.present = 0;
    scene.fish_count = fish_count;
    scene.fish[0] = (struct scene_fish){ .position_m = v3(0.0f, -0.5f * scene.tank_size_m.y, 0.0f),
                                         .length_m = 0.08f,
                                         .place = SCENE_IN_TANK,
                                         .age_days = 400.0f,
                                         .maturity = 1.0f,
                                         .progress = life_progress(&species_wakin.card, 400.0f) };
    scene.view.target_m = v3(0.0f, 0.0f, 0.0f);
    scene.view.eye_m = v3(0.0f, 0.5f, 0.02f);
    picture(pixels[0]);
}

static void test_a_red_fish_is_brighter_than_the_dim_water_by_night(void **state)
{
    (void)state;
    show_night_water(0);
    const uint32_t water[3] = { middle(pixels[0], 0), middle(pixels[0], 1), middle(pixels[0], 2) };
    show_night_water(1);
    const uint32_t fish[3] = { middle(pixels[0], 0), middle(pixels[0], 1), middle(pixels[0], 2) };
    print_message("water: %u %u %u, fish: %u %u %u, of 6375\n", water[0], water[1], water[2],
                  fish[0], fish[1], fish[2]);
    /* The water is greenish blue, and less than half as bright as white. */
    assert_true(water[0] < water[1] && water[1] < 25u * 128u && water[2] < 25u * 128u);
    assert_true(fish[0] > water[2] + 25u * 64u && fish[0] > 2u * fish[2]);
}

static void test_stress_is_drawn_darker_only_in_practice(void **state)
{
    (void)state;
    show_poi();
    picture(pixels[0]);
    memset(scene.poi[0].stress, 128, sizeof scene.poi[0].stress);
    picture(pixels[1]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
    uint32_t before = UINT32_MAX;
    scene.poi[0].shows_stress = 1;
    for (uint32_t stress = 0; stress <= 250u; stress += 25u) {
        memset(scene.poi[0].stress, (int)stress, sizeof scene.poi[0].stress);
        picture(pixels[0]);
        assert_true(brightness(pixels[0]) < before);
        before = brightness(pixels[0]);
    }
}

static void test_water_on_a_poi_is_drawn_over_the_paper_only_above_the_surface(void **state)
{
    (void)state;
    show_poi();
    scene.poi[0].sag_m = 0.003f;
    picture(pixels[0]);
    scene.poi[0].water_m = 0.002f;
    picture(pixels[1]);
    /* Picture 1 has more water on the paper. Water absorbs red light (channel 0), so the picture is
     * less red. */
    assert_true(middle(pixels[0], 0) > middle(pixels[1], 0));
    scene.poi[0].position_m.y = -0.04f;
    picture(pixels[1]);
    scene.poi[0].water_m = 0.0f;
    picture(pixels[0]);
    assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

/* Draws a tilted poi without paper at the height `y_m`, first dry and then wet. Writes the
 * differences of the two pictures to `out`, so that `out` shows only the drops. */
static void draw_drops(float y_m, uint8_t out[PIXELS_SIZE])
{
    static uint8_t dry[PIXELS_SIZE];
    show_poi();
    scene.tick = 300u * CORE_TICK_HZ;
    scene.poi[0].position_m.y = y_m;
    scene.poi[0].angles.pitch_rad = 0.3f;
    scene.view.target_m = v3(0.0f, 0.5f * y_m, 0.0f);
    scene.view.eye_m = v3(0.0f, 0.05f, 0.2f);
    memset(scene.poi[0].integrity, 0, sizeof scene.poi[0].integrity);
    picture(dry);
    scene.poi[0].water_m = 0.0015f;
    picture(out);
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        out[i] = (uint8_t)abs((int)out[i] - (int)dry[i]);
    }
}

/* If the phase of the drops depended on the height of the poi, the drops would jump while the poi
 * rises. */
static void test_drops_keep_their_phase_while_a_poi_rises(void **state)
{
    (void)state;
    uint32_t drops = 0, jumps = 0;
    draw_drops(0.0400f, pixels[0]);
    draw_drops(0.0402f, pixels[1]); /* A movement of less than a pixel. */
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        drops += pixels[0][i];
        jumps += (uint32_t)abs((int)pixels[1][i] - (int)pixels[0][i]);
    }
    print_message("drops: %u, change after a rise of 0.2 mm: %u\n", drops, jumps);
    assert_true(drops > 5000u);
    assert_true(jumps < drops / 4u);
}

/* Returns the number of pixels in the white colour of the plastic ring. */
static uint32_t white_pixels(const uint8_t rgb[PIXELS_SIZE])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PIXELS_SIZE; i += 3u) {
        count += rgb[i] > 190 && rgb[i + 1] > 180 && rgb[i + 2] > 170;
    }
    return count;
}

static void test_players_are_distinguishable_without_colours(void **state)
{
    (void)state;
    uint32_t before = 0;
    for (uint8_t owner = 0; owner < POI_MAX; owner++) {
        show_poi();
        scene.poi[0].owner = owner;
        /* Removes the paper, so that only the ring is drawn. The ring has a different number of
         * white marks for each player. */
        memset(scene.poi[0].integrity, 0, sizeof scene.poi[0].integrity);
        picture(pixels[0]);
        const uint32_t white = white_pixels(pixels[0]);
        print_message("player %d: %u white pixels\n", owner + 1, white);
        assert_true(owner == 0 || white > before + before / 8u);
        before = white;
    }
}

static void test_a_gulp_opens_the_mouth_and_makes_a_ripple(void **state)
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

static void test_a_running_pump_shows_bubbles_and_its_stone_is_always_visible(void **state)
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

static void test_the_hose_of_the_air_stone_lies_over_the_rim(void **state)
{
    (void)state;
    const float left_m = -0.5f * scene.tank_size_m.x - 0.20f;
    scene.phase = PHASE_WORDLESS;
    /* The picture shows only the counter at the left of the tank, and no water. */
    scene.view.target_m = v3(left_m, 0.0f, scene.pump.stone_m.z);
    scene.view.eye_m = v3(left_m, 0.4f, scene.pump.stone_m.z + 0.05f);
    scene.pump.present = 0;
    picture(pixels[0]);
    scene.pump.present = 1;
    picture(pixels[1]);
    assert_memory_not_equal(pixels[0], pixels[1], PIXELS_SIZE);
}

static void test_a_tank_can_be_drawn_without_text(void **state)
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

static void test_the_pictures_below_the_water_have_only_the_part_with_the_water(void **state)
{
    (void)state;
    picture(pixels[0]);
    const struct renderer *const renderer = &display.renderer;
    const struct frame_part *const part = &renderer->part;
    assert_in_range(part->width, 1, renderer->below_px[0] - 1u);
    assert_in_range(part->height, 1, renderer->below_px[1] - 1u);
    assert_int_equal(renderer->life.width, part->width);
    assert_int_equal(renderer->life.height, part->height);
    /* A camera inside the tank sees the water surface on the whole screen. */
    scene.view.eye_m = v3(0.0f, 0.02f, 0.05f);
    scene.view.target_m = v3(0.0f, 0.0f, 0.0f);
    picture(pixels[0]);
    assert_int_equal(part->width, renderer->below_px[0]);
    assert_int_equal(part->height, renderer->below_px[1]);
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
        WITH_DISPLAY(test_a_fish_a_hole_and_a_wave_each_change_the_picture),
        WITH_DISPLAY(test_the_tank_is_bright_and_warm_under_a_bulb_by_night_and_even_by_day),
        WITH_DISPLAY(test_caustics_are_softer_in_deeper_water),
        WITH_DISPLAY(test_a_red_fish_is_brighter_than_the_dim_water_by_night),
        WITH_DISPLAY(test_a_street_with_lamps_by_night_and_bright_by_day_is_behind_the_tank),
        WITH_DISPLAY(test_reflections_of_lanterns_are_small_bright_and_warm),
        WITH_DISPLAY(test_lanterns_have_no_reflections_by_day),
        WITH_DISPLAY(test_water_at_rest_has_a_warm_sheen_at_a_flat_angle),
        WITH_DISPLAY(test_the_water_of_a_bowl_is_clear_and_its_fish_cast_shadows),
        WITH_DISPLAY(test_a_white_bowl_has_a_line_in_a_colour_only_among_several_players),
        WITH_DISPLAY(test_a_snout_is_drawn_as_in_air_above_the_surface_and_as_in_water_below),
        WITH_DISPLAY(test_an_album_fish_on_its_catch_day_is_drawn_as_in_the_tank),
        WITH_DISPLAY(test_stress_is_drawn_darker_only_in_practice),
        WITH_DISPLAY(test_water_on_a_poi_is_drawn_over_the_paper_only_above_the_surface),
        WITH_DISPLAY(test_drops_keep_their_phase_while_a_poi_rises),
        WITH_DISPLAY(test_players_are_distinguishable_without_colours),
        WITH_DISPLAY(test_a_gulp_opens_the_mouth_and_makes_a_ripple),
        WITH_DISPLAY(test_a_running_pump_shows_bubbles_and_its_stone_is_always_visible),
        WITH_DISPLAY(test_the_hose_of_the_air_stone_lies_over_the_rim),
        WITH_DISPLAY(test_a_tank_can_be_drawn_without_text),
        WITH_DISPLAY(test_the_pictures_below_the_water_have_only_the_part_with_the_water),
        WITH_DISPLAY(test_the_fullest_scene_draws_without_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
