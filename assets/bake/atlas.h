/* atlas.h -- where each glyph's distance field lies: pages of equal size, one below the other.
 *
 * OpenGL ES 3.0 promises textures of 2,048 texels a side and no more, and arrays of them; so the
 * pages become the layers of one array. */
#ifndef KINGYO_ASSETS_BAKE_ATLAS_H
#define KINGYO_ASSETS_BAKE_ATLAS_H

#include "assets/bake/bake.h"

struct atlas {
    uint32_t page_rows;  /* <= FONT_PAGE_ROWS_MAX, a multiple of 4. */
    uint32_t page_count; /* <= FONT_PAGES_MAX */
};

struct glyph {
    uint32_t code;
    int index;      /* In the font file. */
    uint8_t *field; /* width x height distances; null where there is no ink. */
    int width, height, left_px, top_px;
    uint32_t x, y;  /* In the atlas: page n begins at row n * page_rows. */
};

/* Orders the glyphs by height and gives each its place, on as few pages as hold them and those no
 * higher than it needs; no glyph lies on two. Fails when FONT_PAGES_MAX pages do not hold them;
 * `list` is the file to be told of. */
struct atlas atlas_pack(struct glyph **glyphs, uint32_t count, const char *list);

void atlas_write(const struct atlas *atlas, struct glyph *const *glyphs, uint32_t count,
                 const char *path);

#endif
