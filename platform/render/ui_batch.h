/* ui_batch.h -- a fixed list of quads, filled in painter's order and drawn in one call.
 *
 * Pixels, origin at the top left, +y down. Colours are 0xRRGGBBAA, straight alpha. Knows no OpenGL,
 * so layouts are tested without a screen. */
#ifndef KINGYO_PLATFORM_RENDER_UI_BATCH_H
#define KINGYO_PLATFORM_RENDER_UI_BATCH_H

#include <stdint.h>

/* The longest screen (results, English, four players) needs about 300. */
#define UI_QUADS_MAX 768u

enum ui_kind {
    UI_GLYPH = 0,  /* Distance field letter with an outline. */
    UI_PANEL = 1,  /* Rounded box with a border. */
    UI_RING = 2,   /* Arc of a ring, clockwise from the top. */
    UI_GLOW = 3,   /* Soft round light or shade. */
    UI_WASHI = 4,  /* Rounded box of paper with fibres. */
    UI_WAVES = 5,  /* Rounded box with a faint pattern of waves. */
    UI_LANTERN = 6, /* Paper lantern's body: ribs and an inner light. */
};

struct ui_vertex {
    float x, y;        /* Pixels. */
    float u, v;        /* Glyph: texels of the atlas. Shape: pixels from its centre. */
    float shape[4];    /* Meaning by kind; see the shader in ui.c. */
    uint8_t fill[4];   /* Straight alpha. */
    uint8_t line[4];   /* Outline or border. */
    float kind;        /* enum ui_kind */
};

struct ui_batch {
    struct ui_vertex vertices[UI_QUADS_MAX * 4u];
    uint32_t quad_count;
    uint32_t dropped_count; /* Quads that found no room: a test holds this at 0. */
    float opacity;          /* Multiplies every colour added from now on. */
};

struct ui_box {
    float x, y, width, height;
};

/* Empties the batch; opacity 1. */
void ui_batch_clear(struct ui_batch *batch);

/* A box with round corners; `border_px` 0 is none. Its soft edge stays inside `box`. */
struct ui_panel {
    struct ui_box box;
    float radius_px, border_px;
    uint32_t fill, line;
    enum ui_kind kind; /* UI_PANEL, UI_WASHI or UI_WAVES. */
};
void ui_panel(struct ui_batch *batch, const struct ui_panel *panel);

/* A ring of outer radius `radius_px`; `part` [0, 1] of it is `fill`, the rest is `line`. */
struct ui_ring {
    float x, y, radius_px, width_px, part;
    uint32_t fill, line;
};
void ui_ring(struct ui_batch *batch, const struct ui_ring *ring);

/* Strongest in the middle of `box`, gone at its edge. */
void ui_glow(struct ui_batch *batch, struct ui_box box, uint32_t colour);

/* The lantern's body fills `box`; `light` [0, 1] is how bright it burns. */
void ui_lantern(struct ui_batch *batch, struct ui_box box, uint32_t paper, float light);

/* A glyph's rectangle; `weight_em`, `outline_px` as in text_draw(). */
struct ui_glyph {
    struct ui_box box, texels;
    float grow, outline;     /* Atlas pixels: of the letter, and of its outline beyond that. */
    float texel_px;          /* Screen pixels per atlas pixel. */
    uint32_t fill, line;
};
void ui_glyph(struct ui_batch *batch, const struct ui_glyph *glyph);

#endif
