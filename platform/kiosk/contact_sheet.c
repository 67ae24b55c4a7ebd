/* contact_sheet.c -- scales pictures down and places them on a contact sheet; see
 * contact_sheet.h. */
#include "platform/kiosk/contact_sheet.h"

size_t contact_sheet_plan(struct contact_sheet *sheet, uint32_t width, uint32_t height)
{
    const uint32_t tall = (uint32_t)((uint64_t)SHEET_PICTURE_WIDTH * height / width);
    sheet->picture_height = tall > 0 ? tall : 1;
    sheet->width = SHEET_COLUMNS * SHEET_PICTURE_WIDTH + (SHEET_COLUMNS + 1) * SHEET_MARGIN;
    sheet->height = SHEET_ROWS * sheet->picture_height + (SHEET_ROWS + 1) * SHEET_MARGIN;
    return (size_t)sheet->width * sheet->height * 3;
}

void contact_sheet_clear(struct contact_sheet *sheet)
{
    static const uint8_t night[3] = { 24, 28, 46 };
    const size_t count = (size_t)sheet->width * sheet->height;
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            sheet->rgb[3 * i + c] = night[c];
        }
    }
}

struct span {
    uint32_t begin, end; /* Range of source pixels that one target pixel covers, at least one
                            pixel. */
};

static struct span span_under(uint32_t index, uint32_t count, uint32_t source)
{
    const uint32_t begin = (uint32_t)((uint64_t)index * source / count);
    const uint32_t end = (uint32_t)((uint64_t)(index + 1) * source / count);
    return (struct span){ begin, end > begin ? end : begin + 1 };
}

static void average(const uint8_t *rgb, uint32_t width, struct span x, struct span y,
                    uint8_t out[3])
{
    uint32_t sum[3] = { 0 };
    const uint32_t count = (x.end - x.begin) * (y.end - y.begin);
    for (uint32_t row = y.begin; row < y.end; row++) {
        const uint8_t *pixel = rgb + ((size_t)row * width + x.begin) * 3;
        for (uint32_t column = x.begin; column < x.end; column++, pixel += 3) {
            for (int c = 0; c < 3; c++) {
                sum[c] += pixel[c];
            }
        }
    }
    for (int c = 0; c < 3; c++) {
        out[c] = (uint8_t)((sum[c] + count / 2) / count);
    }
}

void contact_sheet_put(struct contact_sheet *sheet, uint32_t index, const uint8_t *rgb,
                       uint32_t width, uint32_t height)
{
    const uint32_t left =
        SHEET_MARGIN + index % SHEET_COLUMNS * (SHEET_PICTURE_WIDTH + SHEET_MARGIN);
    const uint32_t top =
        SHEET_MARGIN + index / SHEET_COLUMNS * (sheet->picture_height + SHEET_MARGIN);
    for (uint32_t y = 0; y < sheet->picture_height; y++) {
        uint8_t *out = sheet->rgb + ((size_t)(top + y) * sheet->width + left) * 3;
        const struct span rows = span_under(y, sheet->picture_height, height);
        for (uint32_t x = 0; x < SHEET_PICTURE_WIDTH; x++, out += 3) {
            average(rgb, width, span_under(x, SHEET_PICTURE_WIDTH, width), rows, out);
        }
    }
}
