/* glyphs.h -- computes the font size of the letters in text that was laid out. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_GLYPHS_H
#define KINGYO_TESTS_UNIT_SUPPORT_GLYPHS_H

#include "assets.h"
#include "platform/render/ui/ui_batch.h"

/* Returns the font size in pixels at which a letter is drawn, or 0 if the quad `quad` of `batch` is
 * not a letter. The texture coordinates of the quad identify its font. */
static inline float glyph_em_px(const struct ui_batch *batch, uint32_t quad)
{
    const struct ui_vertex *v = &batch->vertices[quad * 4u];
    for (uint32_t font = 0; font < FONT_COUNT; font++) {
        for (uint32_t i = 0; i < asset_fonts[font].glyph_count; i++) {
            const struct font_glyph *glyph = &asset_fonts[font].glyphs[i];
            const float right = v->u - (float)glyph->x, down = v->v - (float)glyph->y;
            if (right >= 0.0f && right < (float)glyph->width && down >= 0.0f &&
                down < (float)glyph->height) {
                return asset_fonts[font].em_px * v->shape[3];
            }
        }
    }
    return 0.0f;
}

#endif
