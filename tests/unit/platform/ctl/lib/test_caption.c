/* test_caption.c -- Tests text, scale bars and coloured bars that kingyoctl draws on a picture. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <string.h>

#include "core/morph/species.h"
#include "platform/ctl/lib/caption.h"
#include "platform/key_colour.h"

#define WIDTH 200u
#define HEIGHT 80u
#define WHITE 0xffffffu

static struct canvas white_canvas(void)
{
    struct canvas canvas;
    assert_true(canvas_open(&canvas, WIDTH, HEIGHT));
    canvas_fill(&canvas, (struct canvas_box){ 0.0f, 0.0f, WIDTH, HEIGHT }, WHITE, WHITE);
    return canvas;
}

/* Returns the sum of the darkness in the columns from `left` to `right`. A black pixel counts as
 * 1. */
static float ink(const struct canvas *canvas, uint32_t left, uint32_t right)
{
    float sum = 0.0f;
    for (uint32_t y = 0; y < canvas->height; y++) {
        for (uint32_t x = left; x < right; x++) {
            sum += 1.0f - canvas->pixels[y * canvas->width + x].y;
        }
    }
    return sum;
}

static void test_edges_between_pixels_have_partial_coverage(void **state)
{
    (void)state;
    struct canvas canvas = white_canvas();
    canvas_fill(&canvas, (struct canvas_box){ 10.25f, 20.5f, 7.5f, 3.25f }, 0, 0);
    assert_true(f_abs(ink(&canvas, 0, WIDTH) - 7.5f * 3.25f) < 1e-3f);
    assert_true(f_abs(canvas.pixels[22 * WIDTH + 10].y - 0.25f) < 1e-5f);
    canvas_close(&canvas);
}

static void test_drawing_outside_the_canvas_is_clipped(void **state)
{
    (void)state;
    struct canvas canvas = white_canvas();
    canvas_fill(&canvas, (struct canvas_box){ -50.0f, -50.0f, 60.0f, 60.0f }, 0, 0);
    canvas_fill(&canvas, (struct canvas_box){ 500.0f, 500.0f, 60.0f, 60.0f }, 0, 0);
    assert_true(f_abs(ink(&canvas, 0, WIDTH) - 100.0f) < 1e-3f);
    canvas_words(&canvas, -20.0f, 300.0f, 40.0f, ALIGN_LEFT, 0, "far below");
    canvas_close(&canvas);
}

static void test_srgb_colours_are_converted_to_linear_light(void **state)
{
    (void)state;
    const vec3 dark = canvas_linear(v3(0.0f, 0.04f, 0.25f));
    const vec3 light = canvas_linear(v3(0.5f, 0.75f, 1.0f));
    assert_true(dark.x == 0.0f && f_abs(dark.y - 0.0030960f) < 1e-6f);
    assert_true(f_abs(dark.z - 0.0508761f) < 1e-5f && f_abs(light.x - 0.2140411f) < 1e-5f);
    assert_true(f_abs(light.y - 0.5225216f) < 1e-5f && f_abs(light.z - 1.0f) < 1e-5f);
}

static void test_text_is_drawn_at_its_alignment(void **state)
{
    (void)state;
    const enum canvas_align aligns[3] = { ALIGN_RIGHT, ALIGN_CENTRE, ALIGN_LEFT };
    for (uint32_t i = 0; i < 3; i++) {
        struct canvas canvas = white_canvas();
        canvas_words(&canvas, 100.0f, 50.0f, 24.0f, aligns[i], 0, "HHHH");
        const float left = ink(&canvas, 0, 100), right = ink(&canvas, 100, WIDTH);
        assert_true(left + right > 200.0f);
        assert_true(i == 0 ? right == 0.0f : i == 2 ? left == 0.0f : f_abs(left - right) < 20.0f);
        canvas_close(&canvas);
    }
}

static void test_larger_text_has_proportionally_more_ink(void **state)
{
    (void)state;
    struct canvas small = white_canvas(), large = white_canvas();
    canvas_words(&small, 100.0f, 60.0f, 16.0f, ALIGN_CENTRE, 0, "mm");
    canvas_words(&large, 100.0f, 60.0f, 48.0f, ALIGN_CENTRE, 0, "mm");
    const float ratio = ink(&large, 0, WIDTH) / ink(&small, 0, WIDTH);
    assert_true(ratio > 8.0f && ratio < 10.0f); /* Text of three times the size covers nine times
                                                   the area. */
    canvas_close(&small);
    canvas_close(&large);
}

static void has_age(float days, const char *expected)
{
    char words[CAPTION_WORDS_SIZE];
    caption_age(words, days);
    assert_string_equal(words, expected);
}

static void has_length(float length_m, const char *expected)
{
    char words[CAPTION_WORDS_SIZE];
    caption_length(words, length_m);
    assert_string_equal(words, expected);
}

static void test_ages_and_lengths_have_suitable_units(void **state)
{
    (void)state;
    has_age(0.0f, "hatching");
    has_age(12.34f, "12.3 days");
    has_age(400.0f, "400 days");
    has_age(1461.0f, "4.0 years");
    has_length(0.0005f, "0.50 mm");
    has_length(0.0204f, "20.4 mm");
    has_length(0.45f, "45.0 cm");
    has_length(2.083f, "2.08 m");
}

static void test_names_are_capitalized_and_spaced(void **state)
{
    (void)state;
    char words[CAPTION_WORDS_SIZE];
    caption_name(words, "long_leaf_2");
    assert_string_equal(words, "long leaf 2");
    caption_name(words, "0123456789012345678901234567890123456789012345678901234567890123456789");
    assert_int_equal(strlen(words), CAPTION_WORDS_SIZE - 1);
}

static void test_scale_bars_are_one_two_or_five_units(void **state)
{
    (void)state;
    static const float expected[][2] = { { 0.0019f, 0.001f }, { 0.002f, 0.002f },
                                         { 0.0049f, 0.002f }, { 0.005f, 0.005f },
                                         { 0.99f, 0.5f },     { 1.0f, 1.0f },
                                         { 1e-5f, 1e-5f },    { 37.0f, 20.0f } };
    for (uint32_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        const float got = caption_round_length_m(expected[i][0]);
        assert_true(f_abs(got / expected[i][1] - 1.0f) < 1e-4f);
    }
}

static void test_a_scale_bar_has_its_stated_length(void **state)
{
    (void)state;
    struct canvas canvas = white_canvas();
    /* At 3 pixels per millimetre and at most 100 pixels, the bar is 20 mm (60 pixels) long. The
     * middle of the bar is at x = 100, so the bar extends from 70 to 130. */
    caption_bar(&canvas, 100.0f, 30.0f, 100.0f, 3000.0f, 10.0f);
    assert_true(canvas.pixels[30 * WIDTH + 71].y < 0.5f);
    assert_true(canvas.pixels[30 * WIDTH + 128].y < 0.5f);
    assert_true(ink(&canvas, 0, 70) == 0.0f && ink(&canvas, 130, WIDTH) == 0.0f);
    canvas_close(&canvas);
}

static void test_weights_fill_their_bar_proportionally(void **state)
{
    (void)state;
    struct canvas canvas = white_canvas();
    const float weights[MORPH_KEY_MAX] = { 0.25f, 0.0f, 0.75f };
    caption_weights(&canvas, (struct canvas_box){ 0.0f, 0.0f, 200.0f, 10.0f }, 3, weights);
    const vec3 red = canvas_colour(key_colour(3, 0)), blue = canvas_colour(key_colour(3, 2));
    assert_true(f_abs(canvas.pixels[49].x - red.x) < 1e-5f);
    assert_true(f_abs(canvas.pixels[50].z - blue.z) < 1e-5f);
    assert_true(f_abs(canvas.pixels[199].z - blue.z) < 1e-5f);
    canvas_close(&canvas);
}

static void test_three_keys_are_red_green_and_blue(void **state)
{
    (void)state;
    for (uint32_t key = 0; key < 3; key++) {
        const vec3 c = canvas_colour(key_colour(3, key));
        const float channel[3] = { c.x, c.y, c.z };
        assert_true(channel[key] > channel[(key + 1) % 3] && channel[key] > channel[(key + 2) % 3]);
    }
}

/* In pictures, each key shape of a fish has its own colour. The first key has the same colour for
 * any number of keys, and the last key for any number up to 6. */
static void test_the_first_key_is_red_and_each_key_has_its_own_colour(void **state)
{
    (void)state;
    for (uint32_t count = 2; count <= MORPH_KEY_MAX; count++) {
        assert_int_equal(key_colour(count, 0), key_colour(3, 0));
        for (uint32_t i = 0; i < count; i++) {
            for (uint32_t j = 0; j < i; j++) {
                assert_int_not_equal(key_colour(count, i), key_colour(count, j));
            }
        }
        if (count <= 6) {
            assert_int_equal(key_colour(count, count - 1u), key_colour(3, 2));
        }
    }
    /* The middle one of five key shapes has the same colour as the middle one of three. */
    assert_int_equal(key_colour(5, 2), key_colour(3, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_three_keys_are_red_green_and_blue),
        cmocka_unit_test(test_the_first_key_is_red_and_each_key_has_its_own_colour),
        cmocka_unit_test(test_edges_between_pixels_have_partial_coverage),
        cmocka_unit_test(test_drawing_outside_the_canvas_is_clipped),
        cmocka_unit_test(test_srgb_colours_are_converted_to_linear_light),
        cmocka_unit_test(test_text_is_drawn_at_its_alignment),
        cmocka_unit_test(test_larger_text_has_proportionally_more_ink),
        cmocka_unit_test(test_ages_and_lengths_have_suitable_units),
        cmocka_unit_test(test_names_are_capitalized_and_spaced),
        cmocka_unit_test(test_scale_bars_are_one_two_or_five_units),
        cmocka_unit_test(test_a_scale_bar_has_its_stated_length),
        cmocka_unit_test(test_weights_fill_their_bar_proportionally),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
