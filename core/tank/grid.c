/* grid.c -- counting sort of points into square cells. */
#include "core/tank/grid.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

static uint32_t cells_along(float length_m, float cell_m)
{
    const uint32_t whole = (uint32_t)(length_m / cell_m);
    return (float)whole * cell_m < length_m ? whole + 1u : whole;
}

void grid_layout(struct grid *grid, float width_m, float breadth_m, float reach_m)
{
    CORE_ASSERT(width_m > 0.0f && breadth_m > 0.0f);
    CORE_ASSERT(reach_m > 0.0f);
    /* No cell smaller than what a square plan of GRID_CELL_MAX cells would need. */
    const float side_m = f_max(width_m, breadth_m);
    grid->cell_m = f_max(reach_m, side_m / 1024.0f);
    grid->columns = cells_along(width_m, grid->cell_m);
    grid->rows = cells_along(breadth_m, grid->cell_m);
    while (grid->columns * grid->rows > GRID_CELL_MAX) {
        grid->cell_m *= 1.1f;
        grid->columns = cells_along(width_m, grid->cell_m);
        grid->rows = cells_along(breadth_m, grid->cell_m);
    }
    grid->origin_x_m = -0.5f * width_m;
    grid->origin_z_m = -0.5f * breadth_m;
}

/* Clamped before the conversion, so that no float is out of the integer's range. */
static uint32_t cell_along(float offset_m, float cell_m, uint32_t count)
{
    return (uint32_t)f_clamp(offset_m / cell_m, 0.0f, (float)(count - 1u));
}

uint32_t grid_cell(const struct grid *grid, vec3 point_m)
{
    const uint32_t column = cell_along(point_m.x - grid->origin_x_m, grid->cell_m, grid->columns);
    const uint32_t row = cell_along(point_m.z - grid->origin_z_m, grid->cell_m, grid->rows);
    return row * grid->columns + column;
}

void grid_fill(struct grid *grid, const struct body *body, const uint8_t *flags, uint8_t which,
               uint32_t count)
{
    CORE_ASSERT(count <= TANK_FISH_MAX);
    const uint32_t cell_count = grid->columns * grid->rows;
    memset(grid->start, 0, sizeof grid->start[0] * (cell_count + 1u));
    for (uint32_t i = 0; i < count; i++) {
        if (flags[i] & which) {
            grid->cell_of[i] = grid_cell(grid, body[i].centre_m);
            grid->start[grid->cell_of[i]]++;
        }
    }
    for (uint32_t c = 1; c <= cell_count; c++) {
        grid->start[c] += grid->start[c - 1u];
    }
    grid->count = grid->start[cell_count];
    /* Each start is now its cell's end; filling from the back leaves it at the beginning, in order.
     */
    for (uint32_t i = count; i-- > 0;) {
        if (flags[i] & which) {
            grid->item[--grid->start[grid->cell_of[i]]] = (fish_index)i;
        }
    }
}
