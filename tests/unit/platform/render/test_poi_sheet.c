/* test_poi_sheet.c -- Tests the picture of a poi's paper: worn paper is darker and thinner, the
 * front of wet paper is soft, and the paper around a hole hangs down. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/display_gl.h"
#include "platform/render/pass/poi_pass.h"
#include "tests/unit/support/display_fixture.h"

/* Sets up a scene with a level poi in the middle of the picture, over empty water. The camera is at
 * `eye_m`, relative to the poi. */
static struct scene_poi *show_poi(vec3 eye_m)
{
    core_scene(&core, &scene);
    scene.fish_count = 0;
    scene.phase = PHASE_WORDLESS;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.bowl[i].present = 0;
    }
    struct scene_poi *const poi = &scene.poi[0];
    *poi = (struct scene_poi){ .present = 1,
                               .position_m = v3(0.0f, 0.08f, 0.0f),
                               .ring_radius_m = 0.04f };
    memset(poi->integrity, 255, sizeof poi->integrity);
    scene.view.target_m = poi->position_m;
    scene.view.eye_m = v3_add(poi->position_m, eye_m);
    return poi;
}

/* Returns the mean of the colour values in the middle of a picture. */
static float mean_of(const uint8_t rgb[PIXELS_SIZE])
{
    uint32_t sum = 0, count = 0;
    for (uint32_t y = HEIGHT / 2u - 10u; y < HEIGHT / 2u + 10u; y++) {
        for (uint32_t x = 3u * (WIDTH / 2u - 10u); x < 3u * (WIDTH / 2u + 10u); x++) {
            sum += rgb[3u * WIDTH * y + x];
            count++;
        }
    }
    return (float)sum / (float)count;
}

static const vec3 above_m = { 0.0f, 0.20f, 0.05f };

static void test_worn_paper_is_darker_before_it_tears(void **state)
{
    (void)state;
    float last = 256.0f;
    for (uint32_t worn = 0; worn <= 3u; worn++) {
        struct scene_poi *const poi = show_poi(above_m);
        memset(poi->wetness, 255, sizeof poi->wetness);
        memset(poi->integrity, (int)(255u - 80u * worn), sizeof poi->integrity);
        picture(pixels[0]);
        assert_true(mean_of(pixels[0]) < last - 2.0f);
        last = mean_of(pixels[0]);
    }
}

static void test_the_front_of_wet_paper_is_soft(void **state)
{
    (void)state;
    struct scene_poi *const poi = show_poi(above_m);
    uint32_t between = 0;
    picture(pixels[0]);
    const float dry = mean_of(pixels[0]);
    memset(poi->wetness, 255, sizeof poi->wetness);
    picture(pixels[0]);
    const float wet = mean_of(pixels[0]);
    assert_true(f_abs(dry - wet) > 10.0f);
    for (uint32_t i = 0; i < SHEET_SIDE * SHEET_SIDE; i++) {
        poi->wetness[i] = i % SHEET_SIDE < SHEET_SIDE / 2u ? 255 : 0;
    }
    picture(pixels[0]);
    /* Counts the pixels of a row whose blue is clearly between that of dry and of wet paper. */
    for (uint32_t x = WIDTH / 2u - 30u; x < WIDTH / 2u + 30u; x++) {
        uint32_t sum = 0;
        for (uint32_t y = HEIGHT / 2u - 8u; y < HEIGHT / 2u + 8u; y++) {
            const uint8_t *const pixel = pixels[0] + 3u * (WIDTH * y + x);
            sum += (uint32_t)pixel[0] + pixel[1] + pixel[2];
        }
        const float share = ((float)sum / 48.0f - wet) / (dry - wet);
        between += share > 0.2f && share < 0.8f;
    }
    assert_in_range(between, 2, 12);
}

/* Returns the number of pixels below the ring that a hole in the paper changes. The hole is `ticks`
 * old. */
static uint32_t changed_below(float side, uint32_t ticks)
{
    struct scene_poi *const poi = show_poi(v3(0.0f, 0.004f, side * 0.25f));
    picture(pixels[0]);
    for (uint32_t z = 10; z < 22; z++) {
        memset(poi->integrity + z * SHEET_SIDE + 10, 0, 12);
    }
    scene.tick += ticks;
    picture(pixels[1]);
    uint32_t count = 0;
    for (uint32_t y = HEIGHT / 2u + 4u; y < HEIGHT / 2u + 40u; y++) {
        for (uint32_t x = WIDTH / 2u - 20u; x < WIDTH / 2u + 20u; x++) {
            const uint32_t at = 3u * (y * WIDTH + x);
            count += memcmp(pixels[0] + at, pixels[1] + at, 3) != 0;
        }
    }
    return count;
}

static void test_the_paper_around_a_hole_hangs_below_the_ring(void **state)
{
    (void)state;
    const uint32_t slit = changed_below(-1.0f, 1), open = changed_below(-1.0f, POI_OPEN_TICKS);
    print_message("changed pixels below the ring: %u of a slit, %u of an open hole\n", slit, open);
    assert_true(open > 20u && slit < open);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DISPLAY(test_worn_paper_is_darker_before_it_tears),
        WITH_DISPLAY(test_the_front_of_wet_paper_is_soft),
        WITH_DISPLAY(test_the_paper_around_a_hole_hangs_below_the_ring),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
