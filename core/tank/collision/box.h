/* box.h -- oriented boxes: the gap or the penetration depth of two boxes.
 *
 * Uses the separating-axis theorem: two boxes are apart exactly if a face normal of one of them, or
 * the cross product of an edge of each, shows a gap between their projections. */
#ifndef KINGYO_CORE_TANK_COLLISION_BOX_H
#define KINGYO_CORE_TANK_COLLISION_BOX_H

#include <stdint.h>

#include "core/base/vec.h"

struct box {
    vec3 centre_m;
    struct basis axes;
    vec3 half_m; /* Half sizes along right, up and back. */
};

struct box_gap {
    float body_m;  /* > 0: least distance of the boxes; < 0: penetration depth. */
    float space_m; /* The same for the boxes enlarged by their margins. */
    vec3 axis;     /* Unit vector from a toward b: the direction of least penetration. */
    uint8_t which; /* Index of `axis` among the fifteen axes; see box_axis(). */
};

/* Returns the gap of two boxes by all fifteen axes (Gottschalk 1996; Ericson 2005, section 4.4.1).
 * The cross products of edges are normalised, so every gap is a true distance. The search stops as
 * soon as `space_m` > 0; the other members are undefined in that case. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b,
                       float margin_b_m);

/* Returns the length of the shortest translation that separates the boxes, 0 if they are apart. */
float box_depth_m(const struct box *a, const struct box *b);

/* Returns one of the fifteen axes of two boxes as a unit vector along `way` (from a to b). `which`
 * is 0 .. 2 for the axes of a, 3 .. 5 for those of b, and 6 + 3 i + j for edge i of a across edge j
 * of b. */
vec3 box_axis(const struct basis *a, const struct basis *b, vec3 way, uint8_t which);

/* Returns half the size of the axis-aligned box that holds an oriented box with the unit axes
 * `right`, `up` and `back` and the half sizes `half_m`. */
static inline vec3 box_upright_m(vec3 right, vec3 up, vec3 back, vec3 half_m)
{
    const float x = half_m.x, y = half_m.y, z = half_m.z;
    return v3(f_abs(right.x) * x + f_abs(up.x) * y + f_abs(back.x) * z,
              f_abs(right.y) * x + f_abs(up.y) * y + f_abs(back.y) * z,
              f_abs(right.z) * x + f_abs(up.z) * y + f_abs(back.z) * z);
}

/* Returns half the size of the axis-aligned box that holds `box`. */
vec3 box_extent_m(const struct box *box);

/* Returns the shortest move that takes the box off a rod, or zero if the box is clear. The rod has
 * `radius_m` > 0 and passes through `point_m` along the unit vector `along`. */
vec3 box_clear_rod(const struct box *box, vec3 point_m, vec3 along, float radius_m);

#endif
