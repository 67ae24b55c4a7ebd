/* font.h -- a baked font: a table of glyphs over one shared distance field.
 *
 * The atlas (asset_font, R8) holds each glyph's signed distance to its outline: ASSET_FONT_EDGE is
 * on the outline, more is inside, and one atlas pixel of distance is ASSET_FONT_STEP. The
 * atlas consists of ASSET_FONT_PAGES pages of ASSET_FONT_ROWS rows, one below the other; no glyph
 * lies on two pages. Lengths are in ems, +y down from the baseline, so a caller multiplies only by
 * the size in pixels. */
#ifndef KINGYO_ASSETS_FONT_H
#define KINGYO_ASSETS_FONT_H

#include <stdint.h>

struct font_glyph {
    uint32_t code;          /* Unicode code point. */
    uint16_t x, y;          /* Top left corner in the atlas, in atlas pixels. */
    uint16_t width, height; /* Size in atlas pixels. 0 means a glyph without ink, such as the
                               space. */
    float left_em, top_em;  /* Offset in ems from the pen position on the baseline to the glyph's
                               top left corner. */
    float advance_em;       /* Distance from the pen to the pen of the next glyph, in ems. */
};

struct font {
    const char *name;
    const struct font_glyph *glyphs; /* Glyphs in ascending order of `code`. */
    uint32_t glyph_count;
    float em_px;                 /* Number of atlas pixels per em. */
    float ascent_em, descent_em; /* Height of the font above the baseline and below the baseline, in
                                    ems. Both values are positive, and their sum is the height of a
                                    line. */
    float cap_em;                /* Height of a capital letter or a digit in ems, used to centre
                                    text vertically. */
};

#endif
