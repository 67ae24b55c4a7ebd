/* test_ui_batch.c -- Tests the list of quads (drawn rectangles) of the user interface: a full list,
 * text alignment, and the texture rectangle of each letter. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "assets.h"
#include "platform/render/ui/ui_batch.h"

static struct ui_batch batch;

static void test_a_full_quad_batch_drops_and_counts_further_quads(void **state)
{
    (void)state;
    ui_batch_clear(&batch);
    const struct ui_shape shape = { .box = { 0, 0, 9, 9 }, .kind = UI_PANEL, .fill = 0xffffffffu };
    for (uint32_t i = 0; i < UI_QUADS_MAX + 5u; i++) {
        ui_shape(&batch, &shape);
    }
    assert_int_equal(batch.quad_count, UI_QUADS_MAX);
    assert_int_equal(batch.dropped_count, 5);
}

static void test_text_is_shrunk_to_its_width_and_aligned(void **state)
{
    (void)state;
    const struct ui_text style = {
        .font = FONT_BODY, .size_px = 40.0f, .align = 0.5f, .fill = 0xffffffffu, .fit_px = 100.0f
    };
    ui_batch_clear(&batch);
    assert_float_equal(ui_text(&batch, style, 200.0f, 50.0f, "WWWWWWWW"), 100.0f, 0.01f);
    assert_true(ui_text_size(style, "WWWWWWWW") < 40.0f);
    assert_float_equal(ui_text_size(style, "W"), 40.0f, 0.001f);
    assert_true(batch.vertices[0].x >= 148.0f);
    assert_true(batch.vertices[batch.quad_count * 4u - 1u].x <= 252.0f);
}

static void test_the_widest_letter_contains_no_texel_of_its_neighbour(void **state)
{
    (void)state;
    const struct font_glyph *glyph = text_glyph(FONT_BRUSH, '8');
    const struct ui_text widest = { .font = FONT_BRUSH,
                                    .size_px = 300.0f,
                                    .fill = 0xffffffffu,
                                    .line = 0xffffffffu,
                                    .outline_em = 1.0f };
    ui_batch_clear(&batch);
    ui_text(&batch, widest, 0.0f, 300.0f, "8");
    assert_int_equal(batch.quad_count, 2); /* A letter with an outline has two quads. */
    /* The outline ends before the margin of the glyph, so that the letter is not in a box. */
    const float reach_px = (float)ASSET_FONT_EDGE / (float)ASSET_FONT_STEP;
    assert_true(batch.vertices[0].shape[1] > 2.0f);
    assert_true(batch.vertices[0].shape[0] + batch.vertices[0].shape[1] < reach_px);
    /* Texture filtering reads up to half a texel around a point, so each point must be half a texel
     * inside the glyph. */
    for (uint32_t i = 0; i < 4u; i++) {
        const float right = batch.vertices[i].u - (float)glyph->x;
        const float down = batch.vertices[i].v - (float)glyph->y;
        assert_true(right >= 0.5f && right <= (float)glyph->width - 0.5f);
        assert_true(down >= 0.5f && down <= (float)glyph->height - 0.5f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_full_quad_batch_drops_and_counts_further_quads),
        cmocka_unit_test(test_text_is_shrunk_to_its_width_and_aligned),
        cmocka_unit_test(test_the_widest_letter_contains_no_texel_of_its_neighbour),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
