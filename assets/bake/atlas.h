/* atlas.h -- the font atlas: positions of the glyphs' distance fields, on pages of equal size, one
 * below the other.
 *
 * OpenGL ES 3.0 guarantees only textures of 2,048 texels a side, and array textures. The pages
 * therefore become the layers of one array. */
#ifndef KINGYO_ASSETS_BAKE_ATLAS_H
#define KINGYO_ASSETS_BAKE_ATLAS_H

#include "assets/bake/bake.h"

struct atlas {
    uint32_t page_rows;  /* <= FONT_PAGE_ROWS_MAX, a multiple of 4. */
    uint32_t page_count; /* <= FONT_PAGES_MAX */
};

struct glyph {
    uint32_t code;
    int index;      /* Index in the font file. */
    uint8_t *field; /* width x height distances; null for a glyph without ink. */
    int width, height, left_px, top_px;
    uint32_t x, y; /* Position in the atlas: page n begins at row n * page_rows. */
};

/* Orders the glyphs by height and places each on one page. Uses as few pages as possible, and pages
 * no higher than needed. Fails if FONT_PAGES_MAX pages do not hold them; the message names the file
 * `list`. */
struct atlas atlas_pack(struct glyph **glyphs, uint32_t count, const char *list);

void atlas_write(const struct atlas *atlas, struct glyph *const *glyphs, uint32_t count,
                 const char *path);

#endif
