/* narrow_phase.c -- the steps of a pair search: sorts the fish into the cells of the spatial grid
 * by a counting sort, filters the pairs, and tests the boxes of the remaining pairs. */
#include "core/tank/collision/narrow_phase.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/tank/collision/narrow_phase_simd.h"

void narrow_phase_begin(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of)
{
    CORE_ASSERT(of->count <= TANK_FISH_MAX);
    CORE_ASSERT(simd_is_built(of->lanes));
    struct spatial_grid *grid = &narrow_phase->grid;
    narrow_phase->cell = 0;
    narrow_phase->item = 0;
    narrow_phase->other = 0;
    narrow_phase->search = of->search;
    /* Collects the fish that the search includes, and fills the rest of the last SIMD block with
     * the last index. */
    fish_index *member = narrow_phase->member;
    uint32_t count = 0;
    for (uint32_t i = 0; i < of->count; i++) {
        member[count] = (fish_index)i;
        count += (of->flags[i] & of->which) != 0;
    }
    for (uint32_t lane = 0; lane < SIMD_LANES_MAX; lane++) {
        member[count + lane] = count > 0 ? member[count - 1u] : 0;
    }
    if (count == 0) {
        grid->count = 0;
        return;
    }
    const float ball_m =
        SIMD_PICK(of->lanes, narrow_phase_measure)(narrow_phase, of, member, count);
    narrow_grid_layout(grid, of->width_m, of->breadth_m, 2.0f * ball_m, of->count);
    SIMD_PICK(of->lanes, narrow_phase_cells)(narrow_phase, count);
    narrow_grid_sort(grid, member, count);
    for (uint32_t lane = 0; lane < SIMD_LANES_MAX; lane++) {
        grid->item[count + lane] = grid->item[count - 1u];
    }
    SIMD_PICK(of->lanes, narrow_phase_columns)(narrow_phase, of);
}

bool narrow_phase_next(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,
                       struct narrow_phase_pair *found, uint32_t *count)
{
    SIMD_PICK(of->lanes, narrow_phase_near)(narrow_phase, of);
    for (uint32_t lane = 0; lane < SIMD_LANES_MAX; lane++) {
        narrow_phase->near_a[narrow_phase->near_count + lane] = 0;
        narrow_phase->near_b[narrow_phase->near_count + lane] = 0;
    }
    *count = SIMD_PICK(of->lanes, narrow_phase_boxes)(narrow_phase, of, found);
    return narrow_phase->near_count > 0;
}

void narrow_phase_gaps(const struct body *body, const fish_index *a, const fish_index *b,
                       uint32_t count, uint8_t lanes, float *gap_m)
{
    CORE_ASSERT(simd_is_built(lanes));
    SIMD_PICK(lanes, narrow_phase_gaps)(body, a, b, count, gap_m);
}

vec3 narrow_phase_axis(const struct body *a, const struct body *b, uint8_t axis)
{
    const struct basis axes_a = { a->right, a->up, a->back }, axes_b = { b->right, b->up, b->back };
    return box_axis(&axes_a, &axes_b, v3_sub(b->centre_m, a->centre_m), axis);
}

/* ---- Spatial grid ---------------------------------------------------------------------------- */

static uint32_t cells_along(float length_m, float cell_m)
{
    CORE_ASSERT(cell_m > 0.0f);
    const uint32_t whole = (uint32_t)(length_m / cell_m);
    return (float)whole * cell_m < length_m ? whole + 1u : whole;
}

void narrow_grid_layout(struct spatial_grid *grid, float width_m, float breadth_m, float reach_m,
                        uint32_t fish_count)
{
    const uint32_t cell_max = fish_capacity(fish_count) / (TANK_FISH_MAX / SPATIAL_GRID_CELL_MAX);
    CORE_ASSERT(width_m > 0.0f && breadth_m > 0.0f);
    CORE_ASSERT(reach_m > 0.0f);
    /* A cell has at least the side `reach_m`, plus a reserve against rounding, so that two nearby
     * fish are never two cells apart. A cell is also so large that the floor of the tank has at
     * most `cell_max` cells along a side. */
    grid->cell_m = f_max(1.0001f * reach_m, f_max(width_m, breadth_m) / (float)cell_max);
    for (;;) {
        grid->columns = cells_along(width_m, grid->cell_m);
        grid->rows = cells_along(breadth_m, grid->cell_m);
        if (grid->columns * grid->rows <= cell_max) {
            break;
        }
        grid->cell_m *= 1.1f;
    }
    grid->cells_per_m = 1.0f / grid->cell_m;
    grid->origin_x_m = -0.5f * width_m;
    grid->origin_z_m = -0.5f * breadth_m;
}

void narrow_grid_sort(struct spatial_grid *grid, const fish_index *member, uint32_t count)
{
    CORE_ASSERT(grid->columns * grid->rows <= SPATIAL_GRID_CELL_MAX);
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
    /* start[c] is now the index after the last item of cell c. The loop fills each cell from the
     * back, which moves start[c] to the first item of the cell and keeps the order of the fish. */
    for (uint32_t m = count; m-- > 0;) {
        grid->item[--grid->start[grid->cell_of[m]]] = member[m];
    }
}
