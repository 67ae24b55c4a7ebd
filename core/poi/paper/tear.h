/* tear.h -- the shape of the holes in a sheet of paper: tips of tears and loose paper.
 *
 * A tear_map holds one bit for each cell and one word for each row; bit 0 is the left column.
 * Operations on neighbouring cells are therefore shifts. The map is computed from the states of the
 * cells in each tick. */
#ifndef KINGYO_CORE_POI_PAPER_TEAR_H
#define KINGYO_CORE_POI_PAPER_TEAR_H

#include "core/poi/paper/sheet.h"

_Static_assert(SHEET_SIDE == 32u, "a row is a word");

/* Stress factor beside a hole of one cell. The factor grows with the square root of the hole's
 * length. */
#define TEAR_FACTOR 2.5f
#define TEAR_FACTOR_MAX 4.0f /* Limit of the stress factor, reached at a length of 2.56 cells. */
/* Share by which the stress factor rises along the fibres and falls across the fibres. */
#define TEAR_FIBRE_SHARE 0.08f
#define TEAR_FACTOR_WORST (TEAR_FACTOR_MAX * (1.0f + TEAR_FIBRE_SHARE))
/* Number of rows above and below a changed hole in which stress factors can change. */
#define TEAR_REACH 3u

struct tear_map {
    uint32_t paper[SHEET_SIDE];
    uint32_t hole[SHEET_SIDE];
    uint32_t pair[SHEET_SIDE]; /* Cells of holes that are at least two cells long in some
                                  direction. */
    uint32_t wide[SHEET_SIDE]; /* Cells of holes that are long enough for TEAR_FACTOR_MAX. */
};

struct tear_map tear_map_of(const struct sheet *sheet);

/* Updates `pair` and `wide` from `hole`. */
void tear_measure(struct tear_map *map);

/* Returns the bits of the paper cells in a row that touch a hole at a side or a corner. `row` must
 * be less than SHEET_SIDE. */
uint32_t tear_front(const struct tear_map *map, uint32_t row);

/* Returns the stress factor of a cell due to adjacent holes, at most TEAR_FACTOR_WORST. Returns 0
 * if no hole is adjacent. The rim of a hole carries the load that the hole does not carry. The
 * factor grows with the square root of the hole's length, as in fracture mechanics. The length is
 * measured on the longest straight line through the nearest cell of the hole. Tears grow most
 * easily along the fibres. A step over a corner takes longer in proportion to its length. */
float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column);

/* Removes loose paper once: turns paper that carries no load into holes. Paper carries load only if
 * the ring holds it along straight lines from two sides that are at least 135 degrees apart. The
 * removal can loosen more paper, so that the caller repeats the call. Returns the number of removed
 * cells. */
uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet);

#endif
