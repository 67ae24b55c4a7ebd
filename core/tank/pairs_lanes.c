/* pairs_lanes.c -- balls against balls, then boxes against boxes, several pairs at a time. */
#include "core/tank/pairs_lanes.h"

#include "core/base/mem.h"

#define APART_M 1e9f
#define PARALLEL lanes_of(1e-6f) /* As in box.c. */
#define AHEAD (2u * LANES) /* Items or pairs: as long as memory takes. */
#define ROUNDING 1.00001f /* Of roots and products; no ball may be too small. */

/* Quad `quad` of a body, and in eight lanes that of the fourth after it beside it. */
static inline flanes load_row(const struct body *body, const uint32_t *fish, uint32_t quad)
{
    const size_t at = quad * sizeof(fquad);
    return lanes_load_beside((const char *)&body[fish[0]] + at,
                             (const char *)&body[fish[LANES - 4]] + at);
}

/* The same of LANES bodies, wherever they lie: column[m] is member m of all. */
static inline void load_quads(flanes column[4], const struct body *body, const uint32_t *fish,
                              uint32_t quad)
{
    lanes_turn(column, load_row(body, fish, quad), load_row(body, fish + 1, quad),
               load_row(body, fish + 2, quad), load_row(body, fish + 3, quad));
}

/* LANES bodies, as struct body names its members. */
struct bodies {
    flanes centre[4], right[4], up[4], back[4]; /* Vectors; [3] is a half size or the margin. */
};

static inline void load_bodies(struct bodies *all, const struct body *body, const uint32_t *fish)
{
    load_quads(all->centre, body, fish, 0);
    load_quads(all->right, body, fish, 1);
    load_quads(all->up, body, fish, 2);
    load_quads(all->back, body, fish, 3);
}

/* Members of the crowd, and how far from their skins they are felt. */
static inline flanes load_members(struct bodies *all, const struct pairs_of *of,
                                  const fish_index *member)
{
    uint32_t fish[LANES];
    float reach_m[LANES];
    for (uint32_t lane = 0; lane < LANES; lane++) {
        fish[lane] = member[lane];
        reach_m[lane] = of->reach_m[member[lane]];
    }
    load_bodies(all, of->body, fish);
    return lanes_load(reach_m);
}

static inline flanes length_of(flanes x, flanes y, flanes z)
{
    return lanes_sqrt(x * x + y * y + z * z);
}

/* The ball that holds the personal space, and the body's surroundings out to its reach. */
static inline flanes ball_of(const struct bodies *all, flanes reach)
{
    const flanes x = all->centre[3], y = all->right[3], z = all->up[3], margin = all->back[3];
    return ROUNDING * lanes_max(length_of(x + margin, y + margin, z + margin),
                                length_of(x, y, z) + reach);
}

/* Half the height of the same. */
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
        int32_t cells[LANES];
        MEM_COPY(cells, &cell, sizeof cells);
        for (uint32_t lane = 0; lane < LANES; lane++) {
            grid->cell_of[m + lane] = (fish_index)cells[lane];
        }
    }
}

/* Calls LANES bodies into the cache, from item `k` on: in a large tank they lie anywhere. */
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
        call_bodies(of->body, grid->item, k + AHEAD, grid->count);
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

/* Writes the places of those bits of four that are set, and returns how many. */
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

/* What the sieve knows of the one whose neighbours it seeks: its ball, its height, and how far it
 * is felt to its sides, where it is thinnest. */
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
    const float side_m = body->half_x_m + f_max(body->margin_m, of->reach_m[fish]);
    return (struct seeker){
        pairs->x_m[item],    pairs->y_m[item], pairs->z_m[item],  pairs->ball_m[item],
        pairs->slab_m[item], body->right,      ROUNDING * side_m,
    };
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
    const flanes x = lanes_load(&pairs->x_m[from]) - me->x_m;
    const flanes y = lanes_load(&pairs->y_m[from]) - me->y_m;
    const flanes z = lanes_load(&pairs->z_m[from]) - me->z_m;
    const flanes ball = lanes_load(&pairs->ball_m[from]), balls = ball + me->ball_m;
    const flanes slabs = lanes_load(&pairs->slab_m[from]) + me->slab_m;
    const flanes beside = x * me->right.x + y * me->right.y + z * me->right.z;
    return lanes_bits((x * x + y * y + z * z < balls * balls) & (lanes_abs(y) < slabs) &
                      (lanes_abs(beside) < ball + me->side_m) & (lane < (int32_t)(to - from)));
}

/* Notes the near ones of LANES items as pairs with `item`, and returns how many are noted then. */
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

/* Notes what is near `item` in a range, but for what lies before *other. Returns 0 when there is no
 * room for more: *other is then where to go on. */
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
    uint32_t end = by_cells ? item : grid->count; /* Of the cell. */
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

/* What the axes tried so far say of LANES pairs. Gaps are squared, their signs kept, so that an
 * axis that is no unit vector costs a division and no root; and the last four bits of a square are
 * the axis it belongs to, so that the largest brings its axis with it. */
struct verdict {
    flanes square; /* Of the gap between the bodies. */
    flanes space;  /* > 0: the spaces are apart; else the value means nothing. */
};

static inline flanes mark(flanes square, int32_t axis)
{
    return (flanes)(((ilanes)square & ~15) | axis);
}

/* One axis: how far apart the centres are along it, less what the bodies take of that, and less
 * what their margins take. */
static inline void try_face(struct verdict *verdict, flanes offset, flanes halves, flanes margins,
                            int32_t axis)
{
    const flanes gap = lanes_abs(offset) - halves;
    verdict->space = lanes_max(verdict->space, gap - margins);
    verdict->square = lanes_max(verdict->square, mark(gap * lanes_abs(gap), axis));
}

/* The axis' length is the root of `length2`: edges that are parallel to a thousandth have none
 * worth the name, and face normals have said it all. */
static inline void try_edges(struct verdict *verdict, flanes offset, flanes halves, flanes margins,
                             flanes length2, int32_t axis)
{
    const ilanes crossed = length2 > PARALLEL;
    const flanes gap = lanes_select(crossed, lanes_abs(offset) - halves, lanes_of(-APART_M));
    verdict->space = lanes_max(verdict->space, gap - margins);
    verdict->square =
        lanes_max(verdict->square, mark(gap * lanes_abs(gap) / lanes_max(length2, PARALLEL), axis));
}

static inline flanes dot(const flanes a[3], const flanes b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Cosines of a's axes against b's, with their magnitudes; and the way between the centres in a's
 * frame. */
struct view {
    flanes c[3][3], m[3][3], d[3];
};

static inline void view_row(struct view *view, int i, const flanes axis[3], const flanes way[3],
                            const struct bodies *b)
{
    view->d[i] = dot(way, axis);
    view->c[i][0] = dot(axis, b->right);
    view->c[i][1] = dot(axis, b->up);
    view->c[i][2] = dot(axis, b->back);
    view->m[i][0] = lanes_abs(view->c[i][0]);
    view->m[i][1] = lanes_abs(view->c[i][1]);
    view->m[i][2] = lanes_abs(view->c[i][2]);
}

#define FACE_A(i)                                                                                  \
    try_face(&verdict, view.d[i], ha[i] + dot(view.m[i], hb),                                      \
             ma + mb * (view.m[i][0] + view.m[i][1] + view.m[i][2]), i)

#define FACE_B(j)                                                                                  \
    try_face(&verdict,                                                                             \
             view.d[0] * view.c[0][j] + view.d[1] * view.c[1][j] + view.d[2] * view.c[2][j],       \
             hb[j] + (view.m[0][j] * ha[0] + view.m[1][j] * ha[1] + view.m[2][j] * ha[2]),         \
             mb + ma * (view.m[0][j] + view.m[1][j] + view.m[2][j]), 3 + j)

/* Edge i of a across edge j of b: p, q follow i and r, s follow j round the three axes. */
#define EDGES(i, p, q, j, r, s)                                                                    \
    try_edges(&verdict, view.d[q] * view.c[p][j] - view.d[p] * view.c[q][j],                       \
              ha[p] * view.m[q][j] + ha[q] * view.m[p][j] + hb[r] * view.m[i][s] +                 \
                  hb[s] * view.m[i][r],                                                            \
              ma * (view.m[q][j] + view.m[p][j]) + mb * (view.m[i][s] + view.m[i][r]),             \
              view.c[p][j] * view.c[p][j] + view.c[q][j] * view.c[q][j], 6 + 3 * i + j)

/* All fifteen axes, in the order in which pairs_axis() counts them. Never a call: that would pass a
 * kilobyte through memory. */
__attribute__((always_inline)) static inline struct verdict judge(const struct bodies *a,
                                                                  const struct bodies *b)
{
    struct verdict verdict = { lanes_of(-APART_M * APART_M), lanes_of(-APART_M) };
    const flanes ha[3] = { a->centre[3], a->right[3], a->up[3] }, ma = a->back[3];
    const flanes hb[3] = { b->centre[3], b->right[3], b->up[3] }, mb = b->back[3];
    const flanes way[3] = { b->centre[0] - a->centre[0], b->centre[1] - a->centre[1],
                            b->centre[2] - a->centre[2] };
    struct view view;
    view_row(&view, 0, a->right, way, b);
    view_row(&view, 1, a->up, way, b);
    view_row(&view, 2, a->back, way, b);
    FACE_A(0);
    FACE_A(1);
    FACE_A(2);
    FACE_B(0);
    FACE_B(1);
    FACE_B(2);
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

static inline flanes gap_of(const struct verdict *verdict)
{
    const flanes root = lanes_sqrt(lanes_abs(verdict->square));
    return lanes_select(verdict->square < 0.0f, -root, root);
}

PAIRS_GAPS(LANES_NAME(pairs_gaps))
{
    for (uint32_t n = 0; n < count; n += LANES) {
        uint32_t first[LANES], second[LANES];
        for (uint32_t lane = 0; lane < LANES; lane++) {
            first[lane] = a[n + lane];
            second[lane] = b[n + lane];
        }
        struct bodies all_a, all_b;
        load_bodies(&all_a, body, first);
        load_bodies(&all_b, body, second);
        const struct verdict verdict = judge(&all_a, &all_b);
        lanes_store(&gap_m[n], gap_of(&verdict));
    }
}

PAIRS_JUDGE(LANES_NAME(pairs_judge))
{
    const fish_index *item = pairs->grid.item;
    uint32_t kept = 0;
    for (uint32_t n = 0; n < pairs->near_count; n += LANES) {
        for (uint32_t lane = 0; lane < LANES && n + AHEAD + lane < pairs->near_count; lane++) {
            __builtin_prefetch(&of->body[item[pairs->near_b[n + AHEAD + lane]]]);
        }
        uint32_t first[LANES], second[LANES];
        for (uint32_t lane = 0; lane < LANES; lane++) {
            first[lane] = item[pairs->near_a[n + lane]];
            second[lane] = item[pairs->near_b[n + lane]];
        }
        struct bodies a, b;
        load_bodies(&a, of->body, first);
        load_bodies(&b, of->body, second);
        const struct verdict verdict = judge(&a, &b);
        const uint32_t meets = lanes_bits(verdict.space <= 0.0f);
        float gap_m[LANES];
        int32_t axis[LANES];
        lanes_store(gap_m, gap_of(&verdict));
        MEM_COPY(axis, &verdict.square, sizeof axis);
        for (uint32_t lane = 0; lane < LANES && n + lane < pairs->near_count; lane++) {
            const uint32_t i = first[lane], j = second[lane], meet = meets >> lane & 1u;
            found[kept] = (struct found){ i, j, gap_m[lane], (uint8_t)(axis[lane] & 15),
                                          (uint8_t)meet };
            kept += meet | (gap_m[lane] < of->reach_m[i] + of->reach_m[j]);
        }
    }
    return kept;
}
