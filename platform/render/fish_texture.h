/* fish_texture.h -- the texture of a fish: a species' paint on the GPU, as a series of sheets
 * (texture layers, paint_atlas.h). Each sheet shows the paint at one key shape (modelled growth
 * stage) or at a stage between two key shapes.
 *
 * Marks move and fade between key shapes as in paint_at(). If only the sheets of the key shapes
 * were blended, a moving mark would appear twice. Therefore up to FISH_TEXTURE_SHEETS sheets are
 * painted, and two neighbouring sheets are blended. A sheet is first painted coarsely, with
 * interpolation between points. The following frames paint the sheets finely (at full resolution),
 * beginning with the sheets that are nearest in the series to the two blended sheets of the largest
 * fish. */
#pragma once

#include "core/morph/morph.h"
#include "platform/render/gl_util.h"
#include "platform/render/paint_atlas.h"

/* Maximum number of painted sheets of a fish texture. From one key shape to the next, the sheet
 * number increases by six if the species has three key shapes, by three if it has five, and by one
 * if it has eight. */
#define FISH_TEXTURE_SHEETS 13u
#define FISH_TEXTURE_BANDS                                                                         \
    (PAINT_SIZE / PAINT_BAND) /* Number of bands (groups of PAINT_BAND texel rows) of a sheet. */

struct fish_texture {
    /* Copy of the species. Its coats (the paint of each key shape) are read as long as the texture
     * is used. */
    struct species species;
    /* Marks that the shader draws as lines (fish_texture_lines()). The sheets are painted without
     * these marks. */
    struct species_mark lined[MORPH_KEY_MAX];
    uint32_t sheet_count, per_key;
    uint32_t bands_done[FISH_TEXTURE_SHEETS];
    /* True for each sheet that is painted at least coarsely. */
    bool is_coarse[FISH_TEXTURE_SHEETS];
    /* Position in the series of sheets that the largest fish with this texture shows, from 0 to
     * sheet_count - 1. A fraction means a blend of two neighbouring sheets. */
    float shown;
    /* Length in pixels of the largest fish with this texture. 0 means that no fish in the current
     * frame has this texture. */
    float shown_px;
    GLuint paints; /* Array texture of the sheets' colour and transparency. */
    GLuint shines; /* Array texture of the sheets' reflectance. */
};

void fish_texture_open(struct gl_status *status, struct fish_texture *skin);
void fish_texture_close(struct fish_texture *skin);

/* Assigns the paint of `species` to the texture. Nothing is painted yet. */
void fish_texture_bind(struct fish_texture *skin, const struct species *species);

/* Selects the two sheets to blend for the key weights `weights`. Writes the number of the first
 * sheet, the number of the second sheet and the blend weight of the second sheet to `sheets`.
 * Paints each of the two sheets coarsely if it is unpainted, in about 2 ms per sheet. `length_px`
 * is the fish's length on the screen. */
void fish_texture_request(struct fish_texture *skin, struct paint_brush *brush,
                          const float weights[MORPH_KEY_MAX], float length_px, float sheets[3]);

/* Paints up to `bands` more bands of a sheet at full resolution, in about 1 ms each. Stops early
 * when all sheets are finished. Returns how many of the `bands` were not painted. */
uint32_t fish_texture_work(struct fish_texture *skin, struct paint_brush *brush, uint32_t bands);

/* Returns true if the sheets that the largest fish shows are painted at full resolution. See
 * fish_texture_request(). */
bool fish_texture_is_fine(const struct fish_texture *skin);
/* Returns true if every sheet is painted at full resolution. */
bool fish_texture_is_done(const struct fish_texture *skin);

/* Maximum number of line sets that the shader draws on one fish. A line set is a series of lines
 * round the body, such as the muscles of a leaf-shaped larva, that are narrower than a texel of a
 * sheet. The shader draws these lines at the screen's resolution, in the shape that mark_cover()
 * gives to MARK_BANDS. */
#define FISH_TEXTURE_LINES 2u
struct fish_texture_lines {
    /* The four values are the position of the first line along the body, the spacing of the lines,
     * the number of lines, and the slant of the lines. */
    float place[4];
    /* The four values are half of the width of a line, its lower and its upper height on the body,
     * and its opacity [0, 1]. */
    float shape[4];
    float colour[3];
};
/* Writes the line sets that the shader draws for the key weights `weights`. */
void fish_texture_lines(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX],
                        struct fish_texture_lines lines[FISH_TEXTURE_LINES]);

/* Returns the transparency of the body's skin between the marks, [0, 1]. 0 means opaque. */
float fish_texture_opacity(const struct fish_texture *skin, const float weights[MORPH_KEY_MAX]);
/* Returns the number of fish scales from head to tail. 0 means that no scales are visible. */
float fish_texture_scales(const struct fish_texture *skin);
