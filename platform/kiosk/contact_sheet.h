/* contact_sheet.h -- arranges small pictures in rows on one large picture, the contact sheet. The
 * caller owns the pixels. Pure functions. */
#ifndef KINGYO_PLATFORM_KIOSK_CONTACT_SHEET_H
#define KINGYO_PLATFORM_KIOSK_CONTACT_SHEET_H

#include <stddef.h>
#include <stdint.h>

#define SHEET_COLUMNS 4u
#define SHEET_ROWS 3u
#define SHEET_PICTURES (SHEET_COLUMNS * SHEET_ROWS)
#define SHEET_PICTURE_WIDTH 480u
#define SHEET_MARGIN 16u

struct contact_sheet {
    uint8_t *rgb; /* Pixels of the sheet, owned by the caller. contact_sheet_plan() returns the size
                     in bytes. */
    uint32_t width, height;
    uint32_t picture_height; /* Height of one small picture in pixels, computed from the aspect
                                ratio of the source pictures. */
};

/* Computes the size of a sheet for pictures of `width` x `height` pixels. Sets all fields except
 * `rgb`. Returns the number of bytes that `rgb` needs. */
size_t contact_sheet_plan(struct contact_sheet *sheet, uint32_t width, uint32_t height);

/* Fills the sheet with the dark blue background colour. */
void contact_sheet_clear(struct contact_sheet *sheet);

/* Scales a picture down by averaging and writes it to position `index` of the sheet. Positions
 * count row by row from the top left; `index` must be less than SHEET_PICTURES. */
void contact_sheet_put(struct contact_sheet *sheet, uint32_t index, const uint8_t *rgb,
                       uint32_t width, uint32_t height);

#endif
