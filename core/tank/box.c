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

/* One box as another sees it along one of its own axes. */
struct shade {
    vec3 axis;
    float half_m, margin_m;
};

/* |cosines| of an axis against a box's three. */
static inline vec3 cosines(vec3 axis, const struct basis *axes)
{
    return v3(f_abs(v3_dot(axis, axes->right)), f_abs(v3_dot(axis, axes->up)),
              f_abs(v3_dot(axis, axes->back)));
}

/* Tries one face normal: its owner's half size and margin against the other's shadow along it. True
 * when even the grown boxes are apart. */
static inline int apart_along(struct box_gap *gap, vec3 d, struct shade owner, vec3 cosine,
                              vec3 other_half_m, float other_margin_m)
{
    const float offset = v3_dot(d, owner.axis);
    const float body_m = f_abs(offset) - owner.half_m - v3_dot(cosine, other_half_m);
    const float spread = cosine.x + cosine.y + cosine.z;
    gap->space_m = f_max(gap->space_m, body_m - owner.margin_m - other_margin_m * spread);
    if (body_m > gap->body_m) {
        gap->body_m = body_m;
        gap->axis = offset < 0.0f ? v3_scale(owner.axis, -1.0f) : owner.axis;
    }
    return gap->space_m > 0.0f;
}

/* Sides first, then nose and tail: so are most fish apart that are near. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b, float margin_b_m)
{
    const vec3 d = v3_sub(b->centre_m, a->centre_m), ha = a->half_m, hb = b->half_m;
    const float ma = margin_a_m, mb = margin_b_m;
    struct box_gap gap = { .body_m = -1e9f, .space_m = -1e9f, .axis = { 0.0f, 1.0f, 0.0f } };
    const vec3 right = cosines(a->axes.right, &b->axes);
    if (apart_along(&gap, d, (struct shade){ a->axes.right, ha.x, ma }, right, hb, mb)) {
        return gap;
    }
    const vec3 back = cosines(a->axes.back, &b->axes);
    if (apart_along(&gap, d, (struct shade){ a->axes.back, ha.z, ma }, back, hb, mb)) {
        return gap;
    }
    const vec3 up = cosines(a->axes.up, &b->axes);
    /* Stops at the first that shows them apart. */
    (void)(apart_along(&gap, d, (struct shade){ b->axes.right, hb.x, mb },
                       v3(right.x, up.x, back.x), ha, ma) ||
           apart_along(&gap, d, (struct shade){ b->axes.back, hb.z, mb }, v3(right.z, up.z, back.z),
                       ha, ma) ||
           apart_along(&gap, d, (struct shade){ a->axes.up, ha.y, ma }, up, hb, mb) ||
           apart_along(&gap, d, (struct shade){ b->axes.up, hb.y, mb }, v3(right.y, up.y, back.y),
                       ha, ma));
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
            gap_m =
                f_max(gap_m, f_abs(v3_dot(d, axis)) - shadow_m(&fa, axis) - shadow_m(&fb, axis));
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
