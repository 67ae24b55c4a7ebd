/* spatial_grid.c -- counting sort of fish into square cells. */
#include "core/tank/collision/spatial_grid.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

static uint32_t cells_along(float length_m, float cell_m)
{
    const uint32_t whole = (uint32_t)(length_m / cell_m);
    return (float)whole * cell_m < length_m ? whole + 1u : whole;
}

void spatial_grid_layout(struct spatial_grid *grid, float width_m, float breadth_m, float reach_m,
                         uint32_t fish_count)
{
    const uint32_t cell_max = fish_capacity(fish_count) / (TANK_FISH_MAX / SPATIAL_GRID_CELL_MAX);
    CORE_ASSERT(width_m > 0.0f && breadth_m > 0.0f);
    CORE_ASSERT(reach_m > 0.0f);
    /* A cell is so large that the floor plan has at most `cell_max` cells along a side. A cell is
     * also slightly larger than `reach_m`, so that rounding never puts two near fish two cells
     * apart. */
    grid->cell_m = f_max(1.0001f * reach_m, f_max(width_m, breadth_m) / (float)cell_max);
    grid->columns = cells_along(width_m, grid->cell_m);
    grid->rows = cells_along(breadth_m, grid->cell_m);
    while (grid->columns * grid->rows > cell_max) {
        grid->cell_m *= 1.1f;
        grid->columns = cells_along(width_m, grid->cell_m);
        grid->rows = cells_along(breadth_m, grid->cell_m);
    }
    grid->cells_per_m = 1.0f / grid->cell_m;
    grid->origin_x_m = -0.5f * width_m;
    grid->origin_z_m = -0.5f * breadth_m;
}

/* Clamps before the conversion, so that the float never exceeds the range of the integer. */
static uint32_t cell_along(float offset_m, float cells_per_m, uint32_t count)
{
    return (uint32_t)f_clamp(offset_m * cells_per_m, 0.0f, (float)(count - 1u));
}

uint32_t spatial_grid_cell(const struct spatial_grid *grid, vec3 point_m)
{
    const float x_m = point_m.x - grid->origin_x_m, z_m = point_m.z - grid->origin_z_m;
    return cell_along(z_m, grid->cells_per_m, grid->rows) * grid->columns +
           cell_along(x_m, grid->cells_per_m, grid->columns);
}

void spatial_grid_sort(struct spatial_grid *grid, const fish_index *member, uint32_t count)
{
    CORE_ASSERT(count <= TANK_FISH_MAX);
    const uint32_t cell_count = grid->columns * grid->rows;
    grid->count = count;
    memset(grid->start, 0, sizeof grid->start[0] * (cell_count + 1u));
    for (uint32_t m = 0; m < count; m++) {
        grid->start[grid->cell_of[m]]++;
    }
    for (uint32_t c = 1; c <= cell_count; c++) {
        grid->start[c] = (fish_index)(grid->start[c] + grid->start[c - 1u]);
    }
    /* Each element of `start` is now the end of its cell. Filling each cell from the back moves the
     * element to the beginning of the cell and keeps the order of the members. */
    for (uint32_t m = count; m-- > 0;) {
        grid->item[--grid->start[grid->cell_of[m]]] = member[m];
    }
}
