/* ui_batch.h -- a fixed list of quads, filled and drawn in painter's order.
 *
 * Coordinates are pixels, origin at the top left, +y down. Colours are 0xRRGGBBAA, straight alpha.
 * Uses no OpenGL, so layouts are tested without a screen. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_BATCH_H
#define KINGYO_PLATFORM_RENDER_UI_UI_BATCH_H

#include <stdint.h>

#include "platform/render/specimen.h"
#include "platform/render/ui/text.h"

/* The growth lab needs the most quads: nine curves of up to 40 segments each. A test measures
 * the largest screen. */
#define UI_QUADS_MAX 2048u

/* Kind of a quad, and the meaning of its `shape`; lengths are pixels. */
enum ui_kind {
    UI_GLYPH = 0,   /* grow, outline, softness (atlas pixels), screen pixels per atlas pixel */
    UI_PANEL = 1,   /* half width, half height, corner radius, border */
    UI_WASHI = 2,   /* Same as UI_PANEL, as paper with fibres. */
    UI_WAVES = 3,   /* Same as UI_PANEL, as cloth with a faint pattern of waves. */
    UI_RING = 4,    /* outer radius, width, part [0, 1] in `fill` from the top, rest in `line` */
    UI_GLOW = 5,    /* half width, half height, 1: adds light, 0: covers */
    UI_LANTERN = 6, /* half width, half height, light [0, 1] */
    UI_FISH = 7,    /* half width, half height, tail's swing [-1, 1] */
    UI_POI = 8,     /* ring radius, paper left [0, 1] */
    UI_WOOD = 9,    /* Same as UI_PANEL, as planed wood. */
    UI_HEAT = 10,   /* Same as UI_PANEL, in the colours of the paper's stress from left to right. */
    UI_WATER = 11,  /* half width, half height, corner radius, seconds: an aquarium at night */
    UI_KIND_COUNT,
};

struct ui_vertex {
    float x, y; /* Pixels. */
    float u, v; /* Glyph: atlas texels. Shape: pixels from its centre. */
    float shape[4];
    uint8_t fill[4]; /* Straight alpha. */
    uint8_t line[4]; /* Outline, border, or second colour. */
};

struct ui_batch {
    struct ui_vertex vertices[UI_QUADS_MAX * 4u]; /* Order: top left, top right, bottom left, bottom
                                                     right. */
    uint8_t kinds[UI_QUADS_MAX];                  /* enum ui_kind of each quad. */
    uint32_t quad_count;
    uint32_t dropped_count; /* Quads dropped because the batch was full; a test requires 0. */
    uint32_t unbaked_count; /* Letters that the font was baked without; a test requires 0. */
    float opacity;          /* Opacity of all later quads, [0, 1]. */
    struct specimen specimens[SPECIMEN_MAX];
    uint16_t specimen_quad[SPECIMEN_MAX]; /* Number of quads below each specimen. */
    uint32_t specimen_count;
};

struct ui_box {
    float x, y, width, height;
};

struct ui_shape {
    struct ui_box box;
    enum ui_kind kind;
    float shape[4]; /* Half sizes are computed from `box` for kinds that use them. */
    uint32_t fill, line;
    float lean_px; /* Horizontal shift of the lower edge to the right, for cloth in the wind. */
};

/* Empties the batch and sets the opacity to 1. */
void ui_batch_clear(struct ui_batch *batch);

/* Adds a shape of any kind but UI_GLYPH. The whole shape, including its soft edge, stays inside its
 * box. */
void ui_shape(struct ui_batch *batch, const struct ui_shape *shape);

/* Adds a line with round ends from `from` to `to`, `width_px` thick, as one quad. */
void ui_segment(struct ui_batch *batch, const float from[2], const float to[2], float width_px,
                uint32_t colour);

/* Adds a fish over all earlier quads and under all later ones, faded by the batch's opacity. A
 * specimen beyond SPECIMEN_MAX is dropped and counted. */
void ui_specimen(struct ui_batch *batch, const struct specimen *specimen);

struct ui_text {
    enum font_id font;
    float size_px; /* Size of an em. */
    float align;   /* 0: x is the left end, 0.5 the middle, 1 the right end. */
    float spacing_em;
    float weight_em;  /* Thickens strokes on each side. */
    float outline_em; /* Outline around the strokes, in colour `line`; 0 is none. */
    float soft_em;    /* Additional width over which the outline fades out, for a shadow or a
                         glow. */
    uint32_t fill, line;
    float fit_px; /* Maximum width to which the text is shrunk; 0: no limit. */
};

/* Draws one line with its baseline at `y`. Returns its width in pixels. */
float ui_text(struct ui_batch *batch, const struct ui_text *style, float x, float y,
              const char *words);

/* Returns the width of the text as drawn by ui_text(). ui_text_size() returns the letter size in
 * pixels that ui_text() uses. */
float ui_text_width(const struct ui_text *style, const char *words);
float ui_text_size(const struct ui_text *style, const char *words);

/* Returns the baseline that centres capitals and digits on `y`. */
float ui_text_middle(const struct ui_text *style, float y);

#endif
