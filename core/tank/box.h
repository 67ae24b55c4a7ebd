/* box.h -- oriented boxes: how far apart two of them are, or how deep they overlap.
 *
 * The separating-axis theorem: two boxes are apart exactly when some face normal of one of them, or
 * some cross product of an edge of each, shows a gap between their shadows. */
#ifndef KINGYO_CORE_TANK_BOX_H
#define KINGYO_CORE_TANK_BOX_H

#include "core/base/vec.h"

struct box {
    vec3 centre_m;
    struct basis axes;
    vec3 half_m; /* Along right, up, back. */
};

struct box_gap {
    float body_m; /* > 0: the boxes are at least so far apart; < 0: they overlap so deep. */
    float space_m; /* The same for the boxes grown by their margins. */
    vec3 axis;     /* Unit, from a toward b: the direction that parts them soonest. */
};

/* By all fifteen axes (Gottschalk 1996; Ericson 2005, section 4.4.1), those of edges across edges
 * normalised, so that every gap is a true distance. `space_m` > 0 ends the search at once: the
 * other members then mean nothing. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b,
                       float margin_b_m);

/* The length of the shortest translation that parts the boxes, 0 when apart. */
float box_depth_m(const struct box *a, const struct box *b);

/* Unit, from a toward b: axis 0 .. 2 of a, 3 .. 5 of b, or 6 + 3 i + j, edge i of a across edge j
 * of b. */
vec3 box_axis(const struct box *a, const struct box *b, int axis);

/* Half the size of the upright box that holds `box`. */
vec3 box_extent_m(const struct box *box);

/* The least move of the box that takes it off a rod of `radius_m` > 0 through `point_m` along
 * `along` (unit); zero when it is clear. */
vec3 box_clear_rod(const struct box *box, vec3 point_m, vec3 along, float radius_m);

#endif
