/* atlas.c -- implementation of atlas.h. */
#include "assets/bake/atlas.h"

#include <stdlib.h>
#include <string.h>

static int by_height(const void *a, const void *b)
{
    const struct glyph *left = *(struct glyph *const *)a, *right = *(struct glyph *const *)b;
    if (left->height != right->height) {
        return right->height - left->height;
    }
    return left->code < right->code ? -1 : left->code > right->code;
}

/* Places the glyphs from left to right in rows of falling height, so that the first glyph of each
 * row is its highest. Returns the number of pages of `page_rows` rows that the glyphs need. */
static uint32_t lay_out(struct glyph **glyphs, uint32_t count, uint32_t page_rows)
{
    uint32_t x = FONT_ATLAS_WIDTH, y = 0, next_y = 0, page = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t width = (uint32_t)glyphs[i]->width, height = (uint32_t)glyphs[i]->height;
        if (x + width > FONT_ATLAS_WIDTH) {
            x = 0;
            y = next_y;
            if (y + height > page_rows) {
                y = 0;
                page++;
            }
            next_y = y + height;
        }
        glyphs[i]->x = x;
        glyphs[i]->y = page * page_rows + y;
        x += width;
    }
    return page + 1;
}

struct atlas atlas_pack(struct glyph **glyphs, uint32_t count, const char *list)
{
    qsort(glyphs, count, sizeof *glyphs, by_height);
    struct atlas atlas = { .page_rows = FONT_PAGE_ROWS_MAX };
    atlas.page_count = lay_out(glyphs, count, atlas.page_rows);
    if (atlas.page_count > FONT_PAGES_MAX) {
        bake_fail("%s: %u glyphs fill %u pages of %ux%u texels, and FONT_PAGES_MAX is %u: give a "
                  "font fewer em pixels or fewer keys",
                  list, count, atlas.page_count, FONT_ATLAS_WIDTH, FONT_PAGE_ROWS_MAX,
                  FONT_PAGES_MAX);
    }
    while (lay_out(glyphs, count, atlas.page_rows - 4u) == atlas.page_count) {
        atlas.page_rows -= 4u;
    }
    lay_out(glyphs, count, atlas.page_rows);
    return atlas;
}

void atlas_write(const struct atlas *atlas, struct glyph *const *glyphs, uint32_t count,
                 const char *path)
{
    const size_t size = (size_t)FONT_ATLAS_WIDTH * atlas->page_rows * atlas->page_count;
    uint8_t *texels = bake_alloc(size);
    for (uint32_t i = 0; i < count; i++) {
        const struct glyph *glyph = glyphs[i];
        for (int row = 0; row < glyph->height; row++) {
            memcpy(texels + (size_t)(glyph->y + (uint32_t)row) * FONT_ATLAS_WIDTH + glyph->x,
                   glyph->field + row * glyph->width, (size_t)glyph->width);
        }
    }
    bake_write(path, texels, size);
    free(texels);
}
