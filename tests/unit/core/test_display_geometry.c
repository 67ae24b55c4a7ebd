/* test_display_geometry.c -- checks where the picture is on the screen, and which point of the
 * picture a pointer touches. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/display_geometry.h"
#include "drivers/pointer/pointer_poi.h"

#define WIDTH 1920.0f
#define HEIGHT 1080.0f

static struct display_transform turned(uint32_t rotation)
{
    return display_transform_of(&(struct display_settings){ .rotation = rotation, .light = 1.0f },
                                WIDTH, HEIGHT);
}

static void assert_near(float is, float expected)
{
    assert_float_equal(is, expected, 1e-3f);
}

static void test_an_untransformed_picture_fills_the_screen(void **state)
{
    (void)state;
    const struct display_transform transform = turned(0);
    assert_near(transform.width, WIDTH);
    assert_near(transform.height, HEIGHT);
    assert_near(transform.light, 1.0f);
    float turn[4], move[2];
    display_clip_matrix(&transform, turn, move);
    assert_near(turn[0], 1.0f);
    assert_near(turn[1], 0.0f);
    assert_near(turn[2], 0.0f);
    assert_near(turn[3], 1.0f);
    assert_near(move[0], 0.0f);
    assert_near(move[1], 0.0f);
}

static void test_a_quarter_turn_clockwise_moves_the_top_left_to_the_top_right(void **state)
{
    (void)state;
    static const float corner[4][2] = {
        { 0.0f, 0.0f }, { WIDTH, 0.0f }, { WIDTH, HEIGHT }, { 0.0f, HEIGHT }
    };
    for (uint32_t rotation = 0; rotation < 4; rotation++) {
        const struct display_transform transform = turned(rotation);
        assert_near(transform.x, corner[rotation][0]);
        assert_near(transform.y, corner[rotation][1]);
        assert_near(transform.width, rotation & 1u ? HEIGHT : WIDTH);
        assert_near(transform.height, rotation & 1u ? WIDTH : HEIGHT);
        const struct display_rect part = display_picture_rect(&transform);
        assert_near(part.left, 0.0f);
        assert_near(part.top, 0.0f);
        assert_near(part.right, WIDTH);
        assert_near(part.bottom, HEIGHT);
    }
}

static void test_the_inverse_transform_matches_the_opengl_transform(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4u * 8u; i++) {
        const struct display_settings display_settings = { .rotation = i % 4u,
                                                           .inset_x = 0.01f * (float)(i % 7u),
                                                           .inset_y = 0.01f * (float)(i % 5u),
                                                           .shift_x = 0.001f * (float)(i % 3u),
                                                           .shift_y = -0.002f * (float)(i % 4u),
                                                           .light = 1.0f };
        const struct display_transform p = display_transform_of(&display_settings, WIDTH, HEIGHT);
        float turn[4], move[2];
        display_clip_matrix(&p, turn, move);
        for (uint32_t at = 0; at < 9u; at++) {
            const float x = (float)(at % 3u) - 1.0f, y = (float)(at / 3u) - 1.0f;
            float screen_x = 0.5f * WIDTH * (1.0f + turn[0] * x + turn[2] * y + move[0]);
            float screen_y = 0.5f * HEIGHT * (1.0f - turn[1] * x - turn[3] * y - move[1]);
            display_to_picture(&p, &screen_x, &screen_y);
            assert_near(screen_x, 0.5f * p.width * (1.0f + x));
            assert_near(screen_y, 0.5f * p.height * (1.0f - y));
        }
    }
}

static void test_overscan_margins_are_whole_pixels(void **state)
{
    (void)state;
    const struct display_settings display_settings = {
        .rotation = 1, .inset_x = 0.0501f, .inset_y = 0.1f, .shift_x = 0.0049f, .light = 1.0f
    };
    const struct display_transform transform =
        display_transform_of(&display_settings, WIDTH, HEIGHT);
    const struct display_rect part = display_picture_rect(&transform);
    assert_near(part.left, 96.0f + 5.0f);
    assert_near(part.right, WIDTH - 96.0f + 5.0f);
    assert_near(part.top, 108.0f);
    assert_near(part.bottom, HEIGHT - 108.0f);
    assert_near(transform.width, HEIGHT - 216.0f);
    assert_near(transform.height, WIDTH - 192.0f);
}

static void test_out_of_range_settings_leave_a_visible_picture(void **state)
{
    (void)state;
    const struct display_settings display_settings = {
        .rotation = 7, .inset_x = 3.0f, .inset_y = -1.0f, .light = 9.0f
    };
    const struct display_transform transform = display_transform_of(&display_settings, 4.0f, 2.0f);
    assert_near(transform.width, 2.0f);
    assert_near(transform.height, 2.0f);
    assert_near(transform.light, 1.0f);
}

static void test_a_pointer_on_a_rotated_screen_maps_to_the_touched_point(void **state)
{
    (void)state;
    const struct display_settings upright = { .rotation = 1, .inset_x = 0.1f, .light = 1.0f };
    const struct pointer_report at = {
        .x_px = 192.0f, .y_px = 270.0f, .width_px = 1920, .height_px = 1080, .buttons = POINTER_DIP
    };
    const struct pointer_report on = pointer_report_on(&at, &upright);
    assert_int_equal(on.width_px, 1080);
    assert_int_equal(on.height_px, 1536);
    /* The picture is rotated so that its right side is at the bottom of the screen. */
    assert_near(on.x_px, 270.0f);
    /* The lower side of the picture is at the left of the screen, next to the margin. */
    assert_near(on.y_px, 1536.0f);
    assert_int_equal(on.buttons, POINTER_DIP);
    const struct pointer_report unknown = { .x_px = 5.0f };
    assert_near(pointer_report_on(&unknown, &upright).x_px, 5.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_untransformed_picture_fills_the_screen),
        cmocka_unit_test(test_a_quarter_turn_clockwise_moves_the_top_left_to_the_top_right),
        cmocka_unit_test(test_the_inverse_transform_matches_the_opengl_transform),
        cmocka_unit_test(test_overscan_margins_are_whole_pixels),
        cmocka_unit_test(test_out_of_range_settings_leave_a_visible_picture),
        cmocka_unit_test(test_a_pointer_on_a_rotated_screen_maps_to_the_touched_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
