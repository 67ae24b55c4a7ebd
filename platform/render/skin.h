/* skin.h -- a species' paint on the GPU: sheets (paint_atlas.h) at its keys and between them.
 *
 * Marks wander and fade between keys as paint_at() says, so keys' sheets alone, mixed, would show a
 * bar twice. Two neighbouring sheets are mixed, SKIN_SHEETS or fewer in all. A sheet is painted
 * coarsely, smooth between points, when it is first wanted, and finely over the next frames, the
 * nearest to what is shown first. */
#ifndef KINGYO_PLATFORM_RENDER_SKIN_H
#define KINGYO_PLATFORM_RENDER_SKIN_H

#include "core/morph/morph.h"
#include "platform/render/gl_util.h"
#include "platform/render/paint_atlas.h"

#define SKIN_SHEETS 13u /* Of three keys, six a step; of five, three; of eight, one. */
#define SKIN_BAND 8u    /* Rows that are painted and uploaded together. */
#define SKIN_BANDS (PAINT_SIZE / SKIN_BAND)

struct skin {
    struct species species; /* A copy: its coats are asked for as long as it is worn. */
    struct species_mark lined[MORPH_KEY_MAX]; /* Marks that are not painted: skin_lines(). */
    uint32_t sheet_count, per_key;
    uint32_t bands_done[SKIN_SHEETS];
    bool is_coarse[SKIN_SHEETS]; /* At least. */
    float shown;    /* Which sheet the largest fish in it showed, or between which two; ... */
    float shown_px; /* ... and how large that fish was. 0: none in this frame. */
    GLuint paints;  /* Array: colour, and how clear. */
    GLuint shines;  /* Array: how silvery. */
};

#define SKIN_COARSE 4u /* Texels from point to point of the first, coarse painting. */
#define SKIN_COARSE_SIZE (PAINT_SIZE / SKIN_COARSE)

/* Where a band is painted; whose it is does not matter. */
struct skin_brush {
    uint8_t paint[SKIN_BAND * PAINT_SIZE][4];
    uint8_t shine[SKIN_BAND * PAINT_SIZE];
    float coarse[SKIN_COARSE_SIZE * SKIN_COARSE_SIZE][5]; /* Colour, how clear, how silvery. */
};

void skin_open(struct gl_status *status, struct skin *skin);
void skin_close(struct skin *skin);

/* Takes a species' coats on; nothing is painted yet. */
void skin_wear(struct skin *skin, const struct species *species);

/* The two sheets to mix for keys of these weights, and how much of the second: paints them coarsely
 * where they are not painted at all, in about 2 ms each. Of a fish `length_px` long. */
void skin_show(struct skin *skin, struct skin_brush *brush, const float weights[MORPH_KEY_MAX],
               float length_px, float sheets[3]);

/* Paints up to `bands` on; returns how many of them were not needed. A band takes about 1 ms. */
uint32_t skin_work(struct skin *skin, struct skin_brush *brush, uint32_t bands);

/* Whether the sheets that skin_show() gave for its largest fish are painted finely; whether all. */
bool skin_is_fine(const struct skin *skin);
bool skin_is_done(const struct skin *skin);

/* Lines round the body that are finer than a sheet's texels, as a leaf larva's muscles show: the
 * shader draws them, as sharp as the screen. What mark_cover() asks of MARK_BANDS. */
#define SKIN_LINES 2u
struct skin_lines {
    float place[4]; /* Where the first begins, how far apart, how many, their slant. */
    float shape[4]; /* Half a line's width, from which height to which, and how much it covers. */
    float colour[3];
};
void skin_lines(const struct skin *skin, const float weights[MORPH_KEY_MAX],
                struct skin_lines lines[SKIN_LINES]);

/* How clear it is, [0, 1], without marks; and how many scales lie along it, 0: none are seen. */
float skin_clearness(const struct skin *skin, const float weights[MORPH_KEY_MAX]);
float skin_scales(const struct skin *skin);

#endif
