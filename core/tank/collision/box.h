/* box.h -- oriented boxes: the gap or the penetration depth of two boxes.
 *
 * The functions use the separating-axis theorem. Two boxes are apart exactly if an axis shows a
 * gap between their projections. Fifteen axes are tested. Six of them are the face normals of
 * the boxes. The other nine are the cross products of an edge of one box and an edge of the
 * other box. */
#ifndef KINGYO_CORE_TANK_COLLISION_BOX_H
#define KINGYO_CORE_TANK_COLLISION_BOX_H

#include <stdint.h>

#include "core/base/vec.h"

struct box {
    vec3 centre_m;
    struct basis axes;
    vec3 half_m; /* Half of the size along right, up and back. */
};

struct box_gap {
    float body_m;  /* A value > 0 is the gap between the boxes. A value < 0 is the penetration
                      depth, negated. */
    float space_m; /* Gap or negated penetration depth of the boxes after each is enlarged by its
                      margin. */
    vec3 axis;     /* Unit vector from box a toward box b in the direction of least penetration. */
    uint8_t which; /* Index of `axis` among the fifteen axes; see box_axis(). */
};

/* Returns the gap of two boxes by all fifteen axes (Gottschalk 1996; Ericson 2005, section 4.4.1).
 * The cross products of edges are normalised, so every gap is a true distance. The search stops as
 * soon as `space_m` is > 0; the other members of the result are undefined in that case. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b,
                       float margin_b_m);

/* Returns the length of the shortest translation that separates the boxes, or 0 if the boxes do not
 * overlap. */
float box_depth_m(const struct box *a, const struct box *b);

/* Returns one of the fifteen axes of boxes a and b as a unit vector. The sign is chosen so that the
 * vector points along `way`, from a to b. A `which` of 0 to 2 selects an axis of a, 3 to 5 an axis
 * of b. 6 + 3 i + j selects the cross product of edge i of a and edge j of b. Asserts that `which`
 * is below 15. */
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

#endif
