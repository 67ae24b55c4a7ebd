/* contact_sheet.h -- arranges small pictures side by side on a large one, in the caller's pixels.
 * Pure. */
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
    uint8_t *rgb; /* Pixels owned by the caller, contact_sheet_size() bytes. */
    uint32_t width, height;
    uint32_t picture_height; /* Follows from the aspect ratio of the pictures. */
};

/* Computes the size of a sheet of `width` x `height` pictures. Fills all fields except `rgb`, and
 * returns the bytes that `rgb` needs. */
size_t contact_sheet_plan(struct contact_sheet *sheet, uint32_t width, uint32_t height);

/* Fills the sheet with its dark blue background. */
void contact_sheet_clear(struct contact_sheet *sheet);

/* Scales a picture down by averaging and writes it to position `index` < SHEET_PICTURES, row by
 * row. */
void contact_sheet_put(struct contact_sheet *sheet, uint32_t index, const uint8_t *rgb,
                       uint32_t width, uint32_t height);

#endif
