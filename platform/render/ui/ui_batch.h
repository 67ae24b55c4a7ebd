/* ui_batch.h -- the batch: a list of quads with a fixed maximum size, filled and drawn in painter's
 * order.
 *
 * Coordinates are pixels with the origin at the top left and +y downward. Colours are 0xRRGGBBAA
 * with straight alpha. The batch uses no OpenGL, so that layouts are tested without a screen. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_BATCH_H
#define KINGYO_PLATFORM_RENDER_UI_UI_BATCH_H

#include <stdint.h>

#include "platform/render/specimen.h"
#include "platform/render/ui/text.h"

/* Maximum number of quads. The growth lab needs the most: nine curves of up to 40 segments each. A
 * test measures the largest screen. */
#define UI_QUADS_MAX 2048u

/* Kind of a quad, and the meaning of `shape` for each kind. Lengths in `shape` are pixels. */
enum ui_kind {
    UI_GLYPH = 0,   /* A letter. `shape` is: thickening, outline, softness (all in atlas pixels),
                       screen pixels per atlas pixel. */
    UI_PANEL = 1,   /* A plain panel. `shape` is: half width, half height, corner radius, border
                       width. */
    UI_WASHI = 2,   /* Paper with fibres. `shape` is the same as for UI_PANEL. */
    UI_WAVES = 3,   /* Cloth with a faint pattern of waves. `shape` is the same as for UI_PANEL. */
    UI_RING = 4,    /* A ring. `shape` is: outer radius, width, fraction [0, 1] of the ring that has
                       the colour `fill`, clockwise from the top. The rest of the ring has the
                       colour `line`. */
    UI_GLOW = 5,    /* A glow. `shape` is: half width, half height, 1 to add light or 0 to cover. */
    UI_LANTERN = 6, /* A paper lantern. `shape` is: half width, half height, brightness [0, 1]. */
    UI_FISH = 7,    /* A goldfish. `shape` is: half width, half height, deflection of the tail
                       [-1, 1]. */
    UI_POI = 8,     /* A poi (paper scoop). `shape` is: radius of the ring, fraction of the paper
                       that is left [0, 1]. */
    UI_WOOD = 9,    /* Planed wood. `shape` is the same as for UI_PANEL. */
    UI_HEAT = 10,   /* The colours of the paper's stress, from left to right. `shape` is the same as
                       for UI_PANEL. */
    UI_WATER = 11,  /* An aquarium at night. `shape` is: half width, half height, corner radius,
                       time in seconds. */
    UI_KIND_COUNT,
};

struct ui_vertex {
    float x, y; /* Position in pixels. */
    float u, v; /* Texture coordinates in atlas texels for a letter. Position relative to the
                   shape's centre, in pixels, for any other kind. */
    float shape[4];
    uint8_t fill[4]; /* Main colour, with straight alpha. */
    uint8_t line[4]; /* Colour of the outline or border, or a second colour. */
};

struct ui_batch {
    struct ui_vertex vertices[UI_QUADS_MAX * 4u]; /* Four vertices for each quad: top left, top
                                                     right, bottom left, bottom right. */
    uint8_t kinds[UI_QUADS_MAX];                  /* Kind of each quad (enum ui_kind). */
    uint32_t quad_count;
    uint32_t dropped_count; /* Number of quads dropped because the batch was full. A test requires
                               0. */
    uint32_t unbaked_count; /* Number of drawn letters that the font was baked without. A test
                               requires 0. */
    float opacity;          /* Opacity of all quads that are added later, [0, 1]. */
    struct specimen specimens[SPECIMEN_MAX];
    uint16_t specimen_quad[SPECIMEN_MAX]; /* Number of quads that are drawn before each specimen. */
    uint32_t specimen_count;
};

struct ui_box {
    float x, y, width, height;
};

struct ui_shape {
    struct ui_box box;
    enum ui_kind kind;
    float shape[4]; /* Values of enum ui_kind. Half sizes are computed from `box` and need not be
                       set. */
    uint32_t fill, line;
    float lean_px; /* Shift of the lower edge to the right, in pixels, for cloth in the wind. */
};

/* Empties the batch and sets the opacity to 1. */
void ui_batch_clear(struct ui_batch *batch);

/* Adds a shape of any kind except UI_GLYPH. The whole shape, including its soft edge, stays inside
 * its box. */
void ui_shape(struct ui_batch *batch, const struct ui_shape *shape);

/* Adds a line of `width_px` with round ends, from `from` to `to`, as one quad. */
void ui_segment(struct ui_batch *batch, const float from[2], const float to[2], float width_px,
                uint32_t colour);

/* Adds a specimen over all earlier quads and under all later quads. The specimen is faded by the
 * batch's opacity. A specimen beyond SPECIMEN_MAX is dropped and counted in `dropped_count`. */
void ui_specimen(struct ui_batch *batch, const struct specimen *specimen);

struct ui_text {
    enum font_id font;
    float size_px; /* Size of one em in pixels. */
    float align;   /* Alignment. 0 means that x is the left end of the text, 0.5 its middle, 1 its
                      right end. */
    float spacing_em;
    float weight_em;  /* Thickness in ems that is added to each side of the strokes. */
    float outline_em; /* Width of the outline around the strokes, in colour `line`. 0 means no
                         outline. */
    float soft_em;    /* Additional width in ems over which the outline fades out, for a shadow or a
                         glow. */
    uint32_t fill, line;
    float fit_px; /* Maximum width in pixels, to which a longer text is shrunk. 0 means no
                     maximum. */
};

/* Draws one line of text with its baseline at `y`. Returns its width in pixels. */
float ui_text(struct ui_batch *batch, const struct ui_text *style, float x, float y,
              const char *words);

/* Returns the width in pixels of the text as ui_text() draws it. */
float ui_text_width(const struct ui_text *style, const char *words);
/* Returns the letter size in pixels with which ui_text() draws the text. */
float ui_text_size(const struct ui_text *style, const char *words);

/* Returns the baseline with which capitals and digits are vertically centred on `y`. */
float ui_text_middle(const struct ui_text *style, float y);

#endif
