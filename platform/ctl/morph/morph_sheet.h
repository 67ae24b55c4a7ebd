/* morph_sheet.h -- pictures of a growing fish: the contact sheet, and one picture for each
 * frame. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SHEET_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SHEET_H

#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_options.h"

#define MORPH_SHEET_BETWEEN 9u /* Number of stages between two keys. */
#define FRAME_WIDTH 1280u
#define FRAME_HEIGHT 720u

/* Writes one PNG file. The sheet shows every key, and nine stages from each key to the next, in
 * three views. Each stage has its age, its length and a bar of true size. Returns EXIT_OK, or
 * prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_sheet_write(const struct morph_options *pick, const char *path);

/* Writes `count` >= 2 pictures DIR/ID_0000.png and so on, at equal steps of progress. The fish has
 * the same length in each picture. A missing folder is created. Returns EXIT_OK, or prints one line
 * to standard error and returns EXIT_IO. */
enum exit_code morph_frames_write(const struct morph_options *pick, enum fish_preview_view view,
                                  uint32_t count, const char *folder);

#endif
