/* pairs_lanes.c -- the ball test of the broad phase, several pairs at a time. */
#include "core/tank/pairs_lanes.h"

#include "core/base/mem.h"
#include "core/tank/body_lanes.h"

#define ROUNDING 1.00001f /* Tolerance for roots and products, so that no ball is too small. */

/* Factor on the margins: 0 if only the bodies count. */
static inline float spaces_of(const struct pairs_of *of)
{
    return of->bodies_only ? 0.0f : 1.0f;
}

/* Loads the bodies of LANES members and their reaches. */
static inline flanes load_members(struct bodies *all, const struct pairs_of *of,
                                  const fish_index *member)
{
    uint32_t fish[LANES];
    float reach_m[LANES];
    for (uint32_t lane = 0; lane < LANES; lane++) {
        fish[lane] = member[lane];
        reach_m[lane] = of->reach_m[member[lane]];
    }
    bodies_load(all, of->body, fish);
    all->back[3] *= spaces_of(of);
    return lanes_load(reach_m);
}

static inline flanes length_of(flanes x, flanes y, flanes z)
{
    return lanes_sqrt(x * x + y * y + z * z);
}

/* Returns the radius of the ball that encloses the personal space and the body with its reach. */
static inline flanes ball_of(const struct bodies *all, flanes reach)
{
    const flanes x = all->centre[3], y = all->right[3], z = all->up[3], margin = all->back[3];
    return ROUNDING * lanes_max(length_of(x + margin, y + margin, z + margin),
                                length_of(x, y, z) + reach);
}

/* Returns half the height of the personal space and of the body with its reach. */
static inline flanes slab_of(const struct bodies *all, flanes reach)
{
    const flanes x = lanes_abs(all->right[1]), y = lanes_abs(all->up[1]),
                 z = lanes_abs(all->back[1]);
    const flanes height = x * all->centre[3] + y * all->right[3] + z * all->up[3];
    return ROUNDING * (height + lanes_max(all->back[3] * (x + y + z), reach));
}

PAIRS_MEASURE(LANES_NAME(pairs_measure))
{
    flanes most = lanes_of(0.0f);
    for (uint32_t m = 0; m < count; m += LANES) {
        struct bodies all;
        const flanes reach = load_members(&all, of, &member[m]);
        lanes_store(&pairs->x_m[m], all.centre[0]);
        lanes_store(&pairs->z_m[m], all.centre[2]);
        most = lanes_max(most, ball_of(&all, reach));
    }
    float farthest_m = most[0];
    for (uint32_t lane = 1; lane < LANES; lane++) {
        farthest_m = f_max(farthest_m, most[lane]);
    }
    return farthest_m;
}

/* Computes cells as grid_cell() does. */
PAIRS_CELLS(LANES_NAME(pairs_cells))
{
    struct grid *grid = &pairs->grid;
    const float across = (float)(grid->columns - 1u), along = (float)(grid->rows - 1u);
    for (uint32_t m = 0; m < count; m += LANES) {
        const flanes x = (lanes_load(&pairs->x_m[m]) - grid->origin_x_m) * grid->cells_per_m;
        const flanes z = (lanes_load(&pairs->z_m[m]) - grid->origin_z_m) * grid->cells_per_m;
        const flanes column = lanes_clamp(x, lanes_of(0.0f), lanes_of(across));
        const flanes row = lanes_clamp(z, lanes_of(0.0f), lanes_of(along));
        const ilanes cell = __builtin_convertvector(row, ilanes) * (int32_t)grid->columns +
                            __builtin_convertvector(column, ilanes);
        int32_t cells[LANES];
        MEM_COPY(cells, &cell, sizeof cells);
        for (uint32_t lane = 0; lane < LANES; lane++) {
            grid->cell_of[m + lane] = (fish_index)cells[lane];
        }
    }
}

/* Prefetches LANES bodies from item `k` on. In a large tank they are scattered in memory. */
static inline void call_bodies(const struct body *body, const fish_index *item, uint32_t k,
                               uint32_t count)
{
    for (uint32_t lane = 0; lane < LANES && k + lane < count; lane++) {
        __builtin_prefetch(&body[item[k + lane]]);
    }
}

PAIRS_COLUMNS(LANES_NAME(pairs_columns))
{
    const struct grid *grid = &pairs->grid;
    for (uint32_t k = 0; k < grid->count; k += LANES) {
        call_bodies(of->body, grid->item, k + PAIRS_AHEAD, grid->count);
        struct bodies all;
        const flanes reach = load_members(&all, of, &grid->item[k]);
        lanes_store(&pairs->x_m[k], all.centre[0]);
        lanes_store(&pairs->y_m[k], all.centre[1]);
        lanes_store(&pairs->z_m[k], all.centre[2]);
        lanes_store(&pairs->ball_m[k], ball_of(&all, reach));
        lanes_store(&pairs->slab_m[k], slab_of(&all, reach));
    }
}

typedef uint32_t uquad __attribute__((vector_size(16)));

/* Writes the positions of the set bits of four and returns their number. */
static inline uint32_t keep_four(uint32_t *to, uint32_t from, uint32_t bits)
{
    static const uquad place[16] = {
        { 0 },       { 0 },       { 1 },       { 0, 1 },    { 2 },       { 0, 2 },
        { 1, 2 },    { 0, 1, 2 }, { 3 },       { 0, 3 },    { 1, 3 },    { 0, 1, 3 },
        { 2, 3 },    { 0, 2, 3 }, { 1, 2, 3 }, { 0, 1, 2, 3 },
    };
    static const uint8_t count[16] = { 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4 };
    const uquad places = place[bits] + from;
    MEM_COPY(to, &places, sizeof places);
    return count[bits];
}

/* The item whose neighbours are searched: ball, height, and reach to the sides, where the body is
 * thinnest. */
struct seeker {
    float x_m, y_m, z_m, ball_m, slab_m;
    vec3 right;
    float side_m;
};

static inline struct seeker seeker_of(const struct pairs *pairs, const struct pairs_of *of,
                                      uint32_t item)
{
    const uint32_t fish = pairs->grid.item[item];
    const struct body *body = &of->body[fish];
    const float space_m = spaces_of(of) * body->margin_m;
    const float side_m = body->half_x_m + f_max(space_m, of->reach_m[fish]);
    return (struct seeker){
        pairs->x_m[item],    pairs->y_m[item], pairs->z_m[item],  pairs->ball_m[item],
        pairs->slab_m[item], body->right,      ROUNDING * side_m,
    };
}

/* Returns one bit for each of the next LANES items that is near. */
static inline uint32_t sieve(const struct pairs *pairs, const struct seeker *me, uint32_t from,
                             uint32_t to)
{
#ifdef LANES_WIDE
    const ilanes lane = { 0, 1, 2, 3, 4, 5, 6, 7 };
#else
    const ilanes lane = { 0, 1, 2, 3 };
#endif
    const flanes x = lanes_load(&pairs->x_m[from]) - me->x_m;
    const flanes y = lanes_load(&pairs->y_m[from]) - me->y_m;
    const flanes z = lanes_load(&pairs->z_m[from]) - me->z_m;
    const flanes ball = lanes_load(&pairs->ball_m[from]), balls = ball + me->ball_m;
    const flanes slabs = lanes_load(&pairs->slab_m[from]) + me->slab_m;
    const flanes beside = x * me->right.x + y * me->right.y + z * me->right.z;
    return lanes_bits((x * x + y * y + z * z < balls * balls) & (lanes_abs(y) < slabs) &
                      (lanes_abs(beside) < ball + me->side_m) & (lane < (int32_t)(to - from)));
}

/* Appends the near ones of LANES items as pairs with `item`. Returns the new number of pairs. */
static inline uint32_t note(struct pairs *pairs, uint32_t noted, uint32_t item, uint32_t from,
                            uint32_t bits)
{
    const uquad me = item - (uquad){ 0 };
    for (uint32_t i = 0; i < LANES; i += 4u) {
        MEM_COPY(&pairs->near_a[noted + i], &me, sizeof me);
    }
    noted += keep_four(&pairs->near_b[noted], from, bits & 15u);
#ifdef LANES_WIDE
    noted += keep_four(&pairs->near_b[noted], from + 4u, bits >> 4);
#endif
    return noted;
}

/* Appends the near items of a range as pairs with `item`, except those before *other. Returns 0 if
 * the list is full; *other is then the item at which to continue. */
static inline int note_range(struct pairs *pairs, const struct seeker *me, uint32_t item,
                             struct grid_range range, uint32_t *noted, uint32_t *other)
{
    uint32_t from = range.from > *other ? range.from : *other, n = *noted;
    for (; from < range.to && n <= PAIRS_BATCH - LANES; from += LANES) {
        n = note(pairs, n, item, from, sieve(pairs, me, from, range.to));
    }
    *noted = n;
    *other = from < range.to ? from : *other;
    return from >= range.to;
}

PAIRS_NEAR(LANES_NAME(pairs_near))
{
    const struct grid *grid = &pairs->grid;
    const int by_cells = pairs->search == PAIRS_GRID;
    uint32_t item = pairs->item, other = pairs->other, noted = 0;
    uint32_t end = by_cells ? item : grid->count; /* End of the items of the current cell. */
    struct grid_range range[2] = { { 0, grid->count }, { 0, 0 } };
    for (; item < grid->count; item++, other = 0) {
        if (item >= end) {
            pairs->cell = grid_cell_of_item(grid, item, pairs->cell);
            end = grid->start[pairs->cell + 1u];
            range[0] = grid_beside(grid, pairs->cell);
            range[1] = grid_below(grid, pairs->cell);
        }
        const struct seeker me = seeker_of(pairs, of, item);
        range[0].from = item + 1u;
        int room = 1;
        for (uint32_t r = 0; r < 2u && room; r++) {
            room = note_range(pairs, &me, item, range[r], &noted, &other);
        }
        if (!room) {
            break;
        }
    }
    pairs->item = item;
    pairs->other = other;
    pairs->near_count = noted;
}
