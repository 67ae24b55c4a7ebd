/* paper.c -- looks for one whole patch of paper, at the centre and on two circles round it. */
#include "core/game/paper.h"

#define PATCH_POINTS 8u

/* The eight winds, so that no sine is needed. */
static const float wind_x[PATCH_POINTS] = { 1.0f, 0.70711f, 0.0f, -0.70711f, -1.0f, -0.70711f, 0.0f, 0.70711f };
static const float wind_z[PATCH_POINTS] = { 0.0f, 0.70711f, 1.0f, 0.70711f, 0.0f, -0.70711f, -1.0f, -0.70711f };

static int patch_is_whole(const struct sheet *sheet, float x_m, float z_m)
{
    if (!sheet_holds(sheet, x_m, z_m)) {
        return 0;
    }
    for (uint32_t i = 0; i < PATCH_POINTS; i++) {
        if (!sheet_holds(sheet, x_m + PAPER_PATCH_RADIUS_M * wind_x[i],
                         z_m + PAPER_PATCH_RADIUS_M * wind_z[i])) {
            return 0;
        }
    }
    return 1;
}

static int ring_has_patch(const struct sheet *sheet, float radius_m)
{
    for (uint32_t i = 0; i < PATCH_POINTS; i++) {
        if (patch_is_whole(sheet, radius_m * wind_x[i], radius_m * wind_z[i])) {
            return 1;
        }
    }
    return 0;
}

int paper_can_hold(const struct sheet *sheet)
{
    if (sheet_left(sheet) < PAPER_LEFT_MIN) {
        return 0;
    }
    return patch_is_whole(sheet, 0.0f, 0.0f) || ring_has_patch(sheet, 0.35f * sheet->radius_m) ||
           ring_has_patch(sheet, 0.65f * sheet->radius_m);
}
