/* contact_sheet.h -- small pictures side by side on a large one, in the caller's pixels. Pure. */
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
    uint8_t *rgb;                 /* The caller's, contact_sheet_size() bytes. */
    uint32_t width, height;
    uint32_t picture_height;      /* Follows from the pictures' shape. */
};

/* How large a sheet of `width` x `height` pictures is. Fills all but `rgb`; returns the bytes it
 * needs. */
size_t contact_sheet_plan(struct contact_sheet *sheet, uint32_t width, uint32_t height);

/* Lays out the empty sheet in the colour of a summer night. */
void contact_sheet_clear(struct contact_sheet *sheet);

/* Puts a picture, averaged down, into place `index` < SHEET_PICTURES, row by row. */
void contact_sheet_put(struct contact_sheet *sheet, uint32_t index, const uint8_t *rgb,
                       uint32_t width, uint32_t height);

#endif
