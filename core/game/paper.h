/* paper.h -- when a torn paper is of no use any more. */
#ifndef KINGYO_CORE_GAME_PAPER_H
#define KINGYO_CORE_GAME_PAPER_H

#include "core/poi/sheet.h"

#define PAPER_LEFT_MIN 0.35f          /* Less area than this is a fringe along the ring. */
#define PAPER_PATCH_RADIUS_M 0.010f   /* What the smallest fish of a stall needs under its body. */

/* Whether a fish could still lie on it: enough area, and one whole round patch of paper somewhere.
 * A partly torn poi may be played on (facts of the sport), so a hole alone does not end a round. */
int paper_can_hold(const struct sheet *sheet);

#endif
