/* tear.h -- the shape of a sheet's holes: tear tips and loose paper.
 *
 * Each cell is one bit and each row one word; bit 0 is the left column. A walk over cells becomes a
 * shift. The map is computed from the states of the cells and has no state of its own. */
#ifndef KINGYO_CORE_POI_PAPER_TEAR_H
#define KINGYO_CORE_POI_PAPER_TEAR_H

#include "core/poi/paper/sheet.h"

_Static_assert(SHEET_SIDE == 32u, "a row is a word");

/* Stress factor beside a hole of one cell; the factor grows with the root of the hole's length. */
#define TEAR_FACTOR 2.5f
#define TEAR_FACTOR_MAX 4.0f /* Limit of the factor, reached at 2.56 cells. */
/* Increase of the factor along the fibres, and decrease across them. */
#define TEAR_FIBRE_SHARE 0.08f
#define TEAR_FACTOR_WORST (TEAR_FACTOR_MAX * (1.0f + TEAR_FIBRE_SHARE))
#define TEAR_REACH 3u /* Rows above and below that a changed hole can affect. */

struct tear_map {
    uint32_t paper[SHEET_SIDE];
    uint32_t hole[SHEET_SIDE];
    uint32_t pair[SHEET_SIDE]; /* Holes at least two cells long in some direction. */
    uint32_t wide[SHEET_SIDE]; /* Holes so long that TEAR_FACTOR_MAX applies. */
};

struct tear_map tear_map_of(const struct sheet *sheet);

/* Updates `pair` and `wide` from `hole`. */
void tear_measure(struct tear_map *map);

/* Returns the paper of a row, < SHEET_SIDE, that a hole touches at a side or a corner. */
uint32_t tear_front(const struct tear_map *map, uint32_t row);

/* Returns the stress factor of a cell due to the holes beside it, <= TEAR_FACTOR_WORST; 0 if there
 * is no hole beside it. The rim of a hole bears what the hole does not. The factor grows with the
 * root of the length, as in fracture mechanics. The length is the longest straight line through the
 * hole at its nearest cell. Growth along the fibres is easiest, and growth over a corner takes
 * longer in proportion to its length. */
float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column);

/* Removes loose paper: a piece cut off, or held from one side, bears nothing and becomes a hole.
 * Paper bears if the ring holds it in straight lines from two sides at least 135 degrees apart. The
 * removal can loosen more paper for the next call. Returns the number of removed cells. */
uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet);

#endif
