/* canvas.c -- draws shapes and text into the pixels of a canvas.
 *
 * A partly covered pixel is blended with the colour in linear light. */
#include "platform/ctl/lib/canvas.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

#include "assets.h"
#include "core/base/panic.h"
#include "platform/os/png.h"
#include "platform/render/ui/text.h"

/* Minimum width of the soft edge of a letter, in pixels of the font atlas. The font atlas is the
 * texture with all letters. */
#define FONT_PIXEL_MIN 0.6f

bool canvas_open(struct canvas *canvas, uint32_t width, uint32_t height)
{
    CORE_ASSERT(width >= 1 && width <= CANVAS_SIDE_MAX);
    CORE_ASSERT(height >= 1 && height <= CANVAS_SIDE_MAX);
    *canvas = (struct canvas){ .width = width, .height = height };
    canvas->pixels = calloc((size_t)width * height, sizeof *canvas->pixels);
    return canvas->pixels != NULL;
}

void canvas_close(struct canvas *canvas)
{
    free(canvas->pixels);
    canvas->pixels = NULL;
}

/* ---- Colour conversion ----------------------------------------------------------------------- */

static float to_linear(float c)
{
    return c <= 0.04045f ? c / 12.92f : powf((c + 0.055f) / 1.055f, 2.4f);
}

static float to_srgb(float c)
{
    return c <= 0.0031308f ? c * 12.92f : 1.055f * powf(c, 1.0f / 2.4f) - 0.055f;
}

vec3 canvas_linear(vec3 srgb)
{
    return v3(to_linear(srgb.x), to_linear(srgb.y), to_linear(srgb.z));
}

vec3 canvas_colour(uint32_t rgb)
{
    return canvas_linear(v3((float)(rgb >> 16 & 255u) / 255.0f, (float)(rgb >> 8 & 255u) / 255.0f,
                            (float)(rgb & 255u) / 255.0f));
}

/* ---- Rectangles ------------------------------------------------------------------------------ */

struct span {
    /* `first` is the first pixel that the range touches. `end` is the pixel after the last one that
     * the range touches. */
    uint32_t first, end;
};

static struct span touched_pixels(float from, float size, uint32_t limit)
{
    const float first = f_clamp(floorf(from), 0.0f, (float)limit);
    const float end = f_clamp(ceilf(from + size), first, (float)limit);
    return (struct span){ (uint32_t)first, (uint32_t)end };
}

/* Returns the share, in [0, 1], of pixel `index` that the range from `from` to `from` + `size`
 * covers. */
static float covered(float from, float size, uint32_t index)
{
    const float low = f_max(from, (float)index);
    const float high = f_min(from + size, (float)index + 1.0f);
    return f_max(high - low, 0.0f);
}

void canvas_fill(struct canvas *canvas, struct canvas_box box, uint32_t above, uint32_t below)
{
    const struct span rows = touched_pixels(box.top, box.height, canvas->height);
    const struct span columns = touched_pixels(box.left, box.width, canvas->width);
    const vec3 top = canvas_colour(above), bottom = canvas_colour(below);
    for (uint32_t y = rows.first; y < rows.end; y++) {
        const float part = f_clamp(((float)y + 0.5f - box.top) / box.height, 0.0f, 1.0f);
        const vec3 colour = v3_lerp(top, bottom, part);
        for (uint32_t x = columns.first; x < columns.end; x++) {
            vec3 *pixel = &canvas->pixels[(size_t)y * canvas->width + x];
            const float cover = covered(box.left, box.width, x) * covered(box.top, box.height, y);
            *pixel = v3_lerp(*pixel, colour, cover);
        }
    }
}

/* ---- Text ------------------------------------------------------------------------------------ */

static float glyph_texel(const struct font_glyph *glyph, int x, int y)
{
    if (x < 0 || y < 0 || x >= glyph->width || y >= glyph->height) {
        return 0.0f;
    }
    return asset_font[((size_t)glyph->y + (size_t)y) * ASSET_FONT_WIDTH + glyph->x + (size_t)x];
}

/* Returns the value of a glyph's distance field at a position in the font atlas, by bilinear
 * interpolation. */
static float distance_at(const struct font_glyph *glyph, float x, float y)
{
    const float left = floorf(x - 0.5f), top = floorf(y - 0.5f);
    const float tx = x - 0.5f - left, ty = y - 0.5f - top;
    const int i = (int)left, j = (int)top;
    return f_lerp(f_lerp(glyph_texel(glyph, i, j), glyph_texel(glyph, i + 1, j), tx),
                  f_lerp(glyph_texel(glyph, i, j + 1), glyph_texel(glyph, i + 1, j + 1), tx), ty);
}

static void draw_glyph(struct canvas *canvas, const struct font_glyph *glyph, float pen_x,
                       float pen_y, float size_px, vec3 ink)
{
    const float fine = asset_fonts[FONT_BODY].em_px / size_px; /* Number of font atlas pixels per
                                                                  canvas pixel. */
    const struct canvas_box box = { pen_x + glyph->left_em * size_px,
                                    pen_y + glyph->top_em * size_px, (float)glyph->width / fine,
                                    (float)glyph->height / fine };
    const struct span rows = touched_pixels(box.top, box.height, canvas->height);
    const struct span columns = touched_pixels(box.left, box.width, canvas->width);
    const float edge = f_max(fine, FONT_PIXEL_MIN) * (float)ASSET_FONT_STEP;
    for (uint32_t y = rows.first; y < rows.end; y++) {
        for (uint32_t x = columns.first; x < columns.end; x++) {
            const float value = distance_at(glyph, ((float)x + 0.5f - box.left) * fine,
                                            ((float)y + 0.5f - box.top) * fine);
            const float cover = f_clamp((value - (float)ASSET_FONT_EDGE) / edge + 0.5f, 0.0f, 1.0f);
            vec3 *pixel = &canvas->pixels[(size_t)y * canvas->width + x];
            *pixel = v3_lerp(*pixel, ink, cover);
        }
    }
}

void canvas_words(struct canvas *canvas, float x, float y, float size_px, enum canvas_align align,
                  uint32_t rgb, const char *words)
{
    const float width = text_width_em(FONT_BODY, words, 0.0f) * size_px;
    const vec3 ink = canvas_colour(rgb);
    float pen = x - (align == ALIGN_LEFT ? 0.0f : align == ALIGN_RIGHT ? width : 0.5f * width);
    for (uint32_t code = printable_next(&words); code != 0; code = printable_next(&words)) {
        const struct font_glyph *glyph = text_glyph_or_mark(FONT_BODY, code);
        if (glyph) {
            draw_glyph(canvas, glyph, pen, y, size_px, ink);
            pen += glyph->advance_em * size_px;
        }
    }
}

/* ---- PNG output ------------------------------------------------------------------------------ */

int canvas_write_png(const struct canvas *canvas, const char *path)
{
    const size_t count = (size_t)canvas->width * canvas->height;
    CORE_ASSERT(canvas->pixels);
    uint8_t *rgb = malloc(3u * count);
    if (!rgb) {
        return -ENOMEM;
    }
    for (size_t i = 0; i < 3u * count; i++) {
        const vec3 *pixel = &canvas->pixels[i / 3u];
        const float linear = i % 3u == 0 ? pixel->x : i % 3u == 1 ? pixel->y : pixel->z;
        rgb[i] = (uint8_t)(to_srgb(f_clamp(linear, 0.0f, 1.0f)) * 255.0f + 0.5f);
    }
    const int error = png_write(path, rgb, canvas->width, canvas->height);
    free(rgb);
    return error;
}
