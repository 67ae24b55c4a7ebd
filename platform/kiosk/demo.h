/* demo.h -- runs the demonstration: the core's bot plays one round without a screen, on a simulated
 * clock. The demonstration writes pictures of the round, each in its own file and all on one
 * contact sheet. The first picture is taken when the pois (paper scoops) are over the water. The
 * time from the press of START to the first picture is simulated without pictures. Equal options
 * give identical games. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "platform/kiosk/run_common.h"

/* Default seed of the random number generator, so that two users see the same demonstration. */
#define DEMO_SEED 2013u

/* Runs the demonstration. Returns an exit code. Reports all errors before it returns. */
enum exit_code demo_run(struct run_common *session);

/* ---- Contact sheet ------------------------------------------------------------------------- */

/* Arranges small pictures in rows on one large picture, the contact sheet. The caller owns the
 * pixels. Pure functions. */

#define SHEET_COLUMNS 4u
#define SHEET_ROWS 3u
#define SHEET_PICTURES (SHEET_COLUMNS * SHEET_ROWS)
#define SHEET_PICTURE_WIDTH 480u
#define SHEET_MARGIN 16u

struct contact_sheet {
    /* Pixels of the sheet, owned by the caller. demo_sheet_plan() returns the size in bytes. */
    uint8_t *rgb;
    uint32_t width, height;
    /* Height of one small picture in pixels, computed from the aspect ratio of the source
     * pictures. */
    uint32_t picture_height;
};

/* Computes the size of a sheet for pictures of `width` x `height` pixels. Sets all fields except
 * `rgb`. Returns the number of bytes that `rgb` needs. */
size_t demo_sheet_plan(struct contact_sheet *sheet, uint32_t width, uint32_t height);

/* Fills the sheet with the dark blue background colour. */
void demo_sheet_clear(struct contact_sheet *sheet);

/* Scales a picture down by averaging and writes the result to position `index` of the sheet.
 * Positions count row by row from the top left; `index` must be less than SHEET_PICTURES. */
void demo_sheet_put(struct contact_sheet *sheet, uint32_t index, const uint8_t *rgb, uint32_t width,
                    uint32_t height);
