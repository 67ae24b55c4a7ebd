/* pairs.c -- the order of a pair search: sort, filter, narrow phase. */
#include "core/tank/pairs.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/tank/pairs_lanes.h"

/* Writes the fish to search into `member`, then repeats some of them to fill the last SIMD
 * block. */
static uint32_t gather(fish_index member[TANK_FISH_MAX + LANES_MAX], const struct pairs_of *of)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < of->count; i++) {
        member[count] = (fish_index)i;
        count += (of->flags[i] & of->which) != 0;
    }
    for (uint32_t lane = 0; lane < LANES_MAX; lane++) {
        member[count + lane] = count > 0 ? member[count - 1u] : 0;
    }
    return count;
}

void pairs_begin(struct pairs *pairs, const struct pairs_of *of)
{
    CORE_ASSERT(of->count <= TANK_FISH_MAX);
    CORE_ASSERT(lanes_built(of->lanes));
    struct grid *grid = &pairs->grid;
    pairs->cell = 0;
    pairs->item = 0;
    pairs->other = 0;
    pairs->search = of->search;
    const uint32_t count = gather(pairs->member, of);
    if (count == 0) {
        grid->count = 0;
        return;
    }
    const float ball_m = LANES_PICK(of->lanes, pairs_measure)(pairs, of, pairs->member, count);
    grid_layout(grid, of->width_m, of->breadth_m, 2.0f * ball_m, of->count);
    LANES_PICK(of->lanes, pairs_cells)(pairs, count);
    grid_sort(grid, pairs->member, count);
    for (uint32_t lane = 0; lane < LANES_MAX; lane++) {
        grid->item[count + lane] = grid->item[count - 1u];
    }
    LANES_PICK(of->lanes, pairs_columns)(pairs, of);
}

int pairs_next(struct pairs *pairs, const struct pairs_of *of, struct found *found,
               uint32_t *count)
{
    LANES_PICK(of->lanes, pairs_near)(pairs, of);
    for (uint32_t lane = 0; lane < LANES_MAX; lane++) {
        pairs->near_a[pairs->near_count + lane] = 0;
        pairs->near_b[pairs->near_count + lane] = 0;
    }
    *count = LANES_PICK(of->lanes, pairs_judge)(pairs, of, found);
    return pairs->near_count > 0;
}

void pairs_gaps(const struct body *body, const fish_index *a, const fish_index *b, uint32_t count,
                uint8_t lanes, float *gap_m)
{
    CORE_ASSERT(lanes_built(lanes));
    LANES_PICK(lanes, pairs_gaps)(body, a, b, count, gap_m);
}

vec3 pairs_axis(const struct body *a, const struct body *b, uint8_t axis)
{
    const struct basis axes_a = { a->right, a->up, a->back },
                       axes_b = { b->right, b->up, b->back };
    return box_axis(&axes_a, &axes_b, v3_sub(b->centre_m, a->centre_m), axis);
}
