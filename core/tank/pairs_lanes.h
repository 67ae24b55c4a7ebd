/* pairs_lanes.h -- the inner loops of the pair search, once for four lanes and once for eight.
 *
 * Only pairs.c calls them. Lists that SIMD code reads have room for LANES_MAX extra entries, which
 * hold some valid entry. */
#ifndef KINGYO_CORE_TANK_PAIRS_LANES_H
#define KINGYO_CORE_TANK_PAIRS_LANES_H

#include "core/tank/pairs.h"

#define PAIRS_AHEAD (2u * LANES) /* Items or pairs to prefetch ahead; covers the latency of
                                    memory. */

/* Writes the positions of the `count` > 0 members in their order (pairs->x_m, z_m). Returns the
 * radius of the largest ball in which one of them is found. */
#define PAIRS_MEASURE(name)                                                                        \
    float name(struct pairs *pairs, const struct pairs_of *of, const fish_index *member,           \
               uint32_t count)

/* Writes the cell of each of `count` positions, from pairs->x_m and z_m. */
#define PAIRS_CELLS(name) void name(struct pairs *pairs, uint32_t count)

/* Writes all columns in the order of the cells. */
#define PAIRS_COLUMNS(name) void name(struct pairs *pairs, const struct pairs_of *of)

/* Writes the next near pairs; pairs->near_count is 0 after the last pair. */
#define PAIRS_NEAR(name) void name(struct pairs *pairs, const struct pairs_of *of)

/* Keeps the near pairs that all fifteen axes leave. Returns their number. */
#define PAIRS_JUDGE(name)                                                                          \
    uint32_t name(struct pairs *pairs, const struct pairs_of *of, struct found *found)

/* Inner loop of pairs_gaps(). */
#define PAIRS_GAPS(name)                                                                           \
    void name(const struct body *body, const fish_index *a, const fish_index *b, uint32_t count,   \
              float *gap_m)

LANES_BEGIN
PAIRS_MEASURE(pairs_measure_4);
PAIRS_CELLS(pairs_cells_4);
PAIRS_COLUMNS(pairs_columns_4);
PAIRS_NEAR(pairs_near_4);
PAIRS_JUDGE(pairs_judge_4);
PAIRS_GAPS(pairs_gaps_4);
PAIRS_MEASURE(pairs_measure_8);
PAIRS_CELLS(pairs_cells_8);
PAIRS_COLUMNS(pairs_columns_8);
PAIRS_NEAR(pairs_near_8);
PAIRS_JUDGE(pairs_judge_8);
PAIRS_GAPS(pairs_gaps_8);
LANES_END

#endif
