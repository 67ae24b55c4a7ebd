/* narrow_phase.h -- the search for near bodies: exact, in time proportional to their number.
 *
 * Bodies are sorted into square cells of the floor plan. The cell side is the largest sum of two
 * reaches, so a near body lies in the same cell or in one of the eight cells around it. The side is
 * 8.602 cm for pitching fish of 5 cm with spaces of 7 x 4 x 3 cm (the 2013 thesis' 3.5 cm lose a
 * quarter of the pairs). Half of the nine cells suffice, because every pair is found from one of
 * its ends.
 *
 * The search has two steps, both with SIMD. At the thesis' density a fish has 22 candidates. Balls,
 * heights and sides leave 2.9 pairs per fish, and fifteen axes (separating-axis theorem) leave 1.5.
 * The found pairs and their order do not depend on the number of SIMD lanes. */
#ifndef KINGYO_CORE_TANK_COLLISION_NARROW_PHASE_H
#define KINGYO_CORE_TANK_COLLISION_NARROW_PHASE_H

#include "core/base/simd.h"
#include "core/tank/collision/body.h"
#include "core/tank/collision/spatial_grid.h"

/* Near pairs per batch; a batch fits into the first-level cache. */
#define NARROW_PHASE_BATCH 256u

enum pair_search {
    PAIR_SEARCH_GRID = 0,
    PAIR_SEARCH_ALL = 1, /* Tests each body against each other body, for comparison (the thesis'
                            table 4.2). Finds the same pairs in the same order, in quadratic
                            time. */
};

/* Input of a search. Columns are indexed by fish. */
struct narrow_phase_query {
    const struct body *body;
    const uint8_t *flags; /* Fish with one of the bits of `which` are searched. */
    const float *reach_m; /* Distance beyond its skin at which a body is also found, beside its
                             margin. */
    uint32_t count;
    uint8_t which;
    uint8_t search;           /* enum pair_search */
    uint8_t lanes;            /* 0, 4 or 8, as in simd_is_built(). */
    uint8_t bodies_only;      /* 1: pairs that are near only by their personal spaces may be left
                                 out. */
    float width_m, breadth_m; /* Size of the floor plan; bodies outside it are searched too. */
};

/* A pair whose bodies are nearer than the sum of their reaches, or whose personal spaces
 * overlap. */
struct narrow_phase_pair {
    uint32_t a, b;  /* Indices of both fish. */
    float gap_m;    /* Gap between the bodies: the largest separation over all axes. < 0:
                       overlap. */
    uint8_t axis;   /* Index of the axis of `gap_m`; narrow_phase_axis() returns its vector. */
    uint8_t spaces; /* 1 if the personal spaces overlap. */
};

/* Scratch memory of a search; nothing in it is kept between searches. */
struct narrow_phase {
    struct spatial_grid grid;
    fish_index member[TANK_FISH_MAX + SIMD_LANES_MAX]; /* Fish to search. */
    uint32_t cell, item, other; /* Position of the search in the order of the cells. */
    uint8_t search;
    /* Columns in the order of the cells. A ball and half a height enclose the volume in which a
     * body is found. SIMD code reads a little beyond the last item. */
    float x_m[TANK_FISH_MAX + SIMD_LANES_MAX], y_m[TANK_FISH_MAX + SIMD_LANES_MAX],
        z_m[TANK_FISH_MAX + SIMD_LANES_MAX], ball_m[TANK_FISH_MAX + SIMD_LANES_MAX],
        slab_m[TANK_FISH_MAX + SIMD_LANES_MAX];
    uint32_t near_count;
    uint32_t near_a[NARROW_PHASE_BATCH + SIMD_LANES_MAX],
        near_b[NARROW_PHASE_BATCH + SIMD_LANES_MAX]; /* Items of the near pairs. */
};

/* Sorts the bodies into cells and sets the position before the first pair. */
void narrow_phase_begin(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of);

/* Writes the next pairs in a fixed order: `*count` of them, 0 .. NARROW_PHASE_BATCH. Returns 0
 * after the last pair. `found` must have room for NARROW_PHASE_BATCH + SIMD_LANES_MAX pairs. */
int narrow_phase_next(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,
                      struct narrow_phase_pair *found, uint32_t *count);

/* Writes the gaps between the bodies of `count` pairs of fish, as in struct narrow_phase_pair,
 * within 1 um for gaps below half a metre. `lanes` is as in simd_is_built(). All three lists must
 * have room for SIMD_LANES_MAX more entries; the extra entries of `a` and `b` must be valid fish.
 */
void narrow_phase_gaps(const struct body *body, const fish_index *a, const fish_index *b,
                       uint32_t count, uint8_t lanes, float *gap_m);

/* Returns the unit vector from a toward b along which the gap of a found pair is measured. */
vec3 narrow_phase_axis(const struct body *a, const struct body *b, uint8_t axis);

#endif
