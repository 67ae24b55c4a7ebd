/* body.h -- the oriented box of a fish in one cache line, for the broad phase and the contact
 * solver.
 *
 * A body consists of four quads (groups of four floats), so that SIMD code loads a quad with one
 * instruction. */
#ifndef KINGYO_CORE_TANK_COLLISION_BODY_H
#define KINGYO_CORE_TANK_COLLISION_BODY_H

#include "core/tank/collision/box.h"

struct body {
    vec3 centre_m;
    float half_x_m; /* Half of the width, along `right`. */
    vec3 right;     /* Unit axes of the body in world coordinates, as in struct basis. */
    float half_y_m; /* Half of the height, along `up`. */
    vec3 up;
    float half_z_m; /* Half of the length, along `back`. */
    vec3 back;
    float margin_m; /* Size of the personal space beyond the body on every side. */
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

/* Returns half the size of the smallest axis-aligned box that contains the body. */
static inline vec3 body_extent_m(const struct body *body)
{
    return box_upright_m(body->right, body->up, body->back,
                         v3(body->half_x_m, body->half_y_m, body->half_z_m));
}

#endif
