/* tear.h -- analyses the holes in a sheet of paper: tips of tears, and paper that is loose.
 *
 * struct tear_map stores one bit for each cell and one 32-bit word for each row; bit 0 is the
 * leftmost column. A shift of a word therefore gives the neighbouring cells. The map is computed
 * from the states of the cells in each tick. */
#ifndef KINGYO_CORE_POI_PAPER_TEAR_H
#define KINGYO_CORE_POI_PAPER_TEAR_H

#include "core/poi/paper/sheet.h"

_Static_assert(SHEET_SIDE == 32u, "a row is a word");

/* Factor by which the stress is higher beside a hole of one cell. The factor increases with the
 * square root of the hole's length. */
#define TEAR_FACTOR 2.5f
/* Upper limit of the stress factor, reached beside a hole that is 2.56 cells long. */
#define TEAR_FACTOR_MAX 4.0f
/* Fraction by which the stress factor is higher along the fibres and lower across the fibres. */
#define TEAR_FIBRE_SHARE 0.08f
#define TEAR_FACTOR_WORST (TEAR_FACTOR_MAX * (1.0f + TEAR_FIBRE_SHARE))
/* Number of rows above and below a changed hole in which the stress factor can change. */
#define TEAR_REACH 3u

struct tear_map {
    uint32_t paper[SHEET_SIDE];
    uint32_t hole[SHEET_SIDE];
    uint32_t pair[SHEET_SIDE]; /* Hole cells that share a side with at least one other hole cell. */
    uint32_t wide[SHEET_SIDE]; /* Hole cells whose hole is long enough for TEAR_FACTOR_MAX: three
                                  hole cells in a straight line, or two that touch at a corner. */
};

struct tear_map tear_map_of(const struct sheet *sheet);

/* Computes `pair` and `wide` from `hole`. */
void tear_measure(struct tear_map *map);

/* Returns the bits of the paper cells in row `row` that touch a hole cell at a side or a corner.
 * `row` must be less than SHEET_SIDE. */
uint32_t tear_front(const struct tear_map *map, uint32_t row);

/* Returns the stress factor of a cell beside a hole, at most TEAR_FACTOR_WORST. Returns 0 if no
 * hole touches the cell.
 *
 * A hole carries no load, and the rim of the hole carries the load instead. As in fracture
 * mechanics, the factor increases with the square root of the hole's length. The length is measured
 * along the longest straight line of hole cells through the adjacent hole cell. The factor is
 * higher if the tear would grow along the fibres. The factor is lower for a diagonal step, because
 * the tear then grows by a longer distance. */
float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column);

/* Removes loose paper once: changes paper cells that carry no load into holes. A paper cell carries
 * load only if straight lines of paper connect it to the ring in two directions that are at least
 * 135 degrees apart. A removal can make more paper loose, and therefore the caller repeats the call
 * until the result is 0. Returns the number of removed cells. */
uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet);

#endif
