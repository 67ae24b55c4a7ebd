/* fuzz_marks.c -- fuzz target: arbitrary text as a file of landmarks for mesh import. Accepted
 * landmarks are also used to compute the warp of a mesh. */
#include <math.h>
#include <unistd.h>

#include "platform/ctl/import/refit.h"
#include "tests/fuzz/meshes.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct refit_marks list;
    char why[IMPORT_WHY_SIZE];
    const char *path = file_of(bytes, size, ".marks");
    if (refit_marks_read(path, &list, why) == EXIT_OK) {
        vec3 from[REFIT_MARKS_MAX], to[REFIT_MARKS_MAX],
            points[2] = { { 0, 0, 0 }, { 1, -1, 0.5f } };
        for (uint32_t i = 0; i < list.count; i++) {
            from[i] = list.marks[i].place;
            to[i] = v3_scale(list.marks[list.count - 1u - i].place, 0.5f);
        }
        refit_marks_warp(from, to, list.count, points, 2);
        if (!isfinite(points[0].x) || !isfinite(points[1].y)) {
            __builtin_trap();
        }
    }
    unlink(path);
    return 0;
}
