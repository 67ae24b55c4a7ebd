/* paper.c -- looks for one whole patch of paper, at the centre and on two circles round it. */
#include "core/game/paper.h"

#define WINDS 8u

/* The eight winds, so that no sine is needed. */
#define DIAGONAL 0.70711f
static const float wind_x[WINDS] = { 1.0f,  DIAGONAL,  0.0f, -DIAGONAL,
                                     -1.0f, -DIAGONAL, 0.0f, DIAGONAL };
static const float wind_z[WINDS] = { 0.0f, DIAGONAL,  1.0f,  DIAGONAL,
                                     0.0f, -DIAGONAL, -1.0f, -DIAGONAL };

static int patch_is_whole(const struct sheet *sheet, float x_m, float z_m)
{
    if (!sheet_holds(sheet, x_m, z_m)) {
        return 0;
    }
    for (uint32_t i = 0; i < WINDS; i++) {
        if (!sheet_holds(sheet, x_m + PAPER_PATCH_RADIUS_M * wind_x[i],
                         z_m + PAPER_PATCH_RADIUS_M * wind_z[i])) {
            return 0;
        }
    }
    return 1;
}

int paper_spot(const struct sheet *sheet, float *x_m, float *z_m)
{
    static const float circles[] = { 0.0f, 0.35f, 0.65f };
    for (uint32_t c = 0; c < sizeof circles / sizeof circles[0]; c++) {
        const float radius_m = circles[c] * sheet->radius_m;
        for (uint32_t i = 0; i < WINDS; i++) {
            if (patch_is_whole(sheet, radius_m * wind_x[i], radius_m * wind_z[i])) {
                *x_m = radius_m * wind_x[i];
                *z_m = radius_m * wind_z[i];
                return 1;
            }
        }
    }
    return 0;
}

int paper_can_hold(const struct sheet *sheet)
{
    float x_m = 0.0f;
    float z_m = 0.0f;
    return sheet_left(sheet) >= PAPER_LEFT_MIN && paper_spot(sheet, &x_m, &z_m);
}
