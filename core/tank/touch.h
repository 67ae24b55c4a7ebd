/* touch.h -- a fish's box against what is no box: the poi's ring, its paper, a bowl's hull.
 *
 * Each says how far apart the two are and which way the fish would have to go. */
#ifndef KINGYO_CORE_TANK_TOUCH_H
#define KINGYO_CORE_TANK_TOUCH_H

#include "core/tank/box.h"

struct touch {
    float gap_m; /* > 0: so far apart, or farther when nothing is near; < 0: so deep. */
    vec3 out;    /* Unit: the way the box clears it soonest. Not meaningful when nothing is near. */
};

#define TOUCH_FAR_M 1.0f /* The gap to what is not near. */

/* A torus: a tube of `tube_m` along the circle of `middle_m` about a centre, in the plane of unit
 * `normal`. Exact to 0.05 mm for tubes and boxes of a poi's and a fish's size. */
struct ring {
    vec3 centre_m, normal;
    float middle_m, tube_m;
};
struct touch touch_ring(const struct ring *ring, const struct box *box);

/* The lower half of an ellipsoid that hangs from its mouth. Exact at its skin; farther off or
 * deeper in, right to a few parts in a hundred. */
struct hull {
    vec3 mouth_m;
    float radius_m, depth_m;
};
struct touch touch_hull(const struct hull *hull, const struct box *box);

/* Signed distance of a point from a box: negative inside. `out` becomes the unit direction from the
 * box's skin to the point (inside: to the nearest face). */
float touch_point_m(const struct box *box, vec3 point_m, vec3 *out);

#endif
