/* grid.h -- finds every pair of fish that are near each other, without looking at all pairs.
 *
 * A uniform grid over the tank's floor plan, rebuilt by counting sort each tick. With a cell side
 * of at least the reach asked for, the 3 x 3 cells around a fish hold all its neighbours. */
#ifndef KINGYO_CORE_TANK_GRID_H
#define KINGYO_CORE_TANK_GRID_H

#include <stdint.h>

#include "core/tank/body.h"
#include "core/tank/fish.h"

#define GRID_CELL_MAX TANK_FISH_MAX /* A 2 m x 2 m tank at the smallest reach offered. */

struct grid {
    float cell_m; /* Side of a cell. */
    float origin_x_m, origin_z_m;
    uint32_t columns, rows; /* columns * rows <= GRID_CELL_MAX */
    uint32_t count;         /* Of bodies that are in it. */
    uint32_t
        start[GRID_CELL_MAX + 1u]; /* Members of cell c: item[start[c]] .. item[start[c+1]-1]. */
    fish_index item[TANK_FISH_MAX];
    uint32_t cell_of[TANK_FISH_MAX]; /* While it is filled. */
};

/* Lays cells of side >= `reach_m` over a floor plan; larger where GRID_CELL_MAX would not do. */
void grid_layout(struct grid *grid, float width_m, float breadth_m, float reach_m);

/* Sorts those of `count` <= TANK_FISH_MAX bodies that have one of the bits `which` among their
 * flags into cells; outliers to the border. */
void grid_fill(struct grid *grid, const struct body *body, const uint8_t *flags, uint8_t which,
               uint32_t count);

/* The cell of a point, clamped to the plan. */
uint32_t grid_cell(const struct grid *grid, vec3 point_m);

#endif
