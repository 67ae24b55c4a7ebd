/* morph_sheet.h -- writes PNG pictures of a growing fish: a contact sheet of the whole life, or a
 * numbered sequence of frames. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SHEET_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SHEET_H

#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_options.h"

/* Number of stages that the contact sheet shows between two keys (modelled growth stages). */
#define MORPH_SHEET_BETWEEN 9u
#define FRAME_WIDTH 1280u
#define FRAME_HEIGHT 720u

/* Writes the contact sheet to one PNG file. The sheet shows every key, and nine stages between each
 * two keys, in three views. Below each stage are its age, its length and a scale bar. Returns
 * EXIT_OK, or prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_sheet_write(const struct morph_options *pick, const char *path);

/* Writes `count` frames as DIR/ID_0000.png, DIR/ID_0001.png and so on, at equal steps of progress.
 * `count` must be at least 2. The fish has the same drawn length in each frame. If the folder does
 * not exist, it is created. Returns EXIT_OK, or prints one line to standard error and returns
 * EXIT_IO. */
enum exit_code morph_frames_write(const struct morph_options *pick, enum fish_preview_view view,
                                  uint32_t count, const char *folder);

#endif
