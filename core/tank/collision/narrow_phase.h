/* narrow_phase.h -- the pair search, which finds every pair of bodies that are near each other.
 *
 * A body is the oriented box of a fish. The reach of a body is a distance that the caller chooses.
 * Two bodies are a pair if the gap between them is smaller than the sum of their reaches, or if
 * their personal spaces overlap. A personal space is the body's box enlarged on every side.
 *
 * To avoid testing all pairs, the search sorts the bodies into the square cells of a grid on the
 * floor plan. The side of a cell is twice the radius of the largest ball that contains a body with
 * its reach and its personal space. Therefore the two bodies of a pair lie in the same cell or in
 * cells that touch. For each body, the search tests the bodies of its own cell and of four of the
 * eight cells around it. The other four cells need no test, because the search finds those pairs
 * from the other body. The time of the search is proportional to the number of bodies.
 *
 * The side of a cell is 8.602 cm for pitching fish of 5 cm with personal spaces of 7 x 4 x 3 cm.
 * The cells of 3.5 cm in the 2013 thesis on goldfish behavior lose a quarter of the pairs.
 *
 * The search has two steps, both with SIMD. At the density of the 2013 thesis, a fish has 22
 * candidates in the cells. The first step compares balls, heights and sides, and leaves 2.9 pairs
 * per fish. The second step is the separating-axis test of the boxes, and leaves 1.5 pairs per
 * fish. The pairs and their order do not depend on the number of SIMD lanes. */
#pragma once

#include <stdint.h>

#include "core/base/simd.h"
#include "core/tank/collision/box.h"
#include "core/tank/fish.h"

_Static_assert((fish_index)TANK_FISH_MAX == TANK_FISH_MAX, "all may be before a cell's start");

/* Largest number of cells: one cell for every two fish. Tanks with fewer fish have larger cells. */
#define SPATIAL_GRID_CELL_MAX (TANK_FISH_MAX / 2u)

/* Grid of square cells on the floor plan, and the fish in each cell. */
struct spatial_grid {
    float cell_m;      /* Length of the sides of the square cells. */
    float cells_per_m; /* Inverse of `cell_m`. */
    float origin_x_m, origin_z_m;
    /* Number of cells along x and z. columns * rows is at most SPATIAL_GRID_CELL_MAX. */
    uint32_t columns, rows;
    uint32_t count; /* Number of items; an item is a fish in a cell. */
    /* Index of the first item (fish) of each cell. The items of cell c are item[start[c]] to
     * item[start[c + 1] - 1]. */
    fish_index start[SPATIAL_GRID_CELL_MAX + 1u];
    fish_index item[TANK_FISH_MAX + SIMD_LANES_MAX];
    /* Cell of each fish: cell_of[m] is the cell of the fish member[m]. The caller sets `cell_of`
     * before it calls narrow_grid_sort(). */
    fish_index cell_of[TANK_FISH_MAX + SIMD_LANES_MAX];
};

/* Divides a floor plan into cells whose side is at least `reach_m`. The cells are larger if the
 * number of cells would otherwise exceed fish_capacity(fish_count) / 2. */
void narrow_grid_layout(struct spatial_grid *grid, float width_m, float breadth_m, float reach_m,
                        uint32_t fish_count);

/* Sorts the `count` fish of the array `member` into their grid cells, which the member `cell_of` of
 * `grid` gives. Fish of the same cell keep their order. Asserts that `count` is at most
 * TANK_FISH_MAX. */
void narrow_grid_sort(struct spatial_grid *grid, const fish_index *member, uint32_t count);

/* A range of items (fish in the order of the cells), from item `from` to item `to` - 1. The cells
 * of a row are consecutive, so the items of these cells form one range. */
struct grid_range {
    uint32_t from, to;
};

/* Returns the index of the cell that contains `item` (a fish). Searches upward from `cell`, which
 * must not be greater than the result. */
static inline uint32_t narrow_grid_cell_of_item(const struct spatial_grid *grid, uint32_t item,
                                                uint32_t cell)
{
    while (item >= grid->start[cell + 1u]) {
        cell++;
    }
    return cell;
}

/* Returns the range of items (fish) in `cell` and in the next cell to the right. For an item of
 * `cell`, the search tests only the later items of this range and the items of narrow_grid_below().
 * The pairs with all other nearby items have already been tested from those items, which come
 * earlier in the order of the cells. */
static inline struct grid_range narrow_grid_beside(const struct spatial_grid *grid, uint32_t cell)
{
    const uint32_t last = (cell + 1u) % grid->columns > 0 ? cell + 1u : cell;
    return (struct grid_range){ grid->start[cell], grid->start[last + 1u] };
}

static inline struct grid_range narrow_grid_below(const struct spatial_grid *grid, uint32_t cell)
{
    const uint32_t below = cell + grid->columns;
    if (below >= grid->columns * grid->rows) {
        return (struct grid_range){ grid->count, grid->count };
    }
    const uint32_t first = cell % grid->columns > 0 ? below - 1u : below;
    const uint32_t last = (cell + 1u) % grid->columns > 0 ? below + 1u : below;
    return (struct grid_range){ grid->start[first], grid->start[last + 1u] };
}

/* Largest number of nearby pairs that the search processes together, as one batch. A batch fits
 * into the first-level cache. */
#define NARROW_PHASE_BATCH 256u

enum pair_search {
    PAIR_SEARCH_GRID = 0,
    /* Tests each body against each other body in quadratic time, only for comparison (table 4.2 of
     * the 2013 thesis). The search finds the same pairs as PAIR_SEARCH_GRID in the same order. */
    PAIR_SEARCH_ALL = 1,
};

/* Input of a search for pairs of nearby bodies. Arrays are indexed by fish. */
struct narrow_phase_query {
    const struct body *body;
    /* Flags of each fish (enum body_flag). The search includes a fish if its flags contain at least
     * one bit of `which`. */
    const uint8_t *flags;
    /* Reach of each body: distance beyond its skin at which the search still finds the body. */
    const float *reach_m;
    uint32_t count;
    uint8_t which;
    uint8_t search; /* Algorithm of the pair search (enum pair_search). */
    uint8_t lanes;  /* Number of SIMD lanes: 4, 8, or 0 for the default (4). */
    /* True if the search may omit pairs whose personal spaces overlap but whose bodies are not
     * near. */
    bool bodies_only;
    /* Width (x) and breadth (z) of the floor plan that the grid divides into cells. A body outside
     * the plan is sorted into the nearest cell at the border. */
    float width_m, breadth_m;
};

/* A pair whose bodies are nearer than the sum of their reaches, or whose personal spaces
 * overlap. */
struct narrow_phase_pair {
    uint32_t a, b; /* Indices of the two fish. */
    /* Gap between the two bodies, m: the largest gap between their projections on one of fifteen
     * axes. A value < 0 means that the bodies overlap. */
    float gap_m;
    uint8_t axis;   /* Index of the axis of `gap_m`; narrow_phase_axis() returns its vector. */
    uint8_t spaces; /* 1 if the personal spaces overlap, otherwise 0. */
};

/* Scratch memory of a pair search. No content is kept for the next search. */
struct narrow_phase {
    struct spatial_grid grid;
    /* Indices of the fish that the search includes. */
    fish_index member[TANK_FISH_MAX + SIMD_LANES_MAX];
    /* Place at which the next call of narrow_phase_next() continues: a cell, and a pair of items
     * (fish). */
    uint32_t cell, item, other;
    uint8_t search;
    /* Search volume of each body, sorted by cell. The volume is the part of a ball around the
     * body's centre that is at most `slab_m` above or below the centre. `ball_m` is the radius of
     * the ball. Only bodies whose search volumes overlap can be a pair. SIMD code reads
     * SIMD_LANES_MAX elements beyond the last item. */
    float x_m[TANK_FISH_MAX + SIMD_LANES_MAX], y_m[TANK_FISH_MAX + SIMD_LANES_MAX],
        z_m[TANK_FISH_MAX + SIMD_LANES_MAX], ball_m[TANK_FISH_MAX + SIMD_LANES_MAX],
        slab_m[TANK_FISH_MAX + SIMD_LANES_MAX];
    uint32_t near_count; /* Number of pairs in `near_a` and `near_b`. */
    /* Pairs that the first step of the search found. near_a[k] and near_b[k] are the two items of
     * pair k. An item is the place of a fish in the order of the cells. */
    uint32_t near_a[NARROW_PHASE_BATCH + SIMD_LANES_MAX],
        near_b[NARROW_PHASE_BATCH + SIMD_LANES_MAX];
};

/* Sorts the bodies into cells and prepares the first call of narrow_phase_next(). */
void narrow_phase_begin(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of);

/* Writes the next pairs in a fixed order and their number to `*count`, 0 .. NARROW_PHASE_BATCH.
 * Returns false after the last pair, otherwise true. `found` must have room for
 * NARROW_PHASE_BATCH + SIMD_LANES_MAX pairs. */
bool narrow_phase_next(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,
                       struct narrow_phase_pair *found, uint32_t *count);

/* Writes the gaps between the bodies of `count` pairs of fish to `gap_m`, as in struct
 * narrow_phase_pair. The error is below 1 um for gaps below half a metre. `lanes` is the number of
 * SIMD lanes: 4, 8, or 0 for the default (4). The lists `a`, `b` and `gap_m` must have room for
 * SIMD_LANES_MAX extra entries. The extra entries of `a` and `b` must be valid indices of fish. */
void narrow_phase_gaps(const struct body *body, const fish_index *a, const fish_index *b,
                       uint32_t count, uint8_t lanes, float *gap_m);

/* Returns the unit vector from a toward b along which the gap of a found pair is measured. `axis`
 * is the pair's member `axis`. */
vec3 narrow_phase_axis(const struct body *a, const struct body *b, uint8_t axis);
