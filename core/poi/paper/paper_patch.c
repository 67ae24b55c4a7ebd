/* paper_patch.c -- searches a sheet of paper for an undamaged patch. Up to seventeen patches are
 * tested, each at nine points. */
#include "core/poi/paper/paper_patch.h"

#include "core/base/panic.h"
#include "core/poi/paper/sheet.h"

#define WINDS 8u

/* Eight directions in the plane of the poi, beginning toward the far edge. The table replaces the
 * computation of sines. */
#define DIAGONAL 0.7071f
static const float wind_x[WINDS] = { 0.0f,  DIAGONAL, -DIAGONAL, 1.0f,
                                     -1.0f, DIAGONAL, -DIAGONAL, 0.0f };
static const float wind_z[WINDS] = { -1.0f, -DIAGONAL, -DIAGONAL, 0.0f,
                                     0.0f,  DIAGONAL,  DIAGONAL,  1.0f };

bool paper_patch_find(paper_patch_holds *holds, const void *paper, float radius_m,
                      struct patch *patch)
{
    static const float circles[] = { 0.0f, 0.35f, 0.65f };
    CORE_ASSERT(holds && radius_m > 0.0f);
    for (uint32_t c = 0; c < sizeof circles / sizeof circles[0]; c++) {
        const float r = circles[c] * radius_m;
        for (uint32_t i = 0; i < (c == 0 ? 1u : WINDS); i++) {
            const float x_m = r * wind_x[i], z_m = r * wind_z[i];
            bool whole = holds(paper, x_m, z_m);
            for (uint32_t k = 0; k < WINDS && whole; k++) {
                whole = holds(paper, x_m + PAPER_PATCH_RADIUS_M * wind_x[k],
                              z_m + PAPER_PATCH_RADIUS_M * wind_z[k]);
            }
            if (whole) {
                *patch = (struct patch){ c == 0, x_m, z_m };
                return true;
            }
        }
    }
    return false;
}

static bool paper_holds_point(const void *paper, float x_m, float z_m)
{
    return sheet_holds(paper, x_m, z_m);
}

bool paper_can_hold(const struct sheet *sheet)
{
    CORE_ASSERT(sheet->radius_m > 0.0f);
    struct patch patch;
    return sheet_left(sheet) >= PAPER_LEFT_MIN &&
           paper_patch_find(paper_holds_point, sheet, sheet->radius_m, &patch);
}
