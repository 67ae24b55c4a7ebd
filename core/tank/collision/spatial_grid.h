/* spatial_grid.h -- the spatial grid: square cells over the floor plan and the fish in each cell.
 *
 * The fish are sorted by a counting sort. If the cell side is at least the reach of the search, the
 * 3 x 3 cells around a fish hold all its neighbours. */
#ifndef KINGYO_CORE_TANK_COLLISION_SPATIAL_GRID_H
#define KINGYO_CORE_TANK_COLLISION_SPATIAL_GRID_H

#include <stdint.h>

#include "core/base/simd.h"
#include "core/tank/collision/body.h"
#include "core/tank/fish.h"

_Static_assert((fish_index)TANK_FISH_MAX == TANK_FISH_MAX, "all may be before a cell's start");

/* Largest number of cells: one cell for two fish. Tanks with fewer fish have larger cells. */
#define SPATIAL_GRID_CELL_MAX (TANK_FISH_MAX / 2u)

struct spatial_grid {
    float cell_m;      /* Side of a cell. */
    float cells_per_m; /* Inverse of `cell_m`. */
    float origin_x_m, origin_z_m;
    uint32_t columns, rows; /* Number of cells along x and z. columns * rows is at most
                               SPATIAL_GRID_CELL_MAX. */
    uint32_t count;         /* Number of fish in the cells; a fish in a cell is an item. */
    /* First item of each cell. The items of cell c are item[start[c]] to item[start[c + 1] - 1]. */
    fish_index start[SPATIAL_GRID_CELL_MAX + 1u];
    fish_index item[TANK_FISH_MAX + SIMD_LANES_MAX];
    fish_index cell_of[TANK_FISH_MAX + SIMD_LANES_MAX]; /* Cell of each member. The caller sets the
                                                           cells before spatial_grid_sort(). */
};

/* Divides a floor plan for `fish_count` fish into cells whose side is at least `reach_m`. The cells
 * are larger if the plan would need more than half of fish_capacity() cells. */
void spatial_grid_layout(struct spatial_grid *grid, float width_m, float breadth_m, float reach_m,
                         uint32_t fish_count);

/* Returns the cell of a point. A point outside the plan belongs to the nearest cell at the
 * border. */
uint32_t spatial_grid_cell(const struct spatial_grid *grid, vec3 point_m);

/* Sorts `count` members into their cells; cell_of[m] is the cell of member m. Members of a cell
 * keep their order. Asserts that `count` is at most TANK_FISH_MAX. */
void spatial_grid_sort(struct spatial_grid *grid, const fish_index *member, uint32_t count);

/* A range of items, from item `from` to item `to` - 1. The cells of a row are consecutive, so the
 * items of these cells form one range. */
struct spatial_grid_range {
    uint32_t from, to;
};

/* Returns the cell of `item`. The search begins at `cell`, which must not be greater than the cell
 * of `item`. */
static inline uint32_t spatial_grid_cell_of_item(const struct spatial_grid *grid, uint32_t item,
                                                 uint32_t cell)
{
    while (item >= grid->start[cell + 1u]) {
        cell++;
    }
    return cell;
}

/* Returns the items of `cell` and of the next cell to the right. For an item of
 * `cell`, only the later items of this range and the items of spatial_grid_below() are tested. The
 * search finds all other near pairs from earlier items. */
static inline struct spatial_grid_range spatial_grid_beside(const struct spatial_grid *grid,
                                                            uint32_t cell)
{
    const uint32_t last = (cell + 1u) % grid->columns > 0 ? cell + 1u : cell;
    return (struct spatial_grid_range){ grid->start[cell], grid->start[last + 1u] };
}

static inline struct spatial_grid_range spatial_grid_below(const struct spatial_grid *grid,
                                                           uint32_t cell)
{
    const uint32_t below = cell + grid->columns;
    if (below >= grid->columns * grid->rows) {
        return (struct spatial_grid_range){ grid->count, grid->count };
    }
    const uint32_t first = cell % grid->columns > 0 ? below - 1u : below;
    const uint32_t last = (cell + 1u) % grid->columns > 0 ? below + 1u : below;
    return (struct spatial_grid_range){ grid->start[first], grid->start[last + 1u] };
}

#endif
