/* morph_sheet_parts.h -- what the sheet and the frames share. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_SHEET_PARTS_H
#define KINGYO_PLATFORM_CTL_MORPH_SHEET_PARTS_H

#include "platform/ctl/canvas.h"
#include "platform/ctl/morph_pick.h"
#include "platform/ctl/portrait.h"

#define SHEET_WATER_ABOVE 0xa7c4cbu /* Dark enough for glass larvae, light enough for black eels. */
#define SHEET_WATER_BELOW 0x6d94a1u

/* How far the fish reaches in each view in all of its life. `portrait` is scratch. */
void sheet_measure(struct portrait *portrait, const struct morph_pick *pick,
                   struct portrait_bounds bounds[VIEW_COUNT]);

/* EXIT_OK, or EXIT_IO, told. */
enum exit_code sheet_write(const struct canvas *canvas, const char *path);

/* EXIT_IO, told. */
enum exit_code sheet_no_memory(void);

static inline float sheet_middle(float a, float b)
{
    return 0.5f * (a + b);
}

#endif
