/* pairs_lanes.c -- balls against balls, then boxes against boxes, several pairs at a time. */
#include "core/tank/pairs_lanes.h"

#include "core/base/mem.h"

#define APART_M 1e9f
#define ROUNDING 1.00001f /* Of roots and products; a ball must not be too small. */

/* Quad `quad` of the bodies of LANES fish: column[m] is member m of all. */
static inline void load_quads(flanes column[4], const struct body *body, const uint32_t fish[LANES],
                              uint32_t quad)
{
    fquad row[LANES];
    for (uint32_t lane = 0; lane < LANES; lane++) {
        MEM_COPY(&row[lane], (const char *)&body[fish[lane]] + quad * sizeof(fquad), sizeof(fquad));
    }
#ifdef LANES_WIDE
    flanes wide[4];
    for (uint32_t r = 0; r < 4u; r++) {
        wide[r] = __builtin_shufflevector(row[r], row[r + 4u], 0, 1, 2, 3, 4, 5, 6, 7);
    }
#define LOW(a, b) __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define HIGH(a, b) __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#else
    const flanes *wide = row;
#define LOW(a, b) __builtin_shufflevector(a, b, 0, 4, 1, 5)
#define HIGH(a, b) __builtin_shufflevector(a, b, 2, 6, 3, 7)
#endif
    const flanes a = LOW(wide[0], wide[2]), b = LOW(wide[1], wide[3]);
    const flanes c = HIGH(wide[0], wide[2]), d = HIGH(wide[1], wide[3]);
    column[0] = LOW(a, b);
    column[1] = HIGH(a, b);
    column[2] = LOW(c, d);
    column[3] = HIGH(c, d);
#undef LOW
#undef HIGH
}

/* LANES bodies, as struct body names its members. */
struct bodies {
    flanes centre[4], right[4], up[4], back[4]; /* Vectors; [3] is a half size or the margin. */
    flanes reach;
};

static inline struct bodies load_bodies(const struct pairs_of *of, const uint32_t fish[LANES])
{
    struct bodies all;
    load_quads(all.centre, of->body, fish, 0);
    load_quads(all.right, of->body, fish, 1);
    load_quads(all.up, of->body, fish, 2);
    load_quads(all.back, of->body, fish, 3);
    for (uint32_t lane = 0; lane < LANES; lane++) {
        all.reach[lane] = of->reach_m[fish[lane]];
    }
    return all;
}

static inline struct bodies load_members(const struct pairs_of *of, const fish_index *member)
{
    uint32_t fish[LANES];
    for (uint32_t lane = 0; lane < LANES; lane++) {
        fish[lane] = member[lane];
    }
    return load_bodies(of, fish);
}

static inline flanes length_of(flanes x, flanes y, flanes z)
{
    return lanes_sqrt(x * x + y * y + z * z);
}

/* The ball that holds the personal space, and the body's surroundings out to its reach. */
static inline flanes ball_of(const struct bodies *all)
{
    const flanes x = all->centre[3], y = all->right[3], z = all->up[3], margin = all->back[3];
    return ROUNDING * lanes_max(length_of(x + margin, y + margin, z + margin),
                                length_of(x, y, z) + all->reach);
}

/* Half the height of the same. */
static inline flanes slab_of(const struct bodies *all)
{
    const flanes x = lanes_abs(all->right[1]), y = lanes_abs(all->up[1]),
                 z = lanes_abs(all->back[1]);
    const flanes height = x * all->centre[3] + y * all->right[3] + z * all->up[3];
    return ROUNDING * (height + lanes_max(all->back[3] * (x + y + z), all->reach));
}

PAIRS_MEASURE(LANES_NAME(pairs_measure))
{
    flanes most = lanes_of(0.0f);
    for (uint32_t m = 0; m < count; m += LANES) {
        const struct bodies all = load_members(of, &member[m]);
        lanes_store(&pairs->x_m[m], all.centre[0]);
        lanes_store(&pairs->z_m[m], all.centre[2]);
        most = lanes_max(most, ball_of(&all));
    }
    float farthest_m = most[0];
    for (uint32_t lane = 1; lane < LANES; lane++) {
        farthest_m = f_max(farthest_m, most[lane]);
    }
    return farthest_m;
}

/* As grid_cell(). */
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
        MEM_COPY(&grid->cell_of[m], &cell, sizeof cell);
    }
}

PAIRS_COLUMNS(LANES_NAME(pairs_columns))
{
    const struct grid *grid = &pairs->grid;
    for (uint32_t k = 0; k < grid->count; k += LANES) {
        const struct bodies all = load_members(of, &grid->item[k]);
        lanes_store(&pairs->x_m[k], all.centre[0]);
        lanes_store(&pairs->y_m[k], all.centre[1]);
        lanes_store(&pairs->z_m[k], all.centre[2]);
        lanes_store(&pairs->ball_m[k], ball_of(&all));
        lanes_store(&pairs->slab_m[k], slab_of(&all));
    }
}

/* Writes the places of those bits of four that are set, and returns how many. */
static inline uint32_t keep_four(uint32_t *to, uint32_t from, uint32_t bits)
{
    typedef uint32_t uquad __attribute__((vector_size(16)));
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

/* What the sieve knows of the one whose neighbours it seeks. */
struct seeker {
    flanes x, y, z, ball, slab;
};

static inline struct seeker seeker_of(const struct pairs *pairs, uint32_t item)
{
    return (struct seeker){ lanes_of(pairs->x_m[item]), lanes_of(pairs->y_m[item]),
                            lanes_of(pairs->z_m[item]), lanes_of(pairs->ball_m[item]),
                            lanes_of(pairs->slab_m[item]) };
}

/* One bit for each of the next LANES items that is near. */
static inline uint32_t sieve(const struct pairs *pairs, const struct seeker *me, uint32_t from,
                             uint32_t to)
{
#ifdef LANES_WIDE
    const ilanes lane = { 0, 1, 2, 3, 4, 5, 6, 7 };
#else
    const ilanes lane = { 0, 1, 2, 3 };
#endif
    const flanes x = lanes_load(&pairs->x_m[from]) - me->x;
    const flanes y = lanes_load(&pairs->y_m[from]) - me->y;
    const flanes z = lanes_load(&pairs->z_m[from]) - me->z;
    const flanes balls = lanes_load(&pairs->ball_m[from]) + me->ball;
    const flanes slabs = lanes_load(&pairs->slab_m[from]) + me->slab;
    return lanes_bits((x * x + y * y + z * z < balls * balls) & (lanes_abs(y) < slabs) &
                      (lane < (int32_t)(to - from)));
}

/* Adds the near ones of [from, to), but for those before pairs->other. Returns 0 when there is no
 * room for more: pairs->other is then where to go on. */
static inline int sieve_range(struct pairs *pairs, const struct seeker *me, uint32_t from,
                              uint32_t to)
{
    uint32_t other = from > pairs->other ? from : pairs->other, n = pairs->near_count;
    for (; other < to && n <= PAIRS_BATCH - LANES; other += LANES) {
        const uint32_t bits = sieve(pairs, me, other, to), before = n;
        n += keep_four(&pairs->near_b[n], other, bits & 15u);
#ifdef LANES_WIDE
        n += keep_four(&pairs->near_b[n], other + 4u, bits >> 4);
#endif
        for (uint32_t i = before; i < before + LANES; i += 4u) {
            const uint32_t item[4] = { pairs->item, pairs->item, pairs->item, pairs->item };
            MEM_COPY(&pairs->near_a[i], item, sizeof item);
        }
    }
    pairs->near_count = n;
    if (other < to) {
        pairs->other = other;
    }
    return other >= to;
}

PAIRS_NEAR(LANES_NAME(pairs_near))
{
    const struct grid *grid = &pairs->grid;
    const struct grid_range none = { grid->count, grid->count }, all = { 0, grid->count };
    struct grid_range beside = all, below = none;
    uint32_t end = pairs->search == PAIRS_GRID ? pairs->item : grid->count; /* Of the cell. */
    pairs->near_count = 0;
    for (; pairs->item < grid->count; pairs->item++) {
        if (pairs->item >= end) {
            pairs->cell = grid_cell_of_item(grid, pairs->item, pairs->cell);
            end = grid->start[pairs->cell + 1u];
            beside = grid_beside(grid, pairs->cell);
            below = grid_below(grid, pairs->cell);
        }
        const struct seeker me = seeker_of(pairs, pairs->item);
        if (!sieve_range(pairs, &me, pairs->item + 1u, beside.to) ||
            !sieve_range(pairs, &me, below.from, below.to)) {
            return;
        }
        pairs->other = 0;
    }
}

/* What the axes tried so far say of LANES pairs. */
struct verdict {
    flanes gap;   /* Of the bodies. */
    flanes space; /* > 0: the spaces are apart; else the value means nothing. */
    ilanes axis;
};

/* One axis: how far apart the centres are along it, less what the bodies take of that. */
static inline void try_axis(struct verdict *verdict, flanes gap, int32_t axis)
{
    const ilanes better = gap > verdict->gap;
    verdict->gap = lanes_select(better, gap, verdict->gap);
    verdict->axis = (better & axis) | (~better & verdict->axis);
}

static inline void try_face(struct verdict *verdict, flanes offset, flanes halves, flanes margins,
                            int32_t axis)
{
    const flanes gap = lanes_abs(offset) - halves;
    verdict->space = lanes_max(verdict->space, gap - margins);
    try_axis(verdict, gap, axis);
}

/* `square` is that of the cross product's length: edges that are parallel to a thousandth have none
 * worth the name, and face normals have said it all. */
static inline void try_edges(struct verdict *verdict, flanes offset, flanes halves, flanes margins,
                             flanes square, int32_t axis)
{
    const ilanes crossed = square > 1e-6f;
    const flanes gap = lanes_abs(offset) - halves;
    verdict->space =
        lanes_select(crossed, lanes_max(verdict->space, gap - margins), verdict->space);
    const flanes true_gap = gap / lanes_sqrt(square);
    try_axis(verdict, lanes_select(crossed, true_gap, lanes_of(-APART_M)), axis);
}

static inline flanes dot(const flanes a[3], const flanes b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Edges i of a and j of b: p, q follow i and r, s follow j round the three axes. `c` are cosines of
 * a's axes against b's, `m` their magnitudes, `d` the way between the centres in a's frame. */
#define EDGES(i, p, q, j, r, s)                                                                    \
    try_edges(&verdict, d[q] * c[p][j] - d[p] * c[q][j],                                           \
              ha[p] * m[q][j] + ha[q] * m[p][j] + hb[r] * m[i][s] + hb[s] * m[i][r],               \
              ma * (m[q][j] + m[p][j]) + mb * (m[i][s] + m[i][r]),                                 \
              c[p][j] * c[p][j] + c[q][j] * c[q][j], 6 + 3 * i + j)

/* All fifteen axes, in the order in which pairs_axis() counts them. */
static inline struct verdict judge(const struct bodies *a, const struct bodies *b)
{
    struct verdict verdict = { lanes_of(-APART_M), lanes_of(-APART_M), { 0 } };
    const flanes *const axes_a[3] = { a->right, a->up, a->back };
    const flanes *const axes_b[3] = { b->right, b->up, b->back };
    const flanes ha[3] = { a->centre[3], a->right[3], a->up[3] }, ma = a->back[3];
    const flanes hb[3] = { b->centre[3], b->right[3], b->up[3] }, mb = b->back[3];
    const flanes way[3] = { b->centre[0] - a->centre[0], b->centre[1] - a->centre[1],
                            b->centre[2] - a->centre[2] };
    flanes c[3][3], m[3][3], d[3];
    for (int i = 0; i < 3; i++) {
        d[i] = dot(way, axes_a[i]);
        for (int j = 0; j < 3; j++) {
            c[i][j] = dot(axes_a[i], axes_b[j]);
            m[i][j] = lanes_abs(c[i][j]);
        }
    }
    for (int i = 0; i < 3; i++) {
        try_face(&verdict, d[i], ha[i] + dot(m[i], hb), ma + mb * (m[i][0] + m[i][1] + m[i][2]),
                 i);
    }
    for (int j = 0; j < 3; j++) {
        const flanes column[3] = { c[0][j], c[1][j], c[2][j] };
        const flanes sizes[3] = { m[0][j], m[1][j], m[2][j] };
        try_face(&verdict, dot(d, column), hb[j] + dot(sizes, ha),
                 mb + ma * (sizes[0] + sizes[1] + sizes[2]), 3 + j);
    }
    EDGES(0, 1, 2, 0, 1, 2);
    EDGES(0, 1, 2, 1, 2, 0);
    EDGES(0, 1, 2, 2, 0, 1);
    EDGES(1, 2, 0, 0, 1, 2);
    EDGES(1, 2, 0, 1, 2, 0);
    EDGES(1, 2, 0, 2, 0, 1);
    EDGES(2, 0, 1, 0, 1, 2);
    EDGES(2, 0, 1, 1, 2, 0);
    EDGES(2, 0, 1, 2, 0, 1);
    return verdict;
}

PAIRS_JUDGE(LANES_NAME(pairs_judge))
{
    const fish_index *item = pairs->grid.item;
    uint32_t kept = 0;
    for (uint32_t n = 0; n < pairs->near_count; n += LANES) {
        uint32_t first[LANES], second[LANES];
        for (uint32_t lane = 0; lane < LANES; lane++) {
            first[lane] = item[pairs->near_a[n + lane]];
            second[lane] = item[pairs->near_b[n + lane]];
        }
        const struct bodies a = load_bodies(of, first), b = load_bodies(of, second);
        const struct verdict verdict = judge(&a, &b);
        const ilanes meets = verdict.space <= 0.0f;
        const ilanes keeps = meets | (verdict.gap < a.reach + b.reach);
        const uint32_t left = pairs->near_count - n;
        for (uint32_t lane = 0; lane < LANES; lane++) {
            found[kept] = (struct found){ first[lane], second[lane], verdict.gap[lane],
                                          (uint8_t)verdict.axis[lane], meets[lane] != 0 };
            kept += (uint32_t)(keeps[lane] & 1) & (lane < left);
        }
    }
    return kept;
}
