/* fish_texture.h -- a fish texture: a species' paint on the GPU, as a series of sheets. Each sheet
 * (paint_atlas.h) shows the paint at a key shape (modelled growth stage) or between two key shapes.
 *
 * Marks move and fade between key shapes as in paint_at(). A mix of only the key shapes' sheets
 * would show a moving mark twice. Therefore up to FISH_TEXTURE_SHEETS sheets are painted, and two
 * neighbouring sheets are mixed. A sheet is painted coarsely when it is first needed, with
 * interpolation between points. The following frames paint the sheet finely, beginning with the
 * sheet nearest to the one shown. */
#ifndef KINGYO_PLATFORM_RENDER_FISH_TEXTURE_H
#define KINGYO_PLATFORM_RENDER_FISH_TEXTURE_H

#include "core/morph/morph.h"
#include "platform/render/gl_util.h"
#include "platform/render/paint_atlas.h"

/* Maximum number of sheets. A species with three keys has six sheets from one key to the next, a
 * species with five keys has three, and a species with eight keys has one. */
#define FISH_TEXTURE_SHEETS 13u
#define FISH_TEXTURE_BAND 8u /* Number of texel rows that are painted and uploaded together. */
#define FISH_TEXTURE_BANDS (PAINT_SIZE / FISH_TEXTURE_BAND)

struct fish_texture {
    struct species species; /* Copy of the species, because its coats are read as long as the
                               texture is used. */
    struct species_mark lined[MORPH_KEY_MAX]; /* Marks that the shader draws as lines, see
                                                 fish_texture_lines(). They are absent from the
                                                 painted sheets. */
    uint32_t sheet_count, per_key;
    uint32_t bands_done[FISH_TEXTURE_SHEETS];
    bool is_coarse[FISH_TEXTURE_SHEETS]; /* True for each sheet that is painted at least
                                            coarsely. */
    float shown;    /* Position in the sheets that the largest fish with this texture shows. A
                       fraction means a mix of two neighbouring sheets. */
    float shown_px; /* Length in pixels of the largest fish with this texture. 0 means no fish in
                       the current frame. */
    GLuint paints;  /* Array texture of the sheets' colour and transparency. */
    GLuint shines;  /* Array texture of the sheets' reflectance. */
};

#define FISH_TEXTURE_COARSE 4u /* Distance in texels between two points of the coarse painting. */
#define FISH_TEXTURE_COARSE_SIZE (PAINT_SIZE / FISH_TEXTURE_COARSE)

/* Scratch memory in which a band of FISH_TEXTURE_BAND rows is painted. All fish textures may share
 * one brush. */
struct fish_texture_brush {
    uint8_t paint[FISH_TEXTURE_BAND * PAINT_SIZE][4];
    uint8_t shine[FISH_TEXTURE_BAND * PAINT_SIZE];
    float coarse[FISH_TEXTURE_COARSE_SIZE * FISH_TEXTURE_COARSE_SIZE]
                [5]; /* Colour, transparency and reflectance of each coarse point. */
};

void fish_texture_open(struct gl_status *status, struct fish_texture *skin);
void fish_texture_close(struct fish_texture *skin);

/* Assigns the coats of `species` to the texture. Nothing is painted yet. */
void fish_texture_bind(struct fish_texture *skin, const struct species *species);

/* Selects the two sheets to mix for the given key weights. Writes the two sheet numbers and the
 * weight of the second sheet to `sheets`. Unpainted sheets are painted coarsely, in about 2 ms
 * each. `length_px` is the fish's length on the screen. */
void fish_texture_request(struct fish_texture *skin, struct fish_texture_brush *brush,
                          const float weights[MORPH_KEY_MAX], float length_px, float sheets[3]);

/* Paints up to `bands` further bands, in about 1 ms each. Returns the part of `bands` that was not
 * needed because everything is painted. */
uint32_t fish_texture_work(struct fish_texture *skin, struct fish_texture_brush *brush,
                           uint32_t bands);

/* Returns whether the sheets that fish_texture_request() last returned for the largest fish are
 * painted finely. */
bool fish_texture_is_fine(const struct fish_texture *skin);
/* Returns whether all sheets are painted finely. */
bool fish_texture_is_done(const struct fish_texture *skin);

/* Maximum number of line sets that the shader draws on one fish. Some lines round the body are
 * finer than a sheet's texels, such as the muscles of a leaf-shaped larva. The shader draws them at
 * the screen's resolution, as mark_cover() does for MARK_BANDS. */
#define FISH_TEXTURE_LINES 2u
struct fish_texture_lines {
    float place[4]; /* Placement of the lines: position of the first line, spacing, number of lines,
                       slant. */
    float shape[4]; /* Shape of a line: half of its width, lower and upper height on the body,
                       coverage. */
    float colour[3];
};
/* Writes the line sets that the shader draws for the given key weights. */
void fish_texture_lines(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX],
                        struct fish_texture_lines lines[FISH_TEXTURE_LINES]);

/* Returns the body's transparency without marks, [0, 1]. */
float fish_texture_opacity(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX]);
/* Returns the number of scales along the body. 0 means no visible scales. */
float fish_texture_scales(const struct fish_texture *skin);

#endif
