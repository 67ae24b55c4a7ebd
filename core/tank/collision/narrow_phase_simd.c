/* narrow_phase_simd.c -- the first step of the pair search: tests whether the search volumes of
 * bodies overlap, for several pairs at a time. */
#include "core/tank/collision/narrow_phase_simd.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

/* Factor on the size of a search volume. With this factor, rounding errors never make the volume
 * too small. */
#define ROUNDING 1.00001f

/* Loads the bodies of SIMD_LANES fish, whose indices are in `member`, and returns their reaches. */
static inline flanes load_members(struct body_simd *all, const struct narrow_phase_query *of,
                                  const fish_index *member)
{
    uint32_t fish[SIMD_LANES];
    float reach_m[SIMD_LANES];
    for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
        fish[lane] = member[lane];
        reach_m[lane] = of->reach_m[member[lane]];
    }
    body_simd_load(all, of->body, fish);
    all->back[3] *= of->bodies_only ? 0.0f : 1.0f;
    return simd_load(reach_m);
}

static inline flanes length_of(flanes x, flanes y, flanes z)
{
    return simd_sqrt(x * x + y * y + z * z);
}

/* Returns the radius of the ball around a body's centre that contains both the personal space and
 * the body enlarged by its reach. */
static inline flanes ball_of(const struct body_simd *all, flanes reach)
{
    const flanes x = all->centre[3], y = all->right[3], z = all->up[3], margin = all->back[3];
    return ROUNDING *
           simd_max(length_of(x + margin, y + margin, z + margin), length_of(x, y, z) + reach);
}

NARROW_PHASE_MEASURE(SIMD_NAME(narrow_phase_measure))
{
    CORE_ASSERT(count > 0 && count <= TANK_FISH_MAX);
    flanes most = simd_splat(0.0f);
    for (uint32_t m = 0; m < count; m += SIMD_LANES) {
        struct body_simd all;
        const flanes reach = load_members(&all, of, &member[m]);
        simd_store(&narrow_phase->x_m[m], all.centre[0]);
        simd_store(&narrow_phase->z_m[m], all.centre[2]);
        most = simd_max(most, ball_of(&all, reach));
    }
    float farthest_m = most[0];
    for (uint32_t lane = 1; lane < SIMD_LANES; lane++) {
        farthest_m = f_max(farthest_m, most[lane]);
    }
    return farthest_m;
}

/* Computes the grid cell of each fish in the search. A fish outside the floor plan belongs to the
 * nearest cell at the border. The position is clamped before the conversion, so that the float
 * never exceeds the range of the integer. */
NARROW_PHASE_CELLS(SIMD_NAME(narrow_phase_cells))
{
    CORE_ASSERT(narrow_phase->grid.columns > 0 && narrow_phase->grid.rows > 0);
    struct spatial_grid *grid = &narrow_phase->grid;
    const float across = (float)(grid->columns - 1u), along = (float)(grid->rows - 1u);
    for (uint32_t m = 0; m < count; m += SIMD_LANES) {
        const flanes x = (simd_load(&narrow_phase->x_m[m]) - grid->origin_x_m) * grid->cells_per_m;
        const flanes z = (simd_load(&narrow_phase->z_m[m]) - grid->origin_z_m) * grid->cells_per_m;
        const flanes column = simd_clamp(x, simd_splat(0.0f), simd_splat(across));
        const flanes row = simd_clamp(z, simd_splat(0.0f), simd_splat(along));
        const ilanes cell = __builtin_convertvector(row, ilanes) * (int32_t)grid->columns +
                            __builtin_convertvector(column, ilanes);
        int32_t cells[SIMD_LANES];
        MEM_COPY(cells, &cell, sizeof cells);
        for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
            grid->cell_of[m + lane] = (fish_index)cells[lane];
        }
    }
}

NARROW_PHASE_COLUMNS(SIMD_NAME(narrow_phase_columns))
{
    CORE_ASSERT(narrow_phase->grid.count <= TANK_FISH_MAX);
    const struct spatial_grid *grid = &narrow_phase->grid;
    for (uint32_t k = 0; k < grid->count; k += SIMD_LANES) {
        /* In a large tank the bodies are scattered in memory, so the loop prefetches the bodies of
         * a later iteration. */
        const uint32_t then = k + NARROW_PHASE_PREFETCH;
        for (uint32_t lane = 0; lane < SIMD_LANES && then + lane < grid->count; lane++) {
            __builtin_prefetch(&of->body[grid->item[then + lane]]);
        }
        struct body_simd all;
        const flanes reach = load_members(&all, of, &grid->item[k]);
        simd_store(&narrow_phase->x_m[k], all.centre[0]);
        simd_store(&narrow_phase->y_m[k], all.centre[1]);
        simd_store(&narrow_phase->z_m[k], all.centre[2]);
        simd_store(&narrow_phase->ball_m[k], ball_of(&all, reach));
        /* Stores half the height of each body's search volume, which contains both the personal
         * space and the body enlarged by its reach. */
        const flanes x = simd_abs(all.right[1]), y = simd_abs(all.up[1]), z = simd_abs(all.back[1]);
        const flanes height = x * all.centre[3] + y * all.right[3] + z * all.up[3];
        simd_store(&narrow_phase->slab_m[k],
                   ROUNDING * (height + simd_max(all.back[3] * (x + y + z), reach)));
    }
}

typedef uint32_t uquad __attribute__((vector_size(16)));

/* Writes the number `from` + n to the array `to` for each bit n that is set in the four-bit mask
 * `bits`. Returns the number of set bits. */
static inline uint32_t keep_four(uint32_t *to, uint32_t from, uint32_t bits)
{
    static const uquad place[16] = {
        { 0 }, { 0 },    { 1 },    { 0, 1 },    { 2 },    { 0, 2 },    { 1, 2 },    { 0, 1, 2 },
        { 3 }, { 0, 3 }, { 1, 3 }, { 0, 1, 3 }, { 2, 3 }, { 0, 2, 3 }, { 1, 2, 3 }, { 0, 1, 2, 3 },
    };
    static const uint8_t count[16] = { 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4 };
    const uquad places = place[bits] + from;
    MEM_COPY(to, &places, sizeof places);
    return count[bits];
}

/* The fish for which the search seeks nearby fish. `ball_m` and `slab_m` are the radius and half
 * the height of the fish's search volume. `side_m` is the half width of this volume along `right`,
 * the direction in which the body is thinnest. */
struct seeker {
    float x_m, y_m, z_m, ball_m, slab_m;
    vec3 right;
    float side_m;
};

static inline struct seeker seeker_of(const struct narrow_phase *narrow_phase,
                                      const struct narrow_phase_query *of, uint32_t item)
{
    const uint32_t fish = narrow_phase->grid.item[item];
    const struct body *body = &of->body[fish];
    const float space_m = (of->bodies_only ? 0.0f : 1.0f) * body->margin_m;
    const float side_m = body->half_x_m + f_max(space_m, of->reach_m[fish]);
    return (struct seeker){
        narrow_phase->x_m[item],    narrow_phase->y_m[item],    narrow_phase->z_m[item],
        narrow_phase->ball_m[item], narrow_phase->slab_m[item], body->right,
        ROUNDING * side_m,
    };
}

/* Tests which fish are near the fish `me`. Returns a mask whose bit n stands for the item `from` +
 * n, for at most SIMD_LANES items below `to`. A bit is 1 if the search volumes of the two fish
 * could overlap. */
static inline uint32_t near_mask(const struct narrow_phase *narrow_phase, const struct seeker *me,
                                 uint32_t from, uint32_t to)
{
#ifdef SIMD_WIDE
    const ilanes lane = { 0, 1, 2, 3, 4, 5, 6, 7 };
#else
    const ilanes lane = { 0, 1, 2, 3 };
#endif
    const flanes x = simd_load(&narrow_phase->x_m[from]) - me->x_m;
    const flanes y = simd_load(&narrow_phase->y_m[from]) - me->y_m;
    const flanes z = simd_load(&narrow_phase->z_m[from]) - me->z_m;
    const flanes ball = simd_load(&narrow_phase->ball_m[from]), balls = ball + me->ball_m;
    const flanes slabs = simd_load(&narrow_phase->slab_m[from]) + me->slab_m;
    const flanes beside = x * me->right.x + y * me->right.y + z * me->right.z;
    return simd_bits((x * x + y * y + z * z < balls * balls) & (simd_abs(y) < slabs) &
                     (simd_abs(beside) < ball + me->side_m) & (lane < (int32_t)(to - from)));
}

/* Appends pairs of fish to the list of nearby pairs: `item` with each item whose bit is set in
 * `bits`. Bit 0 stands for the item `from`. `noted` is the old length of the list. Returns the new
 * length. */
static inline uint32_t note_near_pairs(struct narrow_phase *narrow_phase, uint32_t noted,
                                       uint32_t item, uint32_t from, uint32_t bits)
{
    const uquad me = item - (uquad){ 0 };
    for (uint32_t i = 0; i < SIMD_LANES; i += 4u) {
        MEM_COPY(&narrow_phase->near_a[noted + i], &me, sizeof me);
    }
    noted += keep_four(&narrow_phase->near_b[noted], from, bits & 15u);
#ifdef SIMD_WIDE
    noted += keep_four(&narrow_phase->near_b[noted], from + 4u, bits >> 4);
#endif
    return noted;
}

/* Appends pairs of `item` and each nearby item of `range` to the list of nearby pairs. Begins at
 * item *other if that item is in the range. Returns 1 at the end of the range. Returns 0 if the
 * list is full, and sets *other to the item at which the next call continues. */
static inline int note_range(struct narrow_phase *narrow_phase, const struct seeker *me,
                             uint32_t item, struct grid_range range, uint32_t *noted,
                             uint32_t *other)
{
    uint32_t from = range.from > *other ? range.from : *other, n = *noted;
    for (; from < range.to && n <= NARROW_PHASE_BATCH - SIMD_LANES; from += SIMD_LANES) {
        n = note_near_pairs(narrow_phase, n, item, from,
                            near_mask(narrow_phase, me, from, range.to));
    }
    *noted = n;
    *other = from < range.to ? from : *other;
    return from >= range.to;
}

NARROW_PHASE_NEAR(SIMD_NAME(narrow_phase_near))
{
    CORE_ASSERT(narrow_phase->item <= narrow_phase->grid.count);
    const struct spatial_grid *grid = &narrow_phase->grid;
    const bool by_cells = narrow_phase->search == PAIR_SEARCH_GRID;
    uint32_t item = narrow_phase->item, other = narrow_phase->other, noted = 0;
    uint32_t end = by_cells ? item : grid->count; /* Index after the last item (fish) of the current
                                                     cell. */
    struct grid_range range[2] = { { 0, grid->count }, { 0, 0 } };
    for (; item < grid->count; item++, other = 0) {
        if (item >= end) {
            narrow_phase->cell = narrow_grid_cell_of_item(grid, item, narrow_phase->cell);
            end = grid->start[narrow_phase->cell + 1u];
            range[0] = narrow_grid_beside(grid, narrow_phase->cell);
            range[1] = narrow_grid_below(grid, narrow_phase->cell);
        }
        const struct seeker me = seeker_of(narrow_phase, of, item);
        range[0].from = item + 1u;
        int room = 1; /* The variable is an int, because a bool costs more instructions in this
                         loop. */
        for (uint32_t r = 0; r < 2u && room; r++) {
            room = note_range(narrow_phase, &me, item, range[r], &noted, &other);
        }
        if (!room) {
            break;
        }
    }
    narrow_phase->item = item;
    narrow_phase->other = other;
    narrow_phase->near_count = noted;
}
