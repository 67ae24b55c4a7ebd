/* morph_sheet_internal.c -- measures the bounds of a fish over its life, writes PNG files and
 * prints their errors. */
#include "platform/ctl/morph/morph_sheet_internal.h"

#include <errno.h>
#include <string.h>

#define MEASURE_STEPS 20u /* Number of steps over the life at which the bounds are measured. */

static const char command[] = "export";

enum exit_code morph_sheet_no_memory(void)
{
    return morph_fail(EXIT_IO, command, "%s", strerror(ENOMEM));
}

enum exit_code morph_sheet_write_picture(const struct canvas *canvas, const char *path)
{
    const int error = canvas_write_png(canvas, path);
    return error ? morph_fail(EXIT_IO, command, "%.900s: %s", path, strerror(-error)) : EXIT_OK;
}

void morph_sheet_measure(struct fish_preview *portrait, const struct morph_options *pick,
                         struct fish_preview_bounds bounds[VIEW_COUNT])
{
    for (uint32_t view = 0; view < VIEW_COUNT; view++) {
        bounds[view] = fish_preview_nowhere;
    }
    for (uint32_t i = 0; i <= MEASURE_STEPS; i++) {
        fish_preview_pose(portrait, pick->fish, &pick->rig, (float)i / (float)MEASURE_STEPS);
        for (uint32_t view = 0; view < VIEW_COUNT; view++) {
            fish_preview_measure(portrait, (enum fish_preview_view)view, &bounds[view]);
        }
    }
}
