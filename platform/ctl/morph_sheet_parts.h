/* morph_sheet_parts.h -- functions that the contact sheet and the frames share. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_SHEET_PARTS_H
#define KINGYO_PLATFORM_CTL_MORPH_SHEET_PARTS_H

#include "platform/ctl/canvas.h"
#include "platform/ctl/morph_pick.h"
#include "platform/ctl/portrait.h"

/* Colour of the water, dark enough to show glass larvae and light enough to show black eels. */
#define MORPH_SHEET_WATER_ABOVE 0xa7c4cbu
#define MORPH_SHEET_WATER_BELOW 0x6d94a1u

/* Computes the bounds of the fish in each view over its whole life. `portrait` is a scratch
 * object. */
void morph_sheet_measure(struct fish_preview *portrait, const struct morph_options *pick,
                         struct fish_preview_bounds bounds[VIEW_COUNT]);

/* Writes the canvas to a PNG file. Returns EXIT_OK, or prints one line to standard error and
 * returns EXIT_IO. */
enum exit_code morph_sheet_write_picture(const struct canvas *canvas, const char *path);

/* Prints that memory allocation failed, and returns EXIT_IO. */
enum exit_code morph_sheet_no_memory(void);

static inline float morph_sheet_middle(float a, float b)
{
    return 0.5f * (a + b);
}

#endif
