/* box.h -- oriented boxes: the gap between two boxes, contact tests with a ring and with a hull,
 * and the body of a fish.
 *
 * The gap between two boxes follows from the separating-axis theorem. Two boxes are apart exactly
 * if their projections on one of fifteen axes have a gap. Six of the axes are the face normals of
 * the boxes. The other nine axes are the cross products of an edge of one box and an edge of the
 * other box.
 *
 * The contact tests (shape_tests.c) return the gap and the direction in which the box must move. A
 * body (struct body) is the box of a fish in one cache line, for the broad phase and the contact
 * solver. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"

struct box {
    vec3 centre_m;
    struct basis axes;
    vec3 half_m; /* Half of the size of the box along its axes right, up and back. */
};

struct box_gap {
    /* Gap between the boxes if the value is > 0. A value < 0 is the negated penetration depth. */
    float body_m;
    /* Gap or negated penetration depth of the two boxes after each box is enlarged by its margin (a
     * parameter of box_gap()). */
    float space_m;
    vec3 axis; /* Unit vector from box a toward box b in the direction of least penetration. */
    /* Index of `axis` among the fifteen axes of the separating-axis test, as in box_axis(). */
    uint8_t which;
};

/* Returns the gap between two boxes by the separating-axis test with all fifteen axes (Gottschalk
 * 1996; Ericson 2005, section 4.4.1). The cross products of edges are normalised, so every gap is a
 * true distance. The test stops at the first axis with `space_m` > 0; the other members of the
 * result are then undefined. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b,
                       float margin_b_m);

/* Returns the length of the shortest translation that separates the boxes, or 0 if the boxes do not
 * overlap. */
float box_depth_m(const struct box *a, const struct box *b);

/* Returns one of the fifteen axes of the separating-axis test of boxes a and b as a unit vector.
 * The sign is chosen so that the vector points along `way`, from a to b. A `which` of 0 to 2
 * selects an axis of a, 3 to 5 an axis of b. 6 + 3 i + j selects the cross product of edge i of a
 * and edge j of b. Asserts that `which` is below 15. */
vec3 box_axis(const struct basis *a, const struct basis *b, vec3 way, uint8_t which);

/* Returns half the size of the smallest axis-aligned box that contains an oriented box. The
 * oriented box has the unit axes `right`, `up` and `back` and the half sizes `half_m`. */
static inline vec3 box_upright_m(vec3 right, vec3 up, vec3 back, vec3 half_m)
{
    const float x = half_m.x, y = half_m.y, z = half_m.z;
    return v3(f_abs(right.x) * x + f_abs(up.x) * y + f_abs(back.x) * z,
              f_abs(right.y) * x + f_abs(up.y) * y + f_abs(back.y) * z,
              f_abs(right.z) * x + f_abs(up.z) * y + f_abs(back.z) * z);
}

/* Returns half the size of the smallest axis-aligned box that contains `box`. */
vec3 box_extent_m(const struct box *box);

/* Returns the shortest translation that moves the box off a rod, or zero if the box does not touch
 * the rod. The rod has the radius `radius_m` > 0 and passes through `point_m` along the unit vector
 * `along`. */
vec3 box_clear_rod(const struct box *box, vec3 point_m, vec3 along, float radius_m);

struct touch {
    /* A value > 0 is the gap between the box and the shape, which is a ring or a hull. If the shape
     * is far away, the value is a lower bound of the gap. A value < 0 is the negated penetration
     * depth. */
    float gap_m;
    /* Unit vector along which the box leaves the shape soonest. The vector is undefined if the
     * shape is far away. */
    vec3 out;
};

/* Value of `gap_m` in struct touch if the ring or hull is far away from the box. */
#define SHAPE_TOUCH_FAR_M 1.0f

/* The ring of a poi (paper scoop) as a torus: a tube of radius `tube_m` along the circle of radius
 * `middle_m` around `centre_m`, in the plane of the unit vector `normal`. shape_touch_ring() is
 * exact to 0.05 mm for tubes and boxes of the size of a poi and a fish. */
struct ring {
    vec3 centre_m, normal;
    float middle_m, tube_m;
};
struct touch shape_touch_ring(const struct ring *ring, const struct box *box);

/* Hull of a floating bowl: the lower half of an ellipsoid, with a round mouth at the top.
 * shape_touch_hull() is exact at the skin and has an error of a few percent farther outside or
 * deeper inside. */
struct hull {
    vec3 mouth_m;
    float radius_m, depth_m;
};
struct touch shape_touch_hull(const struct hull *hull, const struct box *box);

/* Returns the signed distance of a point from a box; < 0 inside the box. `out` receives the unit
 * vector from the box's skin to the point. For a point inside the box, `out` receives the normal of
 * the nearest face. */
float shape_touch_point_m(const struct box *box, vec3 point_m, vec3 *out);

struct body {
    vec3 centre_m;
    float half_x_m; /* Half of the width, along `right`. */
    vec3 right;     /* Unit axes of the body in world coordinates, as in struct basis. */
    float half_y_m; /* Half of the height, along `up`. */
    vec3 up;
    float half_z_m; /* Half of the length, along `back`. */
    vec3 back;
    float margin_m; /* Width of the personal space around the body, on every side. */
};
_Static_assert(sizeof(struct body) == 64u, "a body is a cache line, four quads of floats");

static inline struct body body_of(const struct box *box, float margin_m)
{
    return (struct body){ box->centre_m, box->half_m.x, box->axes.right, box->half_m.y,
                          box->axes.up,  box->half_m.z, box->axes.back,  margin_m };
}

static inline struct box body_box(const struct body *body)
{
    return (struct box){
        .centre_m = body->centre_m,
        .axes = { body->right, body->up, body->back },
        .half_m = { body->half_x_m, body->half_y_m, body->half_z_m },
    };
}

/* Returns the gap between the boxes of two bodies, as box_gap() does. The margins are the
 * parameters, not the members `margin_m` of the bodies. */
static inline struct box_gap body_gap(const struct body *a, float margin_a_m, const struct body *b,
                                      float margin_b_m)
{
    const struct box box_a = body_box(a), box_b = body_box(b);
    return box_gap(&box_a, margin_a_m, &box_b, margin_b_m);
}

/* Returns half the size of the smallest axis-aligned box that contains the body. */
static inline vec3 body_extent_m(const struct body *body)
{
    return box_upright_m(body->right, body->up, body->back,
                         v3(body->half_x_m, body->half_y_m, body->half_z_m));
}
