/* shape_tests.h -- shape tests of a fish's box against a ring and against a hull.
 *
 * Each test returns the gap and the direction in which the box must move. */
#ifndef KINGYO_CORE_TANK_COLLISION_SHAPE_TESTS_H
#define KINGYO_CORE_TANK_COLLISION_SHAPE_TESTS_H

#include "core/tank/collision/box.h"

struct touch {
    float gap_m; /* > 0: the gap, or a lower bound of it if nothing is near; < 0: penetration
                    depth. */
    vec3 out;    /* Unit vector along which the box clears the shape soonest; undefined if nothing
                    is near. */
};

#define SHAPE_TOUCH_FAR_M 1.0f /* Gap if the shape is not near. */

/* A torus: a tube of `tube_m` along the circle of radius `middle_m` around a centre, in the plane
 * of the unit `normal`. Exact to 0.05 mm for tubes and boxes of the size of a poi and a fish. */
struct ring {
    vec3 centre_m, normal;
    float middle_m, tube_m;
};
struct touch shape_touch_ring(const struct ring *ring, const struct box *box);

/* The lower half of an ellipsoid that hangs from its mouth. Exact at its skin; a few percent error
 * farther out or deeper inside. */
struct hull {
    vec3 mouth_m;
    float radius_m, depth_m;
};
struct touch shape_touch_hull(const struct hull *hull, const struct box *box);

/* Returns the signed distance of a point from a box, negative inside. `out` becomes the unit vector
 * from the box's skin to the point (inside: to the nearest face). */
float shape_touch_point_m(const struct box *box, vec3 point_m, vec3 *out);

#endif
