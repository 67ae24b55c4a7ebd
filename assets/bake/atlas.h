/* atlas.h -- the font atlas: the positions of the glyphs' distance fields on pages of equal size,
 * one page below the other.
 *
 * OpenGL ES 3.0 guarantees only array textures and textures of up to 2,048 texels a side. The pages
 * therefore become the layers of one array texture. */
#ifndef KINGYO_ASSETS_BAKE_ATLAS_H
#define KINGYO_ASSETS_BAKE_ATLAS_H

#include "assets/bake/bake.h"

struct atlas {
    uint32_t page_rows;  /* Height of a page in texels, a multiple of 4 and at most
                            FONT_PAGE_ROWS_MAX. */
    uint32_t page_count; /* Number of pages, at most FONT_PAGES_MAX. */
};

struct glyph {
    uint32_t code;
    int index;      /* Index of the glyph in the font file. */
    uint8_t *field; /* Distance field of width x height values. Null for a glyph without ink, such
                       as a space. */
    int width, height, left_px, top_px;
    uint32_t x, y; /* Position in the atlas. Page n begins at row n * page_rows. */
};

/* Sorts the glyphs by height and places each glyph on one page. Uses as few pages as possible, and
 * no page is higher than needed. Ends the bake if the glyphs need more than FONT_PAGES_MAX pages.
 * The error message then names the file `list`. */
struct atlas atlas_pack(struct glyph **glyphs, uint32_t count, const char *list);

/* Writes the pages with the distance fields to the file `path`. */
void atlas_write(const struct atlas *atlas, struct glyph *const *glyphs, uint32_t count,
                 const char *path);

#endif
