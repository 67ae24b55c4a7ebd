/* glyphs.h -- computes the font size of the letters in text that was laid out. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_GLYPHS_H
#define KINGYO_TESTS_UNIT_SUPPORT_GLYPHS_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "assets.h"
#include "platform/render/ui/ui_batch.h"

/* Width in atlas pixels of the margin of the distance field around the ink of a letter, as in
 * assets/bake/font.c. The quad of a letter omits at least half a pixel of the margin. */
#define GLYPH_MARGIN 10.0f

/* Returns the distance in pixels of the ink of a letter from the sides of its quad, which
 * ui_batch.c trims to the part of the margin that is painted. */
static inline float glyph_margin_px(const struct ui_vertex *v)
{
    const float weight = v->shape[0], outline = v->shape[1], soft = v->shape[2],
                texel = v->shape[3];
    const float painted = weight + outline + soft + 0.5f / texel + 0.5f;
    return (fminf(painted, GLYPH_MARGIN - 0.5f) - weight) * texel;
}

/* Writes the sides of the quad `quad` to `box`: left, top, right, bottom. If the quad is a letter,
 * the sides are those of its ink. */
static inline void glyph_box(const struct ui_batch *batch, uint32_t quad, float box[4])
{
    const struct ui_vertex *v = &batch->vertices[quad * 4u];
    const float margin = batch->kinds[quad] == UI_GLYPH ? glyph_margin_px(v) : 0.0f;
    box[0] = v[0].x < v[2].x ? v[0].x : v[2].x;
    box[1] = v[0].y < v[1].y ? v[0].y : v[1].y;
    box[2] = v[3].x > v[1].x ? v[3].x : v[1].x;
    box[3] = v[3].y > v[2].y ? v[3].y : v[2].y;
    for (uint32_t i = 0; i < 2u; i++) {
        box[i] += margin;
        box[i + 2u] -= margin;
    }
}

/* Returns the number of pixels by which the ink of the letter `quad` overflows the smallest panel
 * that was drawn below the letter and contains its centre. A panel that a later panel hides does
 * not count. Returns 0 or less if the letter is inside, or if there is no panel below the
 * letter. */
static inline float glyph_overflow_px(const struct ui_batch *batch, uint32_t quad)
{
    float letter[4], panel[4] = { 0 }, least = 1e9f, over = 0.0f;
    glyph_box(batch, quad, letter);
    const float x = 0.5f * (letter[0] + letter[2]), y = 0.5f * (letter[1] + letter[3]);
    for (uint32_t i = 0; i < quad; i++) {
        float box[4];
        const uint8_t kind = batch->kinds[i];
        glyph_box(batch, i, box);
        const float area = (box[2] - box[0]) * (box[3] - box[1]);
        /* A line or a cord that is thinner than the letter, and a shadow, are no panels. */
        const bool is_panel =
            batch->vertices[i * 4u].fill[3] > 0x90u &&
            (kind == UI_PANEL || kind == UI_WASHI || kind == UI_WAVES || kind == UI_WOOD) &&
            box[3] - box[1] > 0.75f * (letter[3] - letter[1]) &&
            box[2] - box[0] > 0.75f * (letter[2] - letter[0]);
        const bool hides =
            box[0] <= panel[0] && box[1] <= panel[1] && box[2] >= panel[2] && box[3] >= panel[3];
        if (!is_panel || (area > least && !hides) || x < box[0] || x > box[2] || y < box[1] ||
            y > box[3]) {
            continue;
        }
        memcpy(panel, box, sizeof panel);
        least = area;
        over = letter[2] - box[2];
        over = box[0] - letter[0] > over ? box[0] - letter[0] : over;
        over = box[1] - letter[1] > over ? box[1] - letter[1] : over;
        over = letter[3] - box[3] > over ? letter[3] - box[3] : over;
    }
    return over;
}

/* Largest share of a letter that the box of another letter may cover. Neighbours in a word may
 * touch. */
#define GLYPH_COVERED_MAX 0.2f

/* Returns true for a letter, and false for the outline that is drawn below a letter. */
static inline bool glyph_is_filled(const struct ui_batch *batch, uint32_t quad)
{
    return batch->kinds[quad] == UI_GLYPH && batch->vertices[quad * 4u].fill[3] > 0;
}

/* Returns the area that two boxes share, as a share of the smaller box. */
static inline float glyph_shared_area(const float a[4], const float b[4])
{
    const float width = fminf(a[2], b[2]) - fmaxf(a[0], b[0]);
    const float height = fminf(a[3], b[3]) - fmaxf(a[1], b[1]);
    const float least = fminf((a[2] - a[0]) * (a[3] - a[1]), (b[2] - b[0]) * (b[3] - b[1]));
    return width > 0.0f && height > 0.0f && least > 0.0f ? width * height / least : 0.0f;
}

/* Returns true if a panel that was drawn between the letters `below` and `above` hides the letter
 * `below`. */
static inline bool glyph_is_hidden(const struct ui_batch *batch, uint32_t below, uint32_t above)
{
    float letter[4], box[4];
    glyph_box(batch, below, letter);
    for (uint32_t i = below + 1u; i < above; i++) {
        glyph_box(batch, i, box);
        if (batch->kinds[i] == UI_PANEL && batch->vertices[i * 4u].fill[3] > 0x90u &&
            box[0] <= letter[0] && box[1] <= letter[1] && box[2] >= letter[2] &&
            box[3] >= letter[3]) {
            return true;
        }
    }
    return false;
}

/* Returns the first letter that lies on another visible letter, and writes the shared area to
 * `share`. Returns the number of quads if there is no such letter. */
static inline uint32_t glyph_find_covered(const struct ui_batch *batch, float *share)
{
    float upper[4], lower[4];
    for (uint32_t i = 0; i < batch->quad_count; i++) {
        glyph_box(batch, i, upper);
        for (uint32_t j = 0; j < i && glyph_is_filled(batch, i); j++) {
            if (!glyph_is_filled(batch, j)) {
                continue;
            }
            glyph_box(batch, j, lower);
            *share = glyph_shared_area(upper, lower);
            if (*share > GLYPH_COVERED_MAX && !glyph_is_hidden(batch, j, i)) {
                return i;
            }
        }
    }
    return batch->quad_count;
}

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
