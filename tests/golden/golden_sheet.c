/* golden_sheet.c -- implementation of golden_sheet.h. */
#include "tests/golden/golden_sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

static int sheet_width(const struct golden_sheet *sheet)
{
    return sheet->tile_width * (int)sheet->columns;
}

static int sheet_height(const struct golden_sheet *sheet)
{
    return sheet->tile_height * (int)((sheet->count + sheet->columns - 1u) / sheet->columns);
}

/* Returns the offset of the pixel (x, y) of tile number `tile`. */
static size_t pixel_at(const struct golden_sheet *sheet, uint32_t tile, int x, int y)
{
    const size_t left = (size_t)(tile % sheet->columns) * (size_t)sheet->tile_width + (size_t)x;
    const size_t top = (size_t)(tile / sheet->columns) * (size_t)sheet->tile_height + (size_t)y;
    return 3u * (top * (size_t)sheet_width(sheet) + left);
}

int golden_sheet_open(struct golden_sheet *sheet, int tile_width, int tile_height, uint32_t columns)
{
    memset(sheet, 0, sizeof *sheet);
    sheet->tile_width = tile_width;
    sheet->tile_height = tile_height;
    sheet->columns = columns;
    sheet->pixels = calloc(GOLDEN_TILES_MAX + columns, (size_t)(tile_width * tile_height) * 3u);
    return sheet->pixels != NULL;
}

void golden_sheet_close(struct golden_sheet *sheet)
{
    free(sheet->pixels);
    memset(sheet, 0, sizeof *sheet);
}

/* Returns the mean of one colour value in the part of the picture that a tile pixel covers. */
static uint8_t mean_of(const struct golden_sheet *sheet, const uint8_t *rgba, const int size[2],
                       const int at[3])
{
    const int left = at[0] * size[0] / sheet->tile_width;
    const int right = (at[0] + 1) * size[0] / sheet->tile_width;
    const int top = at[1] * size[1] / sheet->tile_height;
    const int bottom = (at[1] + 1) * size[1] / sheet->tile_height;
    uint32_t sum = 0;
    for (int y = top; y < bottom; y++) {
        for (int x = left; x < right; x++) {
            sum += rgba[4 * ((size[1] - 1 - y) * size[0] + x) + at[2]];
        }
    }
    const uint32_t count = (uint32_t)((right - left) * (bottom - top));
    return (uint8_t)(count > 0 ? (sum + count / 2u) / count : 0u);
}

void golden_sheet_add(struct golden_sheet *sheet, const char *name, const uint8_t *rgba, int width,
                      int height)
{
    if (sheet->count == GOLDEN_TILES_MAX) {
        return;
    }
    const uint32_t tile = sheet->count++;
    const int size[2] = { width, height };
    snprintf(sheet->names[tile], GOLDEN_NAME_SIZE, "%s", name);
    for (int y = 0; y < sheet->tile_height; y++) {
        for (int x = 0; x < sheet->tile_width; x++) {
            for (int channel = 0; channel < 3; channel++) {
                sheet->pixels[pixel_at(sheet, tile, x, y) + (size_t)channel] =
                    mean_of(sheet, rgba, size, (const int[3]){ x, y, channel });
            }
        }
    }
}

int golden_sheet_write(const struct golden_sheet *sheet, const char *path)
{
    stbi_flip_vertically_on_write(0);
    return stbi_write_png(path, sheet_width(sheet), sheet_height(sheet), 3, sheet->pixels,
                          3 * sheet_width(sheet));
}

int golden_sheet_write_stack(const struct golden_sheet *sheets, uint32_t count, const char *path)
{
    int width = 0, height = 0, top = 0;
    for (uint32_t i = 0; i < count; i++) {
        width = sheet_width(&sheets[i]) > width ? sheet_width(&sheets[i]) : width;
        height += sheet_height(&sheets[i]);
    }
    uint8_t *const stack = calloc((size_t)height, 3u * (size_t)width);
    for (uint32_t i = 0; stack != NULL && i < count; i++) {
        const size_t row = 3u * (size_t)sheet_width(&sheets[i]);
        for (int y = 0; y < sheet_height(&sheets[i]); y++) {
            memcpy(stack + 3u * (size_t)width * (size_t)(top + y),
                   sheets[i].pixels + row * (size_t)y, row);
        }
        top += sheet_height(&sheets[i]);
    }
    stbi_flip_vertically_on_write(0);
    const int written = stack != NULL && stbi_write_png(path, width, height, 3, stack, 3 * width);
    free(stack);
    return written;
}

/* Largest differences of all tiles of a sheet. */
struct difference {
    double mean;
    int peak;
};

/* Returns 1 if a tile differs from the golden tile by more than the tolerance, and prints it.
 * Raises `largest` to the differences of the tile. */
static int tile_differs(const struct golden_sheet *sheet, uint32_t tile, const uint8_t *golden,
                        struct difference *largest)
{
    double sum = 0.0;
    int peak = 0;
    for (int y = 0; y < sheet->tile_height; y++) {
        const size_t row = pixel_at(sheet, tile, 0, y);
        for (size_t i = 0; i < 3u * (size_t)sheet->tile_width; i++) {
            const int difference = abs(sheet->pixels[row + i] - golden[row + i]);
            sum += difference;
            peak = difference > peak ? difference : peak;
        }
    }
    const double mean = sum / (3.0 * sheet->tile_width * sheet->tile_height);
    largest->mean = mean > largest->mean ? mean : largest->mean;
    largest->peak = peak > largest->peak ? peak : largest->peak;
    if (mean <= GOLDEN_MEAN_MAX && peak <= GOLDEN_PEAK_MAX) {
        return 0;
    }
    printf("  differs: %-20s mean %.2f, largest %d\n", sheet->names[tile], mean, peak);
    return 1;
}

int golden_sheet_compare(const struct golden_sheet *sheet, const char *path)
{
    int width = 0, height = 0, count = 0;
    struct difference largest = { 0 };
    stbi_set_flip_vertically_on_load(0);
    uint8_t *const golden = stbi_load(path, &width, &height, NULL, 3);
    if (golden == NULL || width != sheet_width(sheet) || height != sheet_height(sheet)) {
        printf("  %s: no golden sheet of %d x %d pixels\n", path, sheet_width(sheet),
               sheet_height(sheet));
        stbi_image_free(golden);
        return -1;
    }
    for (uint32_t tile = 0; tile < sheet->count; tile++) {
        count += tile_differs(sheet, tile, golden, &largest);
    }
    printf("%s: %u pictures, %d differ; largest mean %.3f of %.1f, largest peak %d of %d\n", path,
           sheet->count, count, largest.mean, GOLDEN_MEAN_MAX, largest.peak, GOLDEN_PEAK_MAX);
    stbi_image_free(golden);
    return count;
}
