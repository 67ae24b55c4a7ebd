/* tear.h -- the shape of a sheet's holes: where tears have their tips, and what hangs loose.
 *
 * One bit a cell, a word a row, bit 0 the left column: what takes a walk over cells otherwise is a
 * shift here. Made from the cells' states where it is needed; no state of its own. */
#ifndef KINGYO_CORE_POI_TEAR_H
#define KINGYO_CORE_POI_TEAR_H

#include "core/poi/sheet.h"

_Static_assert(SHEET_SIDE == 32u, "a row is a word");

#define TEAR_FACTOR 2.5f       /* Stress beside a hole of one cell; with the root of its length, */
#define TEAR_FACTOR_MAX 4.0f   /* up to here, at 2.56 cells; */
#define TEAR_FIBRE_SHARE 0.08f /* so much more along the fibres, so much less across them. */
#define TEAR_FACTOR_WORST (TEAR_FACTOR_MAX * (1.0f + TEAR_FIBRE_SHARE))
#define TEAR_REACH 3u /* Rows that a change of a hole can matter to, up and down. */

struct tear_map {
    uint32_t paper[SHEET_SIDE];
    uint32_t hole[SHEET_SIDE];
    uint32_t pair[SHEET_SIDE]; /* Holes that are two cells long, some way, ... */
    uint32_t wide[SHEET_SIDE]; /* ... and those so long that TEAR_FACTOR_MAX rules. */
};

struct tear_map tear_map_of(const struct sheet *sheet);

/* Brings `pair` and `wide` up to what `hole` is. */
void tear_measure(struct tear_map *map);

/* The paper of a row, < SHEET_SIDE, that a hole touches by a side or a corner. */
uint32_t tear_front(const struct tear_map *map, uint32_t row);

/* How far the holes beside a cell raise its stress, <= TEAR_FACTOR_WORST; 0: no hole is beside it.
 * What a hole does not bear its rim must: as fracture mechanics has it, with the root of the
 * length, here the longest straight way through the hole at its nearest cell. A step along the
 * fibres is the easiest, one over a corner takes as much longer as it is longer. */
float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column);

/* Paper that is cut off, or hangs by one side, bears nothing and swings out of the way: it is a
 * hole from now on. It bears if the ring holds it straight on from two sides, at least 135 degrees
 * apart. What falls can make more hang loose, for the next call. Returns how many cells went. */
uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet);

#endif
