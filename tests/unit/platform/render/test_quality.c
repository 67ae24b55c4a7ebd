/* test_quality.c -- Tests the render quality that is chosen for each GPU and screen size. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/quality.h"

static struct quality_request request_of(const char *renderer, uint32_t width, uint32_t height)
{
    return (struct quality_request){
        .renderer = renderer,
        .width = width,
        .height = height,
        .samples_max = 8,
        .side_max = 16384,
    };
}

static void test_a_software_renderer_draws_at_most_720p(void **state)
{
    (void)state;
    const struct quality_request small = request_of("llvmpipe (LLVM 15.0.6, 256 bits)", 1280, 720);
    const struct quality_request large = request_of("llvmpipe (LLVM 15.0.6, 256 bits)", 1920, 1080);
    const struct quality at_720 = quality_choose(&small);
    const struct quality at_1080 = quality_choose(&large);
    assert_true(at_720.software);
    assert_float_equal(at_720.scene_scale, 1.0f, 1e-6f);
    assert_int_equal(at_720.samples, 1);
    assert_float_equal(1920.0f * at_1080.scene_scale, 1280.0f, 1.0f);
    assert_true(at_1080.floor_scale < at_1080.scene_scale);
}

static void test_a_desktop_gpu_uses_four_samples_per_pixel(void **state)
{
    (void)state;
    const struct quality_request desktop =
        request_of("AMD Radeon RX 6600 (radeonsi, navi23)", 3840, 2160);
    const struct quality quality = quality_choose(&desktop);
    assert_false(quality.software);
    assert_float_equal(quality.scene_scale, 1.0f, 1e-6f);
    assert_float_equal(quality.floor_scale, 1.0f, 1e-6f);
    assert_int_equal(quality.samples, 4);
}

static void test_a_screen_beyond_the_texture_limit_is_drawn_at_the_limit(void **state)
{
    (void)state;
    struct quality_request upright = request_of("some GPU of OpenGL ES 3.0", 2160, 3840);
    upright.side_max = 2048;
    upright.scene_scale = 2.0f;
    const struct quality quality = quality_choose(&upright);
    assert_float_equal(3840.0f * quality.scene_scale, 2048.0f, 1e-3f);
    assert_float_equal(3840.0f * quality.floor_scale, 2048.0f, 1e-3f);
    assert_float_equal(3840.0f * quality.screen_scale, 2048.0f, 1e-3f);
    assert_int_equal(quality.samples, 1);
    upright.side_max = 3840;
    assert_int_equal(quality_choose(&upright).samples, 4);
}

static void test_a_board_gpu_uses_one_sample_and_a_lower_resolution_on_large_screens(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        float scene_width, screen_width;
    } boards[] = {
        { "V3D 4.2", 1280.0f, 1280.0f },
        { "V3D 7.1.7.0", 1920.0f, 1920.0f },
        { "VC4 V3D 2.1", 1280.0f, 1280.0f },
        { "Broadcom VideoCore VI", 1600.0f, 1920.0f },
        { "Mali-G610 (Panfrost)", 1600.0f, 1920.0f },
        { "Panfrost", 1600.0f, 1920.0f },
        { "Lima", 1600.0f, 1920.0f },
    };
    for (size_t i = 0; i < sizeof boards / sizeof *boards; i++) {
        const struct quality_request small = request_of(boards[i].name, 1280, 720);
        struct quality_request large = request_of(boards[i].name, 1920, 1080);
        assert_false(quality_choose(&small).software);
        assert_int_equal(quality_choose(&small).samples, 1);
        assert_float_equal(quality_choose(&small).scene_scale, 1.0f, 1e-6f);
        assert_float_equal(quality_choose(&small).screen_scale, 1.0f, 1e-6f);
        const struct quality chosen = quality_choose(&large);
        assert_float_equal(1920.0f * chosen.scene_scale, boards[i].scene_width, 1.0f);
        assert_float_equal(1920.0f * chosen.screen_scale, boards[i].screen_width, 1.0f);
        assert_true(chosen.floor_scale < chosen.scene_scale);
        large.scene_scale = 1.0f; /* A requested scale takes precedence. */
        assert_float_equal(quality_choose(&large).screen_scale, 1.0f, 1e-6f);
        assert_float_equal(quality_choose(&large).scene_scale, 1.0f, 1e-6f);
    }
}

static void test_every_software_renderer_is_recognized(void **state)
{
    (void)state;
    static const char *const names[] = { "llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe",
                                         "Google SwiftShader", "Software Rasterizer" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const struct quality_request any = request_of(names[i], 1280, 720);
        assert_true(quality_choose(&any).software);
    }
}

static void test_a_requested_quality_is_limited_by_the_context(void **state)
{
    (void)state;
    struct quality_request fine = request_of("llvmpipe", 1280, 720);
    fine.scene_scale = 0.5f;
    fine.samples = 16;
    assert_float_equal(quality_choose(&fine).scene_scale, 0.5f, 1e-6f);
    assert_float_equal(quality_choose(&fine).screen_scale, 0.5f, 1e-6f);
    assert_int_equal(quality_choose(&fine).samples, 8);
    fine.scene_scale = 9.0f;
    fine.samples_max = 0;
    assert_float_equal(quality_choose(&fine).scene_scale, 2.0f, 1e-6f);
    assert_int_equal(quality_choose(&fine).samples, 1);
}

static void test_each_quality_step_costs_less_than_the_previous_one(void **state)
{
    (void)state;
    const struct quality_request desktop =
        request_of("AMD Radeon RX 6600 (radeonsi, navi23)", 1920, 1080);
    const struct quality best = quality_choose(&desktop);
    struct quality before = quality_lower(&best, 0);
    assert_float_equal(before.scene_scale, best.scene_scale, 0.0f);
    assert_int_equal(before.samples, best.samples);
    for (uint32_t step = 1; step <= QUALITY_STEP_MAX; step++) {
        const struct quality lower = quality_lower(&best, step);
        assert_int_equal(lower.samples, 1);
        /* Each step lowers one value. */
        const bool is_lower[] = { lower.lod_near_px > before.lod_near_px,
                                  lower.floor_scale < before.floor_scale,
                                  lower.mirror_scale < before.mirror_scale,
                                  lower.screen_scale < before.screen_scale,
                                  lower.scene_scale < before.scene_scale };
        static const uint32_t order[QUALITY_STEP_MAX] = { 0, 1, 2, 3, 3, 4, 4 };
        for (uint32_t i = 0; i < sizeof is_lower / sizeof *is_lower; i++) {
            assert_int_equal(is_lower[i], i == order[step - 1u]);
        }
        before = lower;
    }
    const struct quality_request pi4 = request_of("V3D 4.2", 1280, 720);
    const struct quality board = quality_choose(&pi4), first = quality_lower(&board, 1);
    assert_true(board.lod_small_px > 0.0f && first.lod_small_px > board.lod_small_px);
    assert_true(first.lod_small_px < board.lod_near_px);
    const struct quality past = quality_lower(&best, QUALITY_STEP_MAX + 1u);
    assert_float_equal(past.scene_scale, before.scene_scale, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_software_renderer_draws_at_most_720p),
        cmocka_unit_test(test_a_desktop_gpu_uses_four_samples_per_pixel),
        cmocka_unit_test(test_a_screen_beyond_the_texture_limit_is_drawn_at_the_limit),
        cmocka_unit_test(test_a_board_gpu_uses_one_sample_and_a_lower_resolution_on_large_screens),
        cmocka_unit_test(test_every_software_renderer_is_recognized),
        cmocka_unit_test(test_each_quality_step_costs_less_than_the_previous_one),
        cmocka_unit_test(test_a_requested_quality_is_limited_by_the_context),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
