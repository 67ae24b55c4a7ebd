/* box.c -- separating axes, with the frames' cosines computed once for all of them. */
#include "core/tank/box.h"

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

/* Tries one face normal: its owner's half size and margin against the other's shadow along it. */
static int try_axis(struct box_gap *gap, vec3 d, vec3 axis, float half_m, float margin_m,
                    const float other_half[3], float other_margin_m, float c0, float c1, float c2)
{
    const float offset = v3_dot(d, axis);
    const float shadow = c0 * other_half[0] + c1 * other_half[1] + c2 * other_half[2];
    const float body_m = f_abs(offset) - half_m - shadow;
    gap->space_m = f_max(gap->space_m, body_m - margin_m - other_margin_m * (c0 + c1 + c2));
    if (body_m > gap->body_m) {
        gap->body_m = body_m;
        gap->axis = offset < 0.0f ? v3_scale(axis, -1.0f) : axis;
    }
    return gap->space_m > 0.0f;
}

/* Sides first, then nose and tail: that is how fish that are near but apart are mostly parted. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b, float margin_b_m)
{
    static const int order[3] = { 0, 2, 1 };
    const struct frame fa = frame_of(a), fb = frame_of(b);
    const vec3 d = v3_sub(b->centre_m, a->centre_m);
    struct box_gap gap = { .body_m = -1e9f, .space_m = -1e9f, .axis = { 0.0f, 1.0f, 0.0f } };
    float c[3][3];
    for (int n = 0; n < 3; n++) {
        const int i = order[n];
        for (int j = 0; j < 3; j++) {
            c[i][j] = f_abs(v3_dot(fa.axis[i], fb.axis[j]));
        }
        if (try_axis(&gap, d, fa.axis[i], fa.half[i], margin_a_m, fb.half, margin_b_m, c[i][0], c[i][1], c[i][2])) {
            return gap;
        }
    }
    for (int n = 0; n < 3; n++) {
        const int j = order[n];
        if (try_axis(&gap, d, fb.axis[j], fb.half[j], margin_b_m, fa.half, margin_a_m, c[0][j], c[1][j], c[2][j])) {
            return gap;
        }
    }
    return gap;
}

static float shadow_m(const struct frame *frame, vec3 axis)
{
    return f_abs(v3_dot(frame->axis[0], axis)) * frame->half[0] +
           f_abs(v3_dot(frame->axis[1], axis)) * frame->half[1] +
           f_abs(v3_dot(frame->axis[2], axis)) * frame->half[2];
}

float box_depth_m(const struct box *a, const struct box *b)
{
    const struct box_gap faces = box_gap(a, 0.0f, b, 0.0f);
    const struct frame fa = frame_of(a), fb = frame_of(b);
    const vec3 d = v3_sub(b->centre_m, a->centre_m);
    float gap_m = faces.body_m;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const vec3 edge = v3_cross(fa.axis[i], fb.axis[j]);
            const float length = v3_length(edge);
            if (length < 1e-3f) { /* Parallel edges: a face normal has said it already. */
                continue;
            }
            const vec3 axis = v3_scale(edge, 1.0f / length);
            gap_m = f_max(gap_m, f_abs(v3_dot(d, axis)) - shadow_m(&fa, axis) - shadow_m(&fb, axis));
        }
    }
    return f_max(0.0f, -gap_m);
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
