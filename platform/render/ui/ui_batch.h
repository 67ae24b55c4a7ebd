/* ui_batch.h -- the batch: a list of quads (rectangles), with a fixed maximum length, from which
 * one frame of the user interface is drawn. A quad that is added later is drawn over earlier quads.
 *
 * Coordinates are pixels with the origin at the top left and +y downward. Colours are 0xRRGGBBAA
 * with straight alpha. The batch uses no OpenGL, so that layouts can be tested without a screen. */
#pragma once

#include <stdint.h>

#include "platform/render/specimen.h"
#include "platform/render/ui/text.h"

/* Maximum number of quads in the batch. The screen of the growth lab needs the most quads,
 * because its graph has nine curves of up to 40 segments each. A test checks that the largest
 * screen fits. */
#define UI_QUADS_MAX 2048u

/* Kind of a quad. The comment on each kind lists the meaning of the values of `shape`, in order.
 * Lengths in `shape` are pixels. */
enum ui_kind {
    /* A letter. `shape`: thickening of the strokes, outline width, softness of the outline (these
     * three in atlas pixels), screen pixels per atlas pixel. */
    UI_GLYPH = 0,
    /* A plain panel. `shape`: half width, half height, corner radius, border width. */
    UI_PANEL = 1,
    UI_WASHI = 2, /* Paper with fibres. `shape`: the values of UI_PANEL. */
    UI_WAVES = 3, /* Cloth with a faint pattern of waves. `shape`: the values of UI_PANEL. */
    /* A ring. `shape`: outer radius, ring width, fraction [0, 1] of the ring in the colour `fill`,
     * clockwise from the top. The rest of the ring has the colour `line`. */
    UI_RING = 4,
    UI_GLOW = 5,    /* A glow. `shape`: half width, half height, 1 to add light or 0 to cover. */
    UI_LANTERN = 6, /* A paper lantern. `shape`: half width, half height, brightness [0, 1]. */
    /* A goldfish. `shape`: half width, half height, deflection of the tail [-1, 1]. */
    UI_FISH = 7,
    /* A poi (paper scoop). `shape`: radius of the ring, fraction [0, 1] of the paper that is not
     * torn. */
    UI_POI = 8,
    UI_WOOD = 9, /* Planed wood. `shape`: the values of UI_PANEL. */
    /* The colour scale of the paper's stress, from left (no stress) to right. `shape`: the values
     * of UI_PANEL. */
    UI_HEAT = 10,
    /* An aquarium at night. `shape`: half width, half height, corner radius, time in seconds. */
    UI_WATER = 11,
    /* A ghost poi (a translucent paper scoop that demonstrates a motion) with the hand that holds
     * it, in a box of UI_GHOST_WIDTH x UI_GHOST_HEIGHT ring radii. `shape`: radius of the ring,
     * height of the drawn ring divided by its width, 1 under water or 0 above. */
    UI_GHOST = 12,
    UI_KIND_COUNT,
};

/* Size of the box of a UI_GHOST, and position of the ring's centre from the box's upper left
 * corner. The unit is the radius of the ring. */
#define UI_GHOST_WIDTH 3.5f
#define UI_GHOST_HEIGHT 5.8f
#define UI_GHOST_RING_X 1.2f
#define UI_GHOST_RING_Y 1.3f

struct ui_vertex {
    float x, y; /* Position in pixels. */
    /* Texture coordinates in atlas texels if the quad is a letter. Otherwise the vertex position
     * relative to the shape's centre, in pixels. */
    float u, v;
    float shape[4];
    uint8_t fill[4]; /* Main colour, with straight alpha. */
    /* Colour of the outline or border. Some kinds of quads use this field as a second colour. */
    uint8_t line[4];
};

struct ui_batch {
    /* Four vertices for each quad: top left, top right, bottom left, bottom right. */
    struct ui_vertex vertices[UI_QUADS_MAX * 4u];
    uint8_t kinds[UI_QUADS_MAX]; /* Kind of each quad (enum ui_kind). */
    uint32_t quad_count;
    /* Number of quads and specimens that were dropped because the batch was full. Tests check that
     * the number is 0. */
    uint32_t dropped_count;
    /* Number of drawn characters for which the font has no glyph. Tests check that the number is
     * 0. */
    uint32_t unbaked_count;
    float opacity; /* Opacity of all quads that are added later, [0, 1]. */
    struct specimen specimens[SPECIMEN_MAX];
    /* For each specimen, the number of quads that are drawn before the specimen. */
    uint16_t specimen_quad[SPECIMEN_MAX];
    uint32_t specimen_count;
};

struct ui_box {
    float x, y, width, height;
};

struct ui_shape {
    struct ui_box box;
    enum ui_kind kind;
    /* Parameters of the shape. The comments of enum ui_kind list them for each kind. ui_shape()
     * fills in half widths and half heights from `box`. */
    float shape[4];
    uint32_t fill, line;
    /* Distance in pixels by which the shape's lower edge is shifted to the right, for cloth that
     * moves in the wind. */
    float lean_px;
};

/* Empties the batch and sets the opacity to 1. */
void ui_batch_clear(struct ui_batch *batch);

/* Adds a shape of any kind except UI_GLYPH. The whole shape, including its soft edge, stays inside
 * its box. */
void ui_shape(struct ui_batch *batch, const struct ui_shape *shape);

/* Adds a line of `width_px` with round ends, from `from` to `to`, as one quad. */
void ui_segment(struct ui_batch *batch, const float from[2], const float to[2], float width_px,
                uint32_t colour);

/* Adds a specimen, which is drawn over all earlier quads and under all later quads. The batch's
 * opacity applies to the specimen. A specimen beyond SPECIMEN_MAX is dropped and counted in
 * `dropped_count`. */
void ui_specimen(struct ui_batch *batch, const struct specimen *specimen);

struct ui_text {
    enum font_id font;
    float size_px; /* Size of one em in pixels. */
    /* Horizontal alignment. 0 means that x is the left end of the text, 0.5 its middle, 1 its right
     * end. */
    float align;
    float spacing_em;
    /* Distance in ems by which the strokes of letters are thickened on each side. */
    float weight_em;
    /* Width in ems of the outline around the strokes. The outline has the colour `line`. 0 means no
     * outline. */
    float outline_em;
    /* Additional width in ems over which the outline fades out, for a shadow or a glow. */
    float soft_em;
    uint32_t fill, line;
    /* Maximum width of the text in pixels. A longer text is shrunk to this width. 0 means no
     * maximum. */
    float fit_px;
};

/* Adds one line of text with its baseline at `y`. Returns the width of the text in pixels. */
float ui_text(struct ui_batch *batch, struct ui_text style, float x, float y, const char *words);

/* Returns the width in pixels that the text `words` has when ui_text() draws the text. */
float ui_text_width(struct ui_text style, const char *words);
/* Returns the em size in pixels with which ui_text() draws the text `words`. The size is smaller
 * than `size_px` if the text is shrunk to `fit_px`. */
float ui_text_size(struct ui_text style, const char *words);

/* Returns the y of the baseline at which capitals and digits are vertically centred on `y`. */
float ui_text_middle(struct ui_text style, float y);
