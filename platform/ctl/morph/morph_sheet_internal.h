/* morph_sheet_internal.h -- constants and functions that morph_sheet.c and morph_frames.c share. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SHEET_INTERNAL_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SHEET_INTERNAL_H

#include "platform/ctl/lib/canvas.h"
#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_options.h"

/* Background colours at the top and at the bottom of a picture. The colours are dark enough to show
 * transparent larvae and light enough to show black eels. */
#define MORPH_SHEET_WATER_ABOVE 0xa7c4cbu
#define MORPH_SHEET_WATER_BELOW 0x6d94a1u

/* Computes the bounds of the fish in each view over its whole life. `portrait` is used as scratch
 * memory. */
void morph_sheet_measure(struct fish_preview *portrait, const struct morph_options *pick,
                         struct fish_preview_bounds bounds[VIEW_COUNT]);

/* Writes the canvas to the PNG file `path`. Returns EXIT_OK, or prints one line to standard error
 * and returns EXIT_IO. */
enum exit_code morph_sheet_write_picture(const struct canvas *canvas, const char *path);

/* Prints that memory allocation failed, and returns EXIT_IO. */
enum exit_code morph_sheet_no_memory(void);

static inline float morph_sheet_middle(float a, float b)
{
    return 0.5f * (a + b);
}

#endif
