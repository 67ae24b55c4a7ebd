/* narrow_phase_boxes_simd.c -- computes the separating-axis test of box.c for several pairs of
 * boxes at a time. */
#include "core/tank/collision/narrow_phase_simd.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

#define APART_M 1e9f
/* Squared length of a cross product below which two edges count as parallel, as in box.c. */
#define PARALLEL simd_splat(1e-6f)

/* Intermediate result of the separating-axis test for SIMD_LANES pairs of boxes at once. The test
 * computes the gap between the projections of the two boxes on one axis after the other, and keeps
 * the largest gap. A negative gap means that the projections overlap.
 *
 * A gap is stored as its square with the sign of the gap, which saves a square root per axis. The
 * last four bits of the square are replaced by the index of the axis. Therefore the maximum of the
 * squares also selects the axis. */
struct separation {
    flanes square; /* Square of the largest gap between the bodies over the axes tested so far, with
                      the sign of the gap. */
    flanes space;  /* Largest gap between the personal spaces over the axes tested so far. If the
                      value is positive, the spaces are apart. */
};

static inline flanes mark_axis(flanes square, int32_t axis)
{
    return (flanes)(((ilanes)square & ~15) | axis);
}

/* Tests one face axis as a separating axis. `offset` is the distance of the centres along the axis,
 * `halves` the sum of the projected half sizes and `margins` the sum of the projected margins. */
static inline void try_face(struct separation *separation, flanes offset, flanes halves,
                            flanes margins, int32_t axis)
{
    const flanes gap = simd_abs(offset) - halves;
    separation->space = simd_max(separation->space, gap - margins);
    separation->square = simd_max(separation->square, mark_axis(gap * simd_abs(gap), axis));
}

/* Tests one cross product of edges as a separating axis. The squared length of the cross product is
 * `length2`. Nearly parallel edges are skipped, because their cross product is nearly zero. The
 * face axes already cover that case. */
static inline void try_edges(struct separation *separation, flanes offset, flanes halves,
                             flanes margins, flanes length2, int32_t axis)
{
    const ilanes crossed = length2 > PARALLEL;
    const flanes gap = simd_select(crossed, simd_abs(offset) - halves, simd_splat(-APART_M));
    separation->space = simd_max(separation->space, gap - margins);
    separation->square = simd_max(
        separation->square, mark_axis(gap * simd_abs(gap) / simd_max(length2, PARALLEL), axis));
}

static inline flanes dot_lanes(const flanes a[3], const flanes b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Cosines `c` between the axes of box a and the axes of box b, their magnitudes `m`, and the vector
 * `d` between the centres in the coordinates of box a. */
struct view {
    flanes c[3][3], m[3][3], d[3];
};

static inline void view_row(struct view *view, int i, const flanes axis[3], const flanes way[3],
                            const struct body_simd *b)
{
    view->d[i] = dot_lanes(way, axis);
    view->c[i][0] = dot_lanes(axis, b->right);
    view->c[i][1] = dot_lanes(axis, b->up);
    view->c[i][2] = dot_lanes(axis, b->back);
    view->m[i][0] = simd_abs(view->c[i][0]);
    view->m[i][1] = simd_abs(view->c[i][1]);
    view->m[i][2] = simd_abs(view->c[i][2]);
}

#define FACE_A(i)                                                                                  \
    try_face(&separation, view.d[i], ha[i] + dot_lanes(view.m[i], hb),                             \
             ma + mb * (view.m[i][0] + view.m[i][1] + view.m[i][2]), i)

#define FACE_B(j)                                                                                  \
    try_face(&separation,                                                                          \
             view.d[0] * view.c[0][j] + view.d[1] * view.c[1][j] + view.d[2] * view.c[2][j],       \
             hb[j] + (view.m[0][j] * ha[0] + view.m[1][j] * ha[1] + view.m[2][j] * ha[2]),         \
             mb + ma * (view.m[0][j] + view.m[1][j] + view.m[2][j]), 3 + (j))

/* Tests the cross product of edge i of box a and edge j of box b as a separating axis. p and q are
 * the two axes that follow axis i in the cyclic order 0, 1, 2, 0, and r and s are the two axes that
 * follow axis j. */
#define EDGES(i, p, q, j, r, s)                                                                    \
    try_edges(&separation, view.d[q] * view.c[p][j] - view.d[p] * view.c[q][j],                    \
              ha[p] * view.m[q][j] + ha[q] * view.m[p][j] + hb[r] * view.m[i][s] +                 \
                  hb[s] * view.m[i][r],                                                            \
              ma * (view.m[q][j] + view.m[p][j]) + mb * (view.m[i][s] + view.m[i][r]),             \
              view.c[p][j] * view.c[p][j] + view.c[q][j] * view.c[q][j], 6 + 3 * (i) + (j))

/* Tests all fifteen axes of the separating-axis test, in the order of the indices of box_axis().
 * The function is always inlined, because a call would pass a kilobyte through memory. */
__attribute__((always_inline)) static inline struct separation
find_separating_axis(const struct body_simd *a, const struct body_simd *b)
{
    struct separation separation = { simd_splat(-APART_M * APART_M), simd_splat(-APART_M) };
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
    return separation;
}

static inline flanes gap_of(const struct separation *separation)
{
    const flanes root = simd_sqrt(simd_abs(separation->square));
    return simd_select(separation->square < 0.0f, -root, root);
}

NARROW_PHASE_GAPS(SIMD_NAME(narrow_phase_gaps))
{
    for (uint32_t n = 0; n < count; n += SIMD_LANES) {
        uint32_t first[SIMD_LANES], second[SIMD_LANES];
        for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
            first[lane] = a[n + lane];
            second[lane] = b[n + lane];
        }
        struct body_simd all_a, all_b;
        body_simd_load(&all_a, body, first);
        body_simd_load(&all_b, body, second);
        const struct separation separation = find_separating_axis(&all_a, &all_b);
        simd_store(&gap_m[n], gap_of(&separation));
    }
}

NARROW_PHASE_BOXES(SIMD_NAME(narrow_phase_boxes))
{
    CORE_ASSERT(narrow_phase->near_count <= NARROW_PHASE_BATCH);
    const fish_index *item = narrow_phase->grid.item;
    uint32_t kept = 0;
    for (uint32_t n = 0; n < narrow_phase->near_count; n += SIMD_LANES) {
        const uint32_t then = n + NARROW_PHASE_PREFETCH;
        for (uint32_t lane = 0; lane < SIMD_LANES && then + lane < narrow_phase->near_count;
             lane++) {
            __builtin_prefetch(&of->body[item[narrow_phase->near_b[then + lane]]]);
        }
        uint32_t first[SIMD_LANES], second[SIMD_LANES];
        for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
            first[lane] = item[narrow_phase->near_a[n + lane]];
            second[lane] = item[narrow_phase->near_b[n + lane]];
        }
        struct body_simd a, b;
        body_simd_load(&a, of->body, first);
        body_simd_load(&b, of->body, second);
        const struct separation separation = find_separating_axis(&a, &b);
        const uint32_t meets = simd_bits(separation.space <= 0.0f);
        float gap_m[SIMD_LANES];
        int32_t axis[SIMD_LANES];
        simd_store(gap_m, gap_of(&separation));
        MEM_COPY(axis, &separation.square, sizeof axis);
        for (uint32_t lane = 0; lane < SIMD_LANES && n + lane < narrow_phase->near_count; lane++) {
            const uint32_t i = first[lane], j = second[lane], meet = meets >> lane & 1u;
            found[kept] = (struct narrow_phase_pair){ i, j, gap_m[lane], (uint8_t)(axis[lane] & 15),
                                                      (uint8_t)meet };
            kept += meet | (gap_m[lane] < of->reach_m[i] + of->reach_m[j]);
        }
    }
    return kept;
}
