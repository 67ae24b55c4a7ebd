/* paper.h -- decides whether torn paper is still usable. */
#ifndef KINGYO_CORE_GAME_PAPER_H
#define KINGYO_CORE_GAME_PAPER_H

#include "core/poi/paper/sheet.h"

/* Smallest usable share of the paper area. A smaller remainder is only a fringe along the ring. */
#define PAPER_LEFT_MIN 0.35f

/* Returns 1 if a fish could lie on the paper: enough area is left, and an undamaged patch exists
 * (paper_patch.h). A hole alone, even in the middle, does not end a round, because a partly torn
 * poi may be used. */
int paper_can_hold(const struct sheet *sheet);

#endif
