/* paper.c -- tests whether paper is usable. */
#include "core/game/paper.h"

#include "core/game/bot/paper_patch.h"

static int holds(const void *paper, float x_m, float z_m)
{
    return sheet_holds(paper, x_m, z_m);
}

int paper_can_hold(const struct sheet *sheet)
{
    struct patch patch;
    return sheet_left(sheet) >= PAPER_LEFT_MIN &&
           paper_patch_find(holds, sheet, sheet->radius_m, &patch);
}
