/* paper_patch.c -- tests nine points in each patch, and up to seventeen patches in each sheet. */
#include "core/game/bot/paper_patch.h"

#define WINDS 8u

/* Eight directions, beginning at the far edge, as constants, so that no sine needs to be
 * computed. */
#define DIAGONAL 0.7071f
static const float wind_x[WINDS] = { 0.0f,  DIAGONAL, -DIAGONAL, 1.0f,
                                     -1.0f, DIAGONAL, -DIAGONAL, 0.0f };
static const float wind_z[WINDS] = { -1.0f, -DIAGONAL, -DIAGONAL, 0.0f,
                                     0.0f,  DIAGONAL,  DIAGONAL,  1.0f };

static int patch_is_whole(paper_patch_holds *holds, const void *paper, float x_m, float z_m)
{
    int whole = holds(paper, x_m, z_m);
    for (uint32_t i = 0; i < WINDS && whole; i++) {
        whole = holds(paper, x_m + PAPER_PATCH_RADIUS_M * wind_x[i],
                      z_m + PAPER_PATCH_RADIUS_M * wind_z[i]);
    }
    return whole;
}

int paper_patch_find(paper_patch_holds *holds, const void *paper, float radius_m,
                     struct patch *patch)
{
    static const float circles[] = { 0.0f, 0.35f, 0.65f };
    for (uint32_t c = 0; c < sizeof circles / sizeof circles[0]; c++) {
        const float r = circles[c] * radius_m;
        for (uint32_t i = 0; i < (c == 0 ? 1u : WINDS); i++) {
            if (patch_is_whole(holds, paper, r * wind_x[i], r * wind_z[i])) {
                *patch = (struct patch){ c == 0, r * wind_x[i], r * wind_z[i] };
                return 1;
            }
        }
    }
    return 0;
}
