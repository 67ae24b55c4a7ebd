/* box.c -- computes the gap of two boxes by the separating-axis test. The test needs the cosines
 * between the axes of the boxes, and computes these cosines only once. */
#include "core/tank/collision/box.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

/* Squared length of a cross product of unit vectors below which two edges count as parallel. */
#define PARALLEL 1e-6f

/* Intermediate result of the separating-axis test, which tests one axis after the other. `gap_m` is
 * the largest gap between the projections of the two boxes on any axis so far. `space_m` is the
 * largest such gap between the boxes enlarged by their margins. */
struct separation {
    float gap_m, space_m;
    int axis; /* Index of the axis on which `gap_m` was found, as in box_axis(). */
};

static inline void try_axis(struct separation *separation, float gap_m, float margins_m, int axis)
{
    separation->space_m = f_max(separation->space_m, gap_m - margins_m);
    if (gap_m > separation->gap_m) {
        separation->gap_m = gap_m;
        separation->axis = axis;
    }
}

/* Box b in the coordinates of box a. The test of axis i of box a fills row i of `cosine` and of
 * `size`. */
struct view_of_b {
    const struct box *a, *b;
    vec3 way; /* Vector from the centre of box a to the centre of box b. */
    float margin_a_m, margin_b_m;
    float half_a[3], half_b[3];
    float cosine[3][3], size[3][3]; /* Cosines between the axes of box a and the axes of box b
                                       (`cosine`), and their magnitudes (`size`). */
    float d[3];                     /* Coordinates of the vector `way` along the axes of box a. */
};

static inline vec3 axis_of(const struct basis *axes, int index)
{
    return index == 0 ? axes->right : index == 1 ? axes->up : axes->back;
}

static inline bool try_face_of_a(struct separation *separation, struct view_of_b *view, int i)
{
    const vec3 axis = axis_of(&view->a->axes, i);
    float *c = view->cosine[i], *m = view->size[i];
    const float *hb = view->half_b;
    view->d[i] = v3_dot(view->way, axis);
    c[0] = v3_dot(axis, view->b->axes.right);
    c[1] = v3_dot(axis, view->b->axes.up);
    c[2] = v3_dot(axis, view->b->axes.back);
    m[0] = f_abs(c[0]);
    m[1] = f_abs(c[1]);
    m[2] = f_abs(c[2]);
    const float halves_m = view->half_a[i] + (m[0] * hb[0] + m[1] * hb[1] + m[2] * hb[2]);
    try_axis(separation, f_abs(view->d[i]) - halves_m,
             view->margin_a_m + view->margin_b_m * (m[0] + m[1] + m[2]), i);
    return separation->space_m > 0.0f;
}

static inline bool try_face_of_b(struct separation *separation, const struct view_of_b *view, int j)
{
    const float m[3] = { view->size[0][j], view->size[1][j], view->size[2][j] };
    const float *ha = view->half_a, *d = view->d;
    const float offset_m =
        d[0] * view->cosine[0][j] + d[1] * view->cosine[1][j] + d[2] * view->cosine[2][j];
    const float halves_m = view->half_b[j] + (m[0] * ha[0] + m[1] * ha[1] + m[2] * ha[2]);
    try_axis(separation, f_abs(offset_m) - halves_m,
             view->margin_b_m + view->margin_a_m * (m[0] + m[1] + m[2]), 3 + j);
    return separation->space_m > 0.0f;
}

/* Tests the cross product of edge i of box a and edge j of box b as a separating axis. Dividing by
 * the length of the cross product gives true distances. Nearly parallel edges are skipped, because
 * their cross product is too short, and the face normals already cover parallel edges. */
static inline bool try_edges(struct separation *separation, const struct view_of_b *view, int i,
                             int j)
{
    static const int after[3] = { 1, 2, 0 }, before[3] = { 2, 0, 1 };
    const int p = after[i], q = before[i], r = after[j], s = before[j];
    const float(*c)[3] = view->cosine, (*m)[3] = view->size;
    const float *ha = view->half_a, *hb = view->half_b;
    const float square = c[p][j] * c[p][j] + c[q][j] * c[q][j];
    if (square <= PARALLEL) {
        return false;
    }
    const float offset_m = f_abs(view->d[q] * c[p][j] - view->d[p] * c[q][j]);
    const float halves_m = ha[p] * m[q][j] + ha[q] * m[p][j] + hb[r] * m[i][s] + hb[s] * m[i][r];
    const float margins_m =
        view->margin_a_m * (m[q][j] + m[p][j]) + view->margin_b_m * (m[i][s] + m[i][r]);
    const float length = f_sqrt(square);
    try_axis(separation, (offset_m - halves_m) / length, margins_m / length, 6 + 3 * i + j);
    return separation->space_m > 0.0f;
}

vec3 box_axis(const struct basis *a, const struct basis *b, vec3 way, uint8_t which)
{
    CORE_ASSERT(which < 15u);
    const int axis = which;
    vec3 along = axis < 3 ? axis_of(a, axis) : axis_of(b, axis - 3);
    if (axis >= 6) {
        const vec3 cross = v3_cross(axis_of(a, (axis - 6) / 3), axis_of(b, axis % 3));
        along = v3_normalize_or(cross, a->up);
    }
    return v3_dot(along, way) < 0.0f ? v3_scale(along, -1.0f) : along;
}

struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b, float margin_b_m)
{
    struct view_of_b view;
    struct separation separation = { -1e9f, -1e9f, 0 };
    view.a = a;
    view.b = b;
    view.way = v3_sub(b->centre_m, a->centre_m);
    view.margin_a_m = margin_a_m;
    view.margin_b_m = margin_b_m;
    MEM_COPY(view.half_a, &a->half_m, sizeof view.half_a);
    MEM_COPY(view.half_b, &b->half_m, sizeof view.half_b);
    /* Tests the face axes in the order right, back, up, which finds a separating axis soonest for
     * most pairs of nearby fish. */
    static const int order[3] = { 0, 2, 1 };
    bool apart = false;
    for (int k = 0; k < 3 && !apart; k++) {
        apart = try_face_of_a(&separation, &view, order[k]);
    }
    for (int k = 0; k < 3 && !apart; k++) {
        apart = try_face_of_b(&separation, &view, order[k]);
    }
    for (int k = 0; k < 9 && !apart; k++) {
        apart = try_edges(&separation, &view, k / 3, k % 3);
    }
    const uint8_t which = (uint8_t)separation.axis;
    const vec3 none = { 0.0f, 0.0f, 0.0f };
    return (struct box_gap){
        separation.gap_m,
        separation.space_m,
        apart ? none : box_axis(&a->axes, &b->axes, view.way, which),
        which,
    };
}

float box_depth_m(const struct box *a, const struct box *b)
{
    return f_max(0.0f, -box_gap(a, 0.0f, b, 0.0f).body_m);
}

vec3 box_extent_m(const struct box *box)
{
    return box_upright_m(box->axes.right, box->axes.up, box->axes.back, box->half_m);
}

/* Tests the directions, perpendicular to the rod, in which the box can leave the rod. Seen along
 * the rod, the box is a hexagon and the rod is a disc. The normals of the hexagon's sides are the
 * cross products of the box axes and the rod. */
vec3 box_clear_rod(const struct box *box, vec3 point_m, vec3 along, float radius_m)
{
    CORE_ASSERT(radius_m > 0.0f);
    const vec3 axis[3] = { box->axes.right, box->axes.up, box->axes.back };
    const float half[3] = { box->half_m.x, box->half_m.y, box->half_m.z };
    const vec3 none = { 0.0f, 0.0f, 0.0f };
    const vec3 d = v3_sub(box->centre_m, point_m);
    float least_m = 1e9f;
    vec3 move = none;
    for (int i = 0; i < 3; i++) {
        const vec3 side = v3_cross(axis[i], along);
        const float length = v3_length(side);
        if (length < 1e-3f) { /* Axis i is parallel to the rod, so that no direction follows from
                                 this axis. The other two axes give the directions to test. */
            continue;
        }
        const vec3 normal = v3_scale(side, 1.0f / length);
        const float offset = v3_dot(d, normal);
        const float depth_m =
            (f_abs(v3_dot(axis[0], normal)) * half[0] + f_abs(v3_dot(axis[1], normal)) * half[1] +
             f_abs(v3_dot(axis[2], normal)) * half[2]) +
            radius_m - f_abs(offset);
        if (depth_m <= 0.0f) {
            return none;
        }
        if (depth_m < least_m) {
            least_m = depth_m;
            move = v3_scale(normal, offset < 0.0f ? -depth_m : depth_m);
        }
    }
    return move;
}
