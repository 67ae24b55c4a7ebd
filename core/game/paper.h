/* paper.h -- what a torn paper is still good for. */
#ifndef KINGYO_CORE_GAME_PAPER_H
#define KINGYO_CORE_GAME_PAPER_H

#include "core/poi/sheet.h"

#define PAPER_LEFT_MIN 0.35f /* Less area than this is a fringe along the ring. */

/* Whether a fish could still lie on it: enough area, and a whole patch somewhere (patch.h). A
 * partly torn poi may be played on, so a hole alone, were it in the very middle, ends no round. */
int paper_can_hold(const struct sheet *sheet);

#endif
