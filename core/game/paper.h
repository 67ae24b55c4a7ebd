/* paper.h -- what a torn paper is still good for. */
#ifndef KINGYO_CORE_GAME_PAPER_H
#define KINGYO_CORE_GAME_PAPER_H

#include "core/poi/sheet.h"

#define PAPER_LEFT_MIN 0.35f        /* Less area than this is a fringe along the ring. */
#define PAPER_PATCH_RADIUS_M 0.010f /* What the smallest fish of a stall needs under its body. */

/* A spot of the poi's plane with a whole round patch of paper about it, as near the middle as there
 * is one; `x_m` and `z_m` stay as they were where there is none. Returns whether there is. */
int paper_spot(const struct sheet *sheet, float *x_m, float *z_m);

/* Whether a fish could still lie on it: enough area, and a spot. A partly torn poi may be played
 * on, so a hole alone, were it in the very middle, ends no round. */
int paper_can_hold(const struct sheet *sheet);

#endif
