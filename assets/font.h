/* font.h -- a baked font: a table of glyphs over one shared distance field.
 *
 * The atlas is the texture asset_font with one byte per texel. Each texel stores the signed
 * distance from the glyph's outline. The value ASSET_FONT_EDGE lies on the outline, and larger
 * values lie inside the glyph. A distance of one atlas pixel changes the value by ASSET_FONT_STEP.
 *
 * The atlas consists of ASSET_FONT_PAGES pages, one below the other. Each page has ASSET_FONT_ROWS
 * rows of texels, and each glyph lies completely on one page. All lengths of a glyph that end in
 * _em are in ems, so that a caller only multiplies them by the font size in pixels. The y axis
 * points down from the baseline. */
#pragma once

#include <stdint.h>

struct font_glyph {
    uint32_t code; /* Unicode code point. */
    uint16_t x, y; /* Top left corner in the atlas, in atlas pixels. */
    /* Size in atlas pixels. 0 means a glyph without ink, such as the space. */
    uint16_t width, height;
    /* Offset in ems from the pen position on the baseline to the glyph's top left corner. */
    float left_em, top_em;
    float advance_em; /* Distance from the pen to the pen of the next glyph, in ems. */
};

struct font {
    const char *name;
    const struct font_glyph *glyphs; /* Glyphs in ascending order of `code`. */
    uint32_t glyph_count;
    float em_px; /* Number of atlas pixels per em. */
    /* Height of a capital letter or a digit in ems, used to centre text vertically. */
    float cap_em;
};
