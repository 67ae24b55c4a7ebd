/* narrow_phase.h -- the search for pairs of near bodies: exact, in a time proportional to their
 * number.
 *
 * Bodies are sorted into square cells of the floor plan. The reach of a body is the distance beyond
 * its skin at which the search still finds the body. The side of a cell is twice the radius of the
 * largest ball that contains a body with its reach and its personal space. Therefore a near body
 * lies in the same cell or in one of the eight cells around it. The side is 8.602 cm for pitching
 * fish of 5 cm with personal spaces of 7 x 4 x 3 cm. The cells of 3.5 cm in the 2013 thesis lose a
 * quarter of the pairs. Half of the nine cells suffices, because each pair needs to be found from
 * only one of its fish.
 *
 * The search has two steps, both with SIMD. At the density of the 2013 thesis, a fish has 22
 * candidates in the cells. The first step tests balls, heights and sides and leaves 2.9 pairs per
 * fish. The second step tests fifteen axes (separating-axis theorem) and leaves 1.5 pairs per fish.
 * The pairs and their order do not depend on the number of SIMD lanes. */
#ifndef KINGYO_CORE_TANK_COLLISION_NARROW_PHASE_H
#define KINGYO_CORE_TANK_COLLISION_NARROW_PHASE_H

#include "core/base/simd.h"
#include "core/tank/collision/body.h"
#include "core/tank/collision/spatial_grid.h"

/* Largest number of near pairs in a batch. A batch fits into the first-level cache. */
#define NARROW_PHASE_BATCH 256u

enum pair_search {
    PAIR_SEARCH_GRID = 0,
    PAIR_SEARCH_ALL = 1, /* Tests each body against each other body in quadratic time, only for
                            comparison (table 4.2 of the 2013 thesis). The search finds the same
                            pairs as PAIR_SEARCH_GRID in the same order. */
};

/* Input of a search. Arrays are indexed by fish. */
struct narrow_phase_query {
    const struct body *body;
    const uint8_t *flags; /* Flags of each fish. The search includes a fish if its flags contain at
                             least one bit of `which`. */
    const float *reach_m; /* Reach of each body: distance beyond its skin at which the search still
                             finds the body. */
    uint32_t count;
    uint8_t which;
    uint8_t search;           /* Pair search (enum pair_search). */
    uint8_t lanes;            /* Number of SIMD lanes: 0, 4 or 8, as in simd_is_built(). */
    uint8_t bodies_only;      /* 1 if the search may omit pairs whose personal spaces overlap but
                                 whose bodies are not near, otherwise 0. */
    float width_m, breadth_m; /* Size of the floor plan. Bodies outside the plan are also
                                 searched. */
};

/* A pair whose bodies are nearer than the sum of their reaches, or whose personal spaces
 * overlap. */
struct narrow_phase_pair {
    uint32_t a, b;  /* Indices of the two fish. */
    float gap_m;    /* Gap between the bodies: the largest separation over all axes. A value < 0
                       means an overlap. */
    uint8_t axis;   /* Index of the axis of `gap_m`; narrow_phase_axis() returns its vector. */
    uint8_t spaces; /* 1 if the personal spaces overlap, otherwise 0. */
};

/* Scratch memory of a search. No content is kept for the next search. */
struct narrow_phase {
    struct spatial_grid grid;
    fish_index member[TANK_FISH_MAX + SIMD_LANES_MAX]; /* Indices of the fish that the search
                                                          includes. */
    uint32_t cell, item, other; /* Cell and pair of items at which narrow_phase_next() continues. */
    uint8_t search;
    /* Search volumes in the order of the cells. A body is found within the ball of radius `ball_m`
     * around its centre, and within the height `slab_m` above and below the centre. SIMD code reads
     * SIMD_LANES_MAX elements beyond the last item. */
    float x_m[TANK_FISH_MAX + SIMD_LANES_MAX], y_m[TANK_FISH_MAX + SIMD_LANES_MAX],
        z_m[TANK_FISH_MAX + SIMD_LANES_MAX], ball_m[TANK_FISH_MAX + SIMD_LANES_MAX],
        slab_m[TANK_FISH_MAX + SIMD_LANES_MAX];
    uint32_t near_count;
    uint32_t near_a[NARROW_PHASE_BATCH + SIMD_LANES_MAX],
        near_b[NARROW_PHASE_BATCH + SIMD_LANES_MAX]; /* Items of the near pairs. An item is a
                                                        position in the order of the cells. */
};

/* Sorts the bodies into cells and prepares the first call of narrow_phase_next(). */
void narrow_phase_begin(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of);

/* Writes the next pairs in a fixed order and their number to `*count`, 0 .. NARROW_PHASE_BATCH.
 * Returns 0 after the last pair, otherwise 1. `found` must have room for NARROW_PHASE_BATCH +
 * SIMD_LANES_MAX pairs. */
int narrow_phase_next(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,
                      struct narrow_phase_pair *found, uint32_t *count);

/* Writes the gaps between the bodies of `count` pairs of fish to `gap_m`, as in struct
 * narrow_phase_pair. The error is below 1 um for gaps below half a metre. `lanes` is 0, 4 or 8, as
 * in simd_is_built(). The lists `a`, `b` and `gap_m` must have room for SIMD_LANES_MAX extra
 * entries. The extra entries of `a` and `b` must be valid indices of fish. */
void narrow_phase_gaps(const struct body *body, const fish_index *a, const fish_index *b,
                       uint32_t count, uint8_t lanes, float *gap_m);

/* Returns the unit vector from a toward b along which the gap of a found pair is measured. `axis`
 * is the pair's member `axis`. */
vec3 narrow_phase_axis(const struct body *a, const struct body *b, uint8_t axis);

#endif
