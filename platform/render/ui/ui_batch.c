/* ui_batch.c -- fills the list of quads: one quad for each shape and for each letter of a text. */
#include "platform/render/ui/ui_batch.h"

#include <stdbool.h>
#include <string.h>

#include "assets.h"
#include "core/base/panic.h"

/* Width in atlas pixels of the margin around each letter in the font atlas. This is also the
 * maximum width of an outline, because the distance field is constant outside the margin. */
#define REACH_PX ((float)ASSET_FONT_EDGE / (float)ASSET_FONT_STEP)
#define EDGE_PX 2.0f /* Width of the margin's outer part, which no outline covers completely. */

void ui_batch_clear(struct ui_batch *batch)
{
    batch->quad_count = batch->specimen_count = 0;
    batch->dropped_count = batch->unbaked_count = 0;
    batch->opacity = 1.0f;
}

static void unpack(uint8_t out[4], uint32_t colour, float opacity)
{
    out[0] = (uint8_t)(colour >> 24);
    out[1] = (uint8_t)(colour >> 16);
    out[2] = (uint8_t)(colour >> 8);
    out[3] = (uint8_t)((float)(colour & 0xffu) * opacity + 0.5f);
}

/* Adds a quad that fills the box of `shape`. Returns the first of the quad's four vertices. Returns
 * null if the batch is full or the batch's opacity is 0. */
static struct ui_vertex *add_quad(struct ui_batch *batch, const struct ui_shape *shape)
{
    CORE_ASSERT((uint32_t)shape->kind < UI_KIND_COUNT && batch->quad_count <= UI_QUADS_MAX);
    if (batch->opacity <= 0.0f) {
        return NULL;
    }
    if (batch->quad_count == UI_QUADS_MAX) {
        batch->dropped_count++;
        return NULL;
    }
    batch->kinds[batch->quad_count] = (uint8_t)shape->kind;
    struct ui_vertex *quad = &batch->vertices[batch->quad_count++ * 4u];
    for (uint32_t i = 0; i < 4u; i++) {
        const float right = (float)(i & 1u), down = (float)(i >> 1);
        quad[i].x = shape->box.x + shape->box.width * right + shape->lean_px * down;
        quad[i].y = shape->box.y + shape->box.height * down;
        quad[i].u = shape->box.width * (right - 0.5f);
        quad[i].v = shape->box.height * (down - 0.5f);
        memcpy(quad[i].shape, shape->shape, sizeof quad[i].shape);
        unpack(quad[i].fill, shape->fill, batch->opacity);
        unpack(quad[i].line, shape->line, batch->opacity);
    }
    return quad;
}

void ui_shape(struct ui_batch *batch, const struct ui_shape *shape)
{
    CORE_ASSERT(shape->kind != UI_GLYPH);
    struct ui_shape whole = *shape;
    if (shape->kind != UI_RING && shape->kind != UI_POI && shape->kind != UI_GHOST) {
        whole.shape[0] = 0.5f * shape->box.width;
        whole.shape[1] = 0.5f * shape->box.height;
    }
    add_quad(batch, &whole);
}

void ui_segment(struct ui_batch *batch, const float from[2], const float to[2], float width_px,
                uint32_t colour)
{
    CORE_ASSERT(width_px > 0.0f);
    const float x = to[0] - from[0], y = to[1] - from[1];
    const float length = f_sqrt(x * x + y * y);
    const float c = length > 0.0f ? x / length : 1.0f, s = length > 0.0f ? y / length : 0.0f;
    const float half[2] = { 0.5f * (length + width_px), 0.5f * width_px };
    const struct ui_shape shape = { .box = { 0.0f, 0.0f, 2.0f * half[0], 2.0f * half[1] },
                                    .kind = UI_PANEL,
                                    .shape = { half[0], half[1], half[1] },
                                    .fill = colour };
    struct ui_vertex *const quad = add_quad(batch, &shape);
    for (uint32_t i = 0; quad != NULL && i < 4u; i++) {
        quad[i].x = 0.5f * (from[0] + to[0]) + quad[i].u * c - quad[i].v * s;
        quad[i].y = 0.5f * (from[1] + to[1]) + quad[i].u * s + quad[i].v * c;
    }
}

void ui_specimen(struct ui_batch *batch, const struct specimen *specimen)
{
    CORE_ASSERT(batch->specimen_count <= SPECIMEN_MAX);
    if (batch->opacity <= 0.0f) {
        return;
    }
    if (batch->specimen_count == SPECIMEN_MAX) {
        batch->dropped_count++;
        return;
    }
    const uint32_t i = batch->specimen_count++;
    batch->specimens[i] = *specimen;
    batch->specimens[i].fade = 1.0f - (1.0f - specimen->fade) * batch->opacity;
    batch->specimen_quad[i] = (uint16_t)batch->quad_count;
}

float ui_text_width(struct ui_text style, const char *words)
{
    return text_width_em(style.font, words, style.spacing_em) * ui_text_size(style, words);
}

float ui_text_size(struct ui_text style, const char *words)
{
    CORE_ASSERT(style.size_px >= 0.0f);
    const float width_px = text_width_em(style.font, words, style.spacing_em) * style.size_px;
    const bool is_too_wide = style.fit_px > 0.0f && width_px > style.fit_px;
    return is_too_wide ? style.size_px * style.fit_px / width_px : style.size_px;
}

float ui_text_middle(struct ui_text style, float y)
{
    return y + 0.5f * asset_fonts[style.font].cap_em * style.size_px;
}

static void add_glyph(struct ui_batch *batch, struct ui_text style, float size_px, float x, float y,
                      const struct font_glyph *glyph)
{
    const float em = asset_fonts[style.font].em_px, texel_px = size_px / em;
    /* A wider outline would fill the margin of the glyph, so that the letter would be in a box. */
    const float weight = style.weight_em * em, room = REACH_PX - weight;
    const float outline = f_clamp(style.outline_em * em, 0.0f, room - EDGE_PX);
    const float soft = f_clamp(style.soft_em * em, 0.0f, room - outline);
    /* `trim` is the width, in atlas pixels, of the part of the letter's margin that stays unpainted
     * and that the quad therefore omits. `trim` is at least half a texel, because otherwise texture
     * filtering would read texels of the neighbouring letter. */
    const float painted = weight + outline + soft + 0.5f / texel_px + 0.5f;
    const float trim = f_max(REACH_PX - painted, 0.5f);
    const float width = (float)glyph->width - 2.0f * trim;
    const float height = (float)glyph->height - 2.0f * trim;
    const struct ui_shape shape = { .box = { x + glyph->left_em * size_px + trim * texel_px,
                                             y + glyph->top_em * size_px + trim * texel_px,
                                             width * texel_px, height * texel_px },
                                    .kind = UI_GLYPH,
                                    .shape = { weight, outline, soft, texel_px },
                                    .fill = style.fill,
                                    .line = style.line };
    struct ui_vertex *quad = add_quad(batch, &shape);
    for (uint32_t i = 0; quad != NULL && i < 4u; i++) {
        quad[i].u = (float)glyph->x + trim + ((i & 1u) != 0 ? width : 0.0f);
        quad[i].v = (float)glyph->y + trim + ((i & 2u) != 0 ? height : 0.0f);
    }
}

static void add_line(struct ui_batch *batch, struct ui_text style, float size_px, float x, float y,
                     const char *words)
{
    for (uint32_t code = printable_next(&words); code != 0; code = printable_next(&words)) {
        batch->unbaked_count += text_glyph(style.font, code) == NULL;
        const struct font_glyph *const glyph = text_glyph_or_mark(style.font, code);
        if (glyph == NULL) {
            continue;
        }
        if (glyph->width > 0) {
            add_glyph(batch, style, size_px, x, y, glyph);
        }
        x += (glyph->advance_em + style.spacing_em) * size_px;
    }
}

float ui_text(struct ui_batch *batch, struct ui_text style, float x, float y, const char *words)
{
    CORE_ASSERT(style.align >= 0.0f && style.align <= 1.0f);
    const float size_px = ui_text_size(style, words), width_px = ui_text_width(style, words);
    const float left = x - style.align * width_px;
    /* The outlines of all letters are added before the letters, so that no outline covers a
     * neighbouring letter. */
    if (style.outline_em + style.soft_em > 0.0f) {
        struct ui_text outline = style;
        outline.fill = 0;
        add_line(batch, outline, size_px, left, y, words);
    }
    style.line = 0;
    style.outline_em = style.soft_em = 0.0f;
    add_line(batch, style, size_px, left, y, words);
    return width_px;
}
