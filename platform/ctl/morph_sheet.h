/* morph_sheet.h -- pictures of a growing fish: the contact sheet, and one picture a frame. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_SHEET_H
#define KINGYO_PLATFORM_CTL_MORPH_SHEET_H

#include "platform/ctl/morph_pick.h"
#include "platform/ctl/portrait.h"

#define SHEET_BETWEEN 9u /* In-betweens from each key to the next. */
#define FRAME_WIDTH 1280u
#define FRAME_HEIGHT 720u

/* Every key in three views, then nine in-betweens to the next key in three views, each with age,
 * length and a bar of true size: one PNG. EXIT_OK, or EXIT_IO, told. */
enum exit_code morph_sheet_write(const struct morph_pick *pick, const char *path);

/* `count` >= 2 pictures DIR/ID_0000.png .. at even steps of progress, the fish as large in each.
 * The folder is made where it is missing. EXIT_OK, or EXIT_IO, told. */
enum exit_code morph_frames_write(const struct morph_pick *pick, enum portrait_view view,
                                  uint32_t count, const char *folder);

#endif
