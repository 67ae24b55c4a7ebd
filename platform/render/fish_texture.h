/* fish_texture.h -- a fish texture: a species' paint on the GPU, as sheets (paint_atlas.h) at its
 * keys and between them.
 *
 * Marks move and fade between keys as in paint_at(), so mixing only the keys' sheets would show a
 * bar twice. Therefore up to FISH_TEXTURE_SHEETS sheets are painted, and two neighbouring sheets
 * are mixed. A sheet is painted coarsely when it is first needed, with interpolation between
 * points. The following frames paint it finely, beginning with the sheet nearest to the one shown.
 */
#ifndef KINGYO_PLATFORM_RENDER_FISH_TEXTURE_H
#define KINGYO_PLATFORM_RENDER_FISH_TEXTURE_H

#include "core/morph/morph.h"
#include "platform/render/gl_util.h"
#include "platform/render/paint_atlas.h"

/* Three keys have six sheets a step, five keys three, and eight keys one. */
#define FISH_TEXTURE_SHEETS 13u
#define FISH_TEXTURE_BAND 8u /* Rows that are painted and uploaded together. */
#define FISH_TEXTURE_BANDS (PAINT_SIZE / FISH_TEXTURE_BAND)

struct fish_texture {
    struct species species; /* Copy of the species, because its coats are read as long as the
                               texture is in use. */
    struct species_mark lined[MORPH_KEY_MAX]; /* Marks that the shader draws instead of the
                                                 painting: fish_texture_lines(). */
    uint32_t sheet_count, per_key;
    uint32_t bands_done[FISH_TEXTURE_SHEETS];
    bool is_coarse[FISH_TEXTURE_SHEETS]; /* Sheets that are painted at least coarsely. */
    float shown;    /* Sheet, or position between two sheets, shown by the largest fish with this
                       texture. */
    float shown_px; /* Length of that fish in pixels; 0: no fish in this frame. */
    GLuint paints;  /* Array texture: colour and transparency. */
    GLuint shines;  /* Array texture: reflectance. */
};

#define FISH_TEXTURE_COARSE 4u /* Texels between two points of the coarse painting. */
#define FISH_TEXTURE_COARSE_SIZE (PAINT_SIZE / FISH_TEXTURE_COARSE)

/* Scratch memory in which a band is painted. Any fish texture may use it. */
struct fish_texture_brush {
    uint8_t paint[FISH_TEXTURE_BAND * PAINT_SIZE][4];
    uint8_t shine[FISH_TEXTURE_BAND * PAINT_SIZE];
    float coarse[FISH_TEXTURE_COARSE_SIZE * FISH_TEXTURE_COARSE_SIZE]
                [5]; /* Colour, transparency, reflectance. */
};

void fish_texture_open(struct gl_status *status, struct fish_texture *skin);
void fish_texture_close(struct fish_texture *skin);

/* Assigns a species' coats. Nothing is painted yet. */
void fish_texture_bind(struct fish_texture *skin, const struct species *species);

/* Writes the two sheets to mix for these key weights and the weight of the second sheet. Paints
 * them coarsely if they are unpainted, in about 2 ms each. `length_px` is the fish's length on the
 * screen. */
void fish_texture_request(struct fish_texture *skin, struct fish_texture_brush *brush,
                          const float weights[MORPH_KEY_MAX], float length_px, float sheets[3]);

/* Paints up to `bands` further bands, about 1 ms each. Returns how many of them were not needed. */
uint32_t fish_texture_work(struct fish_texture *skin, struct fish_texture_brush *brush,
                           uint32_t bands);

/* Return whether the sheets last returned by fish_texture_request() for the largest fish are
 * painted finely, and whether all sheets are. */
bool fish_texture_is_fine(const struct fish_texture *skin);
bool fish_texture_is_done(const struct fish_texture *skin);

/* Lines round the body that are finer than a sheet's texels, such as the muscles of a leaf-shaped
 * larva. The shader draws them at the screen's resolution, as mark_cover() does for MARK_BANDS. */
#define FISH_TEXTURE_LINES 2u
struct fish_texture_lines {
    float place[4]; /* Position of the first line, spacing, number, slant. */
    float shape[4]; /* Half a line's width, lower and upper height, coverage. */
    float colour[3];
};
void fish_texture_lines(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX],
                        struct fish_texture_lines lines[FISH_TEXTURE_LINES]);

/* Returns the transparency without marks, [0, 1]. fish_texture_scales() returns the number of
 * scales along the body; 0: no visible scales. */
float fish_texture_opacity(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX]);
float fish_texture_scales(const struct fish_texture *skin);

#endif
