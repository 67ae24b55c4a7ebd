/* narrow_phase.c -- the steps of a pair search: sorts the fish into cells, filters the pairs, and
 * tests the boxes of the remaining pairs. */
#include "core/tank/collision/narrow_phase.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/tank/collision/narrow_phase_simd.h"

/* Writes the indices of the fish that the search includes to `member` and returns their number.
 * Fills the rest of the last SIMD block with the last index. */
static uint32_t gather_members(fish_index member[TANK_FISH_MAX + SIMD_LANES_MAX],
                               const struct narrow_phase_query *of)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < of->count; i++) {
        member[count] = (fish_index)i;
        count += (of->flags[i] & of->which) != 0;
    }
    for (uint32_t lane = 0; lane < SIMD_LANES_MAX; lane++) {
        member[count + lane] = count > 0 ? member[count - 1u] : 0;
    }
    return count;
}

void narrow_phase_begin(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of)
{
    CORE_ASSERT(of->count <= TANK_FISH_MAX);
    CORE_ASSERT(simd_is_built(of->lanes));
    struct spatial_grid *grid = &narrow_phase->grid;
    narrow_phase->cell = 0;
    narrow_phase->item = 0;
    narrow_phase->other = 0;
    narrow_phase->search = of->search;
    const uint32_t count = gather_members(narrow_phase->member, of);
    if (count == 0) {
        grid->count = 0;
        return;
    }
    const float ball_m =
        SIMD_PICK(of->lanes, narrow_phase_measure)(narrow_phase, of, narrow_phase->member, count);
    spatial_grid_layout(grid, of->width_m, of->breadth_m, 2.0f * ball_m, of->count);
    SIMD_PICK(of->lanes, narrow_phase_cells)(narrow_phase, count);
    spatial_grid_sort(grid, narrow_phase->member, count);
    for (uint32_t lane = 0; lane < SIMD_LANES_MAX; lane++) {
        grid->item[count + lane] = grid->item[count - 1u];
    }
    SIMD_PICK(of->lanes, narrow_phase_columns)(narrow_phase, of);
}

int narrow_phase_next(struct narrow_phase *narrow_phase, const struct narrow_phase_query *of,
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
