/* tear.h -- the shape of a sheet's holes: where tears have their tips, and what hangs loose.
 *
 * One bit a cell, a word a row, bit 0 the left column: what takes a walk over cells otherwise is a
 * shift here. Made from the cells' states where it is needed; no state of its own. */
#ifndef KINGYO_CORE_POI_TEAR_H
#define KINGYO_CORE_POI_TEAR_H

#include "core/poi/sheet.h"

_Static_assert(SHEET_SIDE == 32u, "a row is a word");

#define TEAR_FACTOR 2.5f       /* Stress before a tear of one cell; with the root of its length, */
#define TEAR_FACTOR_MAX 4.0f   /* up to here; */
#define TEAR_RUN_MAX 3u        /* that is, to this length in cells; */
#define TEAR_FIBRE_SHARE 0.12f /* so much more along the fibres, so much less across them. */
#define TEAR_FACTOR_WORST (TEAR_FACTOR_MAX * (1.0f + TEAR_FIBRE_SHARE))

struct tear_map {
    uint32_t paper[SHEET_SIDE];
    uint32_t hole[SHEET_SIDE];
};

struct tear_map tear_map_of(const struct sheet *sheet);

/* The paper of a row, < SHEET_SIDE, that a hole touches by a side or a corner. */
uint32_t tear_front(const struct tear_map *map, uint32_t row);

/* How far the holes beside a cell raise its stress, <= TEAR_FACTOR_WORST; 0: no hole is beside it.
 * As fracture mechanics has it, with the root of a tear's length, seen from the cell along each of
 * eight ways: before the end of a slit it is larger than on its flank. */
float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column);

/* Paper that is cut off, or hangs by one side, bears nothing and swings out of the way: it is a
 * hole from now on. It bears if the ring holds it straight on from two sides, at least 135 degrees
 * apart. Returns how many cells went. */
uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet);

#endif
