/* golden_sheet.h -- a contact sheet of small pictures, and its comparison with a golden sheet.
 *
 * Each picture is reduced to a tile by the mean of its pixels, so that the small differences
 * between versions of a renderer almost vanish, while a moved or missing text stays visible. */
#ifndef KINGYO_TESTS_GOLDEN_SHEET_H
#define KINGYO_TESTS_GOLDEN_SHEET_H

#include <stdint.h>

#define GOLDEN_TILES_MAX 256u
#define GOLDEN_NAME_SIZE 32u

/* Largest mean difference of the colour values of a tile, and largest difference of one colour
 * value, 0 to 255. Mesa 22.3 of Debian 12 and Mesa 25.0 of Debian 13 differ by at most 0.005 and 2
 * (tests/FIGURES.md). */
#define GOLDEN_MEAN_MAX 0.1
#define GOLDEN_PEAK_MAX 10

struct golden_sheet {
    int tile_width, tile_height;
    uint32_t columns;
    uint32_t count; /* Number of added tiles. */
    char names[GOLDEN_TILES_MAX][GOLDEN_NAME_SIZE];
    uint8_t *pixels; /* RGB rows of the sheet, from the top. Owned by the sheet. */
};

/* Creates an empty sheet with `columns` tiles in a row. The tiles have the given size in pixels.
 * Returns 0 if there is no memory. */
int golden_sheet_open(struct golden_sheet *sheet, int tile_width, int tile_height,
                      uint32_t columns);
void golden_sheet_close(struct golden_sheet *sheet);

/* Reduces a picture of `width` x `height` RGBA pixels, rows from the bottom as OpenGL returns them,
 * to the next tile. A tile beyond GOLDEN_TILES_MAX is not added. */
void golden_sheet_add(struct golden_sheet *sheet, const char *name, const uint8_t *rgba, int width,
                      int height);

/* Writes the sheet as a PNG picture. Returns 0 if the file cannot be written. */
int golden_sheet_write(const struct golden_sheet *sheet, const char *path);

/* Writes `count` sheets one below the other as one PNG picture, which is as wide as the widest
 * sheet. Returns 0 if there is no memory or if the file cannot be written. */
int golden_sheet_write_stack(const struct golden_sheet *sheets, uint32_t count, const char *path);

/* Compares the sheet with the golden sheet in the file `path`. Prints the name of each tile that
 * differs, and the largest difference. Returns the number of tiles that differ, or -1 if the file
 * is absent or has another size. */
int golden_sheet_compare(const struct golden_sheet *sheet, const char *path);

#endif
