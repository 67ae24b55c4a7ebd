/* narrow_phase_simd.h -- the inner loops of the pair search, compiled for four lanes and for eight
 * lanes.
 *
 * Only narrow_phase.c calls these functions. The lists that SIMD code reads have SIMD_LANES_MAX
 * extra entries with valid values. */
#ifndef KINGYO_CORE_TANK_COLLISION_NARROW_PHASE_SIMD_H
#define KINGYO_CORE_TANK_COLLISION_NARROW_PHASE_SIMD_H

#include "core/tank/collision/narrow_phase.h"

/* Number of items or pairs by which prefetching precedes the computation. The number covers the
 * latency of memory. */
#define NARROW_PHASE_PREFETCH (2u * SIMD_LANES)

/* Writes the horizontal positions of `count` > 0 members to narrow_phase->x_m and z_m. Returns the
 * largest value of `ball_m` (struct narrow_phase) among the members. */
#define NARROW_PHASE_MEASURE(name)                                                                 \
    float name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,             \
               const fish_index *member, uint32_t count)

/* Computes the cell of each of the `count` members from the positions in narrow_phase->x_m and
 * z_m. */
#define NARROW_PHASE_CELLS(name) void name(struct narrow_phase *narrow_phase, uint32_t count)

/* Fills the arrays of search volumes in `narrow_phase` in the order of the cells. */
#define NARROW_PHASE_COLUMNS(name)                                                                 \
    void name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of)

/* Writes the next near pairs to narrow_phase->near_a and near_b, and their number to
 * narrow_phase->near_count. The number is 0 after the last pair. */
#define NARROW_PHASE_NEAR(name)                                                                    \
    void name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of)

/* Tests the near pairs by all fifteen axes and writes the pairs that remain to `found`. Returns the
 * number of written pairs. */
#define NARROW_PHASE_BOXES(name)                                                                   \
    uint32_t name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,          \
                  struct narrow_phase_pair *found)

/* Computes the gaps for narrow_phase_gaps(). */
#define NARROW_PHASE_GAPS(name)                                                                    \
    void name(const struct body *body, const fish_index *a, const fish_index *b, uint32_t count,   \
              float *gap_m)

SIMD_BEGIN
NARROW_PHASE_MEASURE(narrow_phase_measure_4);
NARROW_PHASE_CELLS(narrow_phase_cells_4);
NARROW_PHASE_COLUMNS(narrow_phase_columns_4);
NARROW_PHASE_NEAR(narrow_phase_near_4);
NARROW_PHASE_BOXES(narrow_phase_boxes_4);
NARROW_PHASE_GAPS(narrow_phase_gaps_4);
NARROW_PHASE_MEASURE(narrow_phase_measure_8);
NARROW_PHASE_CELLS(narrow_phase_cells_8);
NARROW_PHASE_COLUMNS(narrow_phase_columns_8);
NARROW_PHASE_NEAR(narrow_phase_near_8);
NARROW_PHASE_BOXES(narrow_phase_boxes_8);
NARROW_PHASE_GAPS(narrow_phase_gaps_8);
SIMD_END

#endif
