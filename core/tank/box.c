/* box.c -- separating axes, with the frames' cosines computed once for all of them. */
#include "core/tank/box.h"

#define PARALLEL 1e-6f /* Square of a cross product's length: edges within a thousandth. */

struct frame {
    vec3 axis[3];
    float half[3];
};

static struct frame frame_of(const struct box *box)
{
    return (struct frame){
        .axis = { box->axes.right, box->axes.up, box->axes.back },
        .half = { box->half_m.x, box->half_m.y, box->half_m.z },
    };
}

/* What the axes tried so far say of two boxes. */
struct verdict {
    float gap_m, space_m;
    int axis; /* 0 .. 2 of a, 3 .. 5 of b, 6 + 3 i + j: edge i of a across edge j of b. */
};

static inline void try_axis(struct verdict *verdict, float gap_m, float margins_m, int axis)
{
    verdict->space_m = f_max(verdict->space_m, gap_m - margins_m);
    if (gap_m > verdict->gap_m) {
        verdict->gap_m = gap_m;
        verdict->axis = axis;
    }
}

/* Two boxes, one as the other sees it. */
struct view_of_b {
    struct frame a, b;
    float margin_a_m, margin_b_m;
    float cosine[3][3], size[3][3]; /* Of a's axes against b's; and their magnitudes. */
    float d[3];                     /* The way from a to b, in a's frame. */
};

static struct view_of_b view_of(const struct box *a, float margin_a_m, const struct box *b,
                                float margin_b_m)
{
    struct view_of_b view = { .a = frame_of(a),
                              .b = frame_of(b),
                              .margin_a_m = margin_a_m,
                              .margin_b_m = margin_b_m };
    const vec3 way = v3_sub(b->centre_m, a->centre_m);
    for (int i = 0; i < 3; i++) {
        view.d[i] = v3_dot(way, view.a.axis[i]);
        for (int j = 0; j < 3; j++) {
            view.cosine[i][j] = v3_dot(view.a.axis[i], view.b.axis[j]);
            view.size[i][j] = f_abs(view.cosine[i][j]);
        }
    }
    return view;
}

static void try_faces_of_a(struct verdict *verdict, const struct view_of_b *view)
{
    for (int i = 0; i < 3; i++) {
        const float *m = view->size[i], *hb = view->b.half;
        const float halves_m = view->a.half[i] + (m[0] * hb[0] + m[1] * hb[1] + m[2] * hb[2]);
        try_axis(verdict, f_abs(view->d[i]) - halves_m,
                 view->margin_a_m + view->margin_b_m * (m[0] + m[1] + m[2]), i);
    }
}

static void try_faces_of_b(struct verdict *verdict, const struct view_of_b *view)
{
    for (int j = 0; j < 3; j++) {
        const float m[3] = { view->size[0][j], view->size[1][j], view->size[2][j] };
        const float *ha = view->a.half, *d = view->d;
        const float offset_m = d[0] * view->cosine[0][j] + d[1] * view->cosine[1][j] +
                               d[2] * view->cosine[2][j];
        const float halves_m = view->b.half[j] + (m[0] * ha[0] + m[1] * ha[1] + m[2] * ha[2]);
        try_axis(verdict, f_abs(offset_m) - halves_m,
                 view->margin_b_m + view->margin_a_m * (m[0] + m[1] + m[2]), 3 + j);
    }
}

/* The cross product's length makes true distances of what it shows. Edges that are parallel to a
 * thousandth have none worth the name; face normals have said it all. */
static void try_edges(struct verdict *verdict, const struct view_of_b *view, int i, int j)
{
    const int p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
    const float(*c)[3] = view->cosine, (*m)[3] = view->size;
    const float *ha = view->a.half, *hb = view->b.half;
    const float square = c[p][j] * c[p][j] + c[q][j] * c[q][j];
    if (square <= PARALLEL) {
        return;
    }
    const float offset_m = f_abs(view->d[q] * c[p][j] - view->d[p] * c[q][j]);
    const float halves_m =
        ha[p] * m[q][j] + ha[q] * m[p][j] + hb[r] * m[i][s] + hb[s] * m[i][r];
    const float margins_m =
        view->margin_a_m * (m[q][j] + m[p][j]) + view->margin_b_m * (m[i][s] + m[i][r]);
    const float length = f_sqrt(square);
    try_axis(verdict, (offset_m - halves_m) / length, margins_m / length, 6 + 3 * i + j);
}

vec3 box_axis(const struct box *a, const struct box *b, int axis)
{
    const struct frame fa = frame_of(a), fb = frame_of(b);
    vec3 along = fa.axis[axis % 3];
    if (axis >= 6) {
        along = v3_cross(fa.axis[(axis - 6) / 3], fb.axis[axis % 3]);
        along = v3_normalize_or(along, fa.axis[1]);
    } else if (axis >= 3) {
        along = fb.axis[axis - 3];
    }
    return v3_dot(along, v3_sub(b->centre_m, a->centre_m)) < 0.0f ? v3_scale(along, -1.0f) : along;
}

struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b, float margin_b_m)
{
    const struct view_of_b view = view_of(a, margin_a_m, b, margin_b_m);
    struct verdict verdict = { -1e9f, -1e9f, 0 };
    try_faces_of_a(&verdict, &view);
    if (verdict.space_m <= 0.0f) {
        try_faces_of_b(&verdict, &view);
    }
    for (int edges = 0; edges < 9 && verdict.space_m <= 0.0f; edges++) {
        try_edges(&verdict, &view, edges / 3, edges % 3);
    }
    return (struct box_gap){ verdict.gap_m, verdict.space_m, box_axis(a, b, verdict.axis) };
}

float box_depth_m(const struct box *a, const struct box *b)
{
    return f_max(0.0f, -box_gap(a, 0.0f, b, 0.0f).body_m);
}

static float shadow_m(const struct frame *frame, vec3 axis)
{
    return f_abs(v3_dot(frame->axis[0], axis)) * frame->half[0] +
           f_abs(v3_dot(frame->axis[1], axis)) * frame->half[1] +
           f_abs(v3_dot(frame->axis[2], axis)) * frame->half[2];
}

vec3 box_extent_m(const struct box *box)
{
    const struct frame frame = frame_of(box);
    return v3(shadow_m(&frame, v3(1.0f, 0.0f, 0.0f)), shadow_m(&frame, v3(0.0f, 1.0f, 0.0f)),
              shadow_m(&frame, v3(0.0f, 0.0f, 1.0f)));
}

/* Seen along the rod the box is a hexagon and the rod a disc: the sides' normals are the box's axes
 * crossed with the rod. */
vec3 box_clear_rod(const struct box *box, vec3 point_m, vec3 along, float radius_m)
{
    const struct frame frame = frame_of(box);
    const vec3 none = { 0.0f, 0.0f, 0.0f };
    const vec3 d = v3_sub(box->centre_m, point_m);
    float least_m = 1e9f;
    vec3 move = none;
    for (int i = 0; i < 3; i++) {
        const vec3 side = v3_cross(frame.axis[i], along);
        const float length = v3_length(side);
        if (length < 1e-3f) { /* The rod runs along this axis: the other two say all. */
            continue;
        }
        const vec3 normal = v3_scale(side, 1.0f / length);
        const float offset = v3_dot(d, normal);
        const float depth_m = shadow_m(&frame, normal) + radius_m - f_abs(offset);
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
