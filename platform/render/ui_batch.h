/* ui_batch.h -- a fixed list of quads, filled and drawn in painter's order.
 *
 * Pixels, origin at the top left, +y down. Colours are 0xRRGGBBAA, straight alpha. Knows no OpenGL,
 * so layouts are tested without a screen. */
#ifndef KINGYO_PLATFORM_RENDER_UI_BATCH_H
#define KINGYO_PLATFORM_RENDER_UI_BATCH_H

#include <stdint.h>

#include "platform/render/specimen.h"
#include "platform/render/text.h"

#define UI_QUADS_MAX 2048u /* The growth lab draws nine curves in up to 40 segments each; a test
                              knows the longest screen. */

/* What is drawn in a quad, and what `shape` holds for it; lengths are pixels. */
enum ui_kind {
    UI_GLYPH = 0,   /* grow, outline, softness (atlas pixels), screen pixels per atlas pixel */
    UI_PANEL = 1,   /* half width, half height, corner radius, border */
    UI_WASHI = 2,   /* ... of paper with fibres */
    UI_WAVES = 3,   /* ... of cloth with a faint pattern of waves */
    UI_RING = 4,    /* outer radius, width, part [0, 1] in `fill` from the top, rest in `line` */
    UI_GLOW = 5,    /* half width, half height, 1: adds light, 0: covers */
    UI_LANTERN = 6, /* half width, half height, light [0, 1] */
    UI_FISH = 7,    /* half width, half height, tail's swing [-1, 1] */
    UI_POI = 8,     /* ring radius, paper left [0, 1] */
    UI_WOOD = 9,    /* ... as UI_PANEL, of planed wood */
    UI_HEAT = 10,   /* ... as UI_PANEL, in the colours of the paper's stress from left to right */
    UI_WATER = 11,  /* half width, half height, corner radius, seconds: an aquarium at night */
    UI_KIND_COUNT,
};

struct ui_vertex {
    float x, y;      /* Pixels. */
    float u, v;      /* Glyph: atlas texels. Shape: pixels from its centre. */
    float shape[4];
    uint8_t fill[4]; /* Straight alpha. */
    uint8_t line[4]; /* Outline, border, or second colour. */
};

struct ui_batch {
    struct ui_vertex vertices[UI_QUADS_MAX * 4u]; /* Top left, top right, bottom left, b. right. */
    uint8_t kinds[UI_QUADS_MAX];  /* enum ui_kind of each quad. */
    uint32_t quad_count;
    uint32_t dropped_count; /* Quads that found no room: a test holds this at 0, ... */
    uint32_t unbaked_count; /* ... and this: letters that their font was baked without. */
    float opacity;          /* [0, 1], of everything added from now on. */
    struct specimen specimens[SPECIMEN_MAX];
    uint16_t specimen_quad[SPECIMEN_MAX]; /* Each is drawn over so many quads. */
    uint32_t specimen_count;
};

struct ui_box {
    float x, y, width, height;
};

struct ui_shape {
    struct ui_box box;
    enum ui_kind kind;
    float shape[4];       /* The half sizes are filled in from `box` where the kind wants them. */
    uint32_t fill, line;
    float lean_px;        /* The lower edge hangs this far to the right: cloth in the wind. */
};

/* Empties the batch; opacity 1. */
void ui_batch_clear(struct ui_batch *batch);

/* Any kind but UI_GLYPH. The whole shape, soft edge included, stays inside its box. */
void ui_shape(struct ui_batch *batch, const struct ui_shape *shape);

/* A line with round ends from (x0, y0) to (x1, y1), `width_px` thick: one quad. */
void ui_segment(struct ui_batch *batch, const float from[2], const float to[2], float width_px,
                uint32_t colour);

/* A fish, over all that was added before and under all that comes after; faded by the batch's
 * opacity. One too many is dropped and counted. */
void ui_specimen(struct ui_batch *batch, const struct specimen *specimen);

struct ui_text {
    enum font_id font;
    float size_px;       /* Of an em. */
    float align;         /* 0: x is the left end, 0.5 the middle, 1 the right end. */
    float spacing_em;
    float weight_em;     /* Thickens strokes on each side. */
    float outline_em;    /* Around the strokes, in `line`; 0 is none. */
    float soft_em;       /* The outline fades out over this much more: a shadow, or a light. */
    uint32_t fill, line;
    float fit_px;        /* Shrinks the text to this width; 0 does not. */
};

/* Draws one line with its baseline at `y`; returns its width in pixels. */
float ui_text(struct ui_batch *batch, const struct ui_text *style, float x, float y,
              const char *words);

/* The width that ui_text() would return, and the size in pixels it would use. */
float ui_text_width(const struct ui_text *style, const char *words);
float ui_text_size(const struct ui_text *style, const char *words);

/* The baseline that centres capitals and digits on `y`. */
float ui_text_middle(const struct ui_text *style, float y);

#endif
