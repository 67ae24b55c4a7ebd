/* narrow_phase_simd.h -- the SIMD kernels of the pair search, and struct body_simd, which holds
 * several bodies for SIMD code. Each kernel is compiled for four lanes and for eight lanes.
 *
 * Only narrow_phase.c calls the kernels. SIMD code reads whole blocks, so each list has
 * SIMD_LANES_MAX extra entries with valid values at its end. */
#pragma once

#include "core/tank/collision/narrow_phase.h"

/* Four or eight bodies (SIMD_LANES) for SIMD code. Each SIMD vector holds one float of every body,
 * for example the x coordinates of all centres. Such a vector is called a column. The members have
 * the same names as in struct body. */
struct body_simd {
    /* Columns 0 to 2 of each array are the x, y and z coordinates. Column 3 is the float that
     * follows the vec3 in struct body: `half_x_m` in centre[3], `half_y_m` in right[3], `half_z_m`
     * in up[3] and `margin_m` in back[3]. */
    flanes centre[4], right[4], up[4], back[4];
};

/* Loads SIMD_LANES bodies that are consecutive in memory. */
static inline void body_simd_load_block(struct body_simd *all, const struct body *first)
{
    const char *from = (const char *)first;
    simd_load_quads(all->centre, from, sizeof *first);
    simd_load_quads(all->right, from + 16u, sizeof *first);
    simd_load_quads(all->up, from + 32u, sizeof *first);
    simd_load_quads(all->back, from + 48u, sizeof *first);
}

/* Loads quad number `quad` of body fish[0]. A quad is a group of four consecutive floats in struct
 * body. With eight lanes, the upper four lanes are loaded from body fish[4]. */
static inline flanes body_simd_row(const struct body *body, const uint32_t *fish, uint32_t quad)
{
    const size_t at = quad * sizeof(fquad);
    return simd_load_pair((const char *)&body[fish[0]] + at,
                          (const char *)&body[fish[SIMD_LANES - 4]] + at);
}

static inline void body_simd_quads(flanes column[4], const struct body *body, const uint32_t *fish,
                                   uint32_t quad)
{
    simd_turn(column, body_simd_row(body, fish, quad), body_simd_row(body, fish + 1, quad),
              body_simd_row(body, fish + 2, quad), body_simd_row(body, fish + 3, quad));
}

/* Loads the bodies of the SIMD_LANES fish in the list `fish`. The bodies need not be consecutive in
 * memory. */
static inline void body_simd_load(struct body_simd *all, const struct body *body,
                                  const uint32_t *fish)
{
    body_simd_quads(all->centre, body, fish, 0);
    body_simd_quads(all->right, body, fish, 1);
    body_simd_quads(all->up, body, fish, 2);
    body_simd_quads(all->back, body, fish, 3);
}

/* The pair search prefetches the data of an item or a pair this many items or pairs before it uses
 * the data. During that time the memory delivers the data. */
#define NARROW_PHASE_PREFETCH (2u * SIMD_LANES)

/* Writes the horizontal positions of the `count` > 0 fish whose indices are in `member` to
 * narrow_phase->x_m and z_m. Returns the largest value of `ball_m` (struct narrow_phase) of these
 * fish. */
#define NARROW_PHASE_MEASURE(name)                                                                 \
    float name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,             \
               const fish_index *member, uint32_t count)

/* Computes the grid cell of each of the `count` fish of the search (narrow_phase->member) from the
 * positions in narrow_phase->x_m and z_m. */
#define NARROW_PHASE_CELLS(name) void name(struct narrow_phase *narrow_phase, uint32_t count)

/* Computes the search volume of each fish and stores the search volumes in `narrow_phase`, sorted
 * by cell. */
#define NARROW_PHASE_COLUMNS(name)                                                                 \
    void name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of)

/* Writes the next nearby pairs to narrow_phase->near_a and near_b, and their number to
 * narrow_phase->near_count. The number is 0 after the last pair. */
#define NARROW_PHASE_NEAR(name)                                                                    \
    void name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of)

/* Second step of the pair search: tests the pairs of the first step by the fifteen axes of the
 * separating-axis test. Writes the pairs that are really near to `found`. Returns the number of
 * written pairs. */
#define NARROW_PHASE_BOXES(name)                                                                   \
    uint32_t name(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,          \
                  struct narrow_phase_pair *found)

/* SIMD form of narrow_phase_gaps(): computes the gaps between the bodies of `count` pairs of
 * fish. */
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
