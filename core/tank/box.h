/* box.h -- oriented boxes: how far apart two of them are, or how deep they overlap.
 *
 * The separating-axis theorem: two boxes are apart exactly when some face normal of one of them, or
 * some cross product of an edge of each, shows a gap between their shadows. */
#ifndef KINGYO_CORE_TANK_BOX_H
#define KINGYO_CORE_TANK_BOX_H

#include <stdint.h>

#include "core/base/vec.h"

struct box {
    vec3 centre_m;
    struct basis axes;
    vec3 half_m; /* Along right, up, back. */
};

struct box_gap {
    float body_m; /* > 0: the boxes are at least so far apart; < 0: they overlap so deep. */
    float space_m; /* The same for the boxes grown by their margins. */
    vec3 axis;     /* Unit, from a toward b: the direction that parts them soonest, ... */
    uint8_t which; /* ... and which it is of the fifteen; see box_axis(). */
};

/* By all fifteen axes (Gottschalk 1996; Ericson 2005, section 4.4.1), those of edges across edges
 * normalised, so that every gap is a true distance. `space_m` > 0 ends the search at once: the
 * other members then mean nothing. */
struct box_gap box_gap(const struct box *a, float margin_a_m, const struct box *b,
                       float margin_b_m);

/* The length of the shortest translation that parts the boxes, 0 when apart. */
float box_depth_m(const struct box *a, const struct box *b);

/* One of the fifteen axes of two boxes that lie so, a unit vector along `way` (from a to b): 0 .. 2
 * of a, 3 .. 5 of b, or 6 + 3 i + j, edge i of a across edge j of b. */
vec3 box_axis(const struct basis *a, const struct basis *b, vec3 way, uint8_t which);

/* Half the size of the upright box that holds one with such half sizes along such unit axes. */
static inline vec3 box_upright_m(vec3 right, vec3 up, vec3 back, vec3 half_m)
{
    const float x = half_m.x, y = half_m.y, z = half_m.z;
    return v3(f_abs(right.x) * x + f_abs(up.x) * y + f_abs(back.x) * z,
              f_abs(right.y) * x + f_abs(up.y) * y + f_abs(back.y) * z,
              f_abs(right.z) * x + f_abs(up.z) * y + f_abs(back.z) * z);
}

/* The same of `box`. */
vec3 box_extent_m(const struct box *box);

/* The least move of the box that takes it off a rod of `radius_m` > 0 through `point_m` along
 * `along` (unit); zero when it is clear. */
vec3 box_clear_rod(const struct box *box, vec3 point_m, vec3 along, float radius_m);

#endif
