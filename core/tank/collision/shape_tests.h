/* shape_tests.h -- contact tests of a fish's box against a ring and against a hull.
 *
 * Each test returns the gap and the direction in which the box must move. */
#ifndef KINGYO_CORE_TANK_COLLISION_SHAPE_TESTS_H
#define KINGYO_CORE_TANK_COLLISION_SHAPE_TESTS_H

#include "core/tank/collision/box.h"

struct touch {
    float gap_m; /* A value > 0 is the gap, or a lower bound of the gap if the shape is not near. A
                    value < 0 is the penetration depth, negated. */
    vec3 out;    /* Unit vector along which the box leaves the shape soonest. The vector is
                    undefined if the shape is not near. */
};

#define SHAPE_TOUCH_FAR_M 1.0f /* Value of `gap_m` if the shape is not near. */

/* A torus: a tube of radius `tube_m` along the circle of radius `middle_m` around `centre_m`, in
 * the plane of the unit vector `normal`. shape_touch_ring() is exact to 0.05 mm for tubes and boxes
 * of the size of a poi and a fish. */
struct ring {
    vec3 centre_m, normal;
    float middle_m, tube_m;
};
struct touch shape_touch_ring(const struct ring *ring, const struct box *box);

/* The lower half of an ellipsoid that hangs from its mouth. shape_touch_hull() is exact at the skin
 * and has an error of a few percent farther outside or deeper inside. */
struct hull {
    vec3 mouth_m;
    float radius_m, depth_m;
};
struct touch shape_touch_hull(const struct hull *hull, const struct box *box);

/* Returns the signed distance of a point from a box; < 0 inside the box. `out` receives the unit
 * vector from the box's skin to the point. For a point inside the box, `out` receives the normal of
 * the nearest face. */
float shape_touch_point_m(const struct box *box, vec3 point_m, vec3 *out);

#endif
