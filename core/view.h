/* view.h -- the camera: position, direction and field of view.
 *
 * The camera is part of the core's contracts because two sides must agree on it. The renderer draws
 * the tank with the camera, and pointer devices find the point of the water under the pointer. */
#ifndef KINGYO_CORE_VIEW_H
#define KINGYO_CORE_VIEW_H

#include "core/base/vec.h"

struct view {
    vec3 eye_m;
    vec3 target_m;
    float half_height_tan; /* Tangent of half the vertical field of view on screens of `aspect_min`
                              and wider. */
    float aspect_min;      /* Narrower screens use a larger vertical field of view, so that the tank
                              still fits. */
};

/* Returns the axes of the camera: `back` points from the target to the eye. */
struct basis view_basis(const struct view *view);

/* Returns the tangent of half the vertical field of view for a screen of width / height `aspect` >
 * 0. */
float view_half_height_tan(const struct view *view, float aspect);

/* Returns the point of the plane y = `height_m` under a screen point: x -1 left .. 1 right, y -1
 * bottom .. 1 top. For a ray that misses the plane (above the horizon) the point is 4 m away. */
vec3 view_point_on_plane(const struct view *view, float aspect, float x, float y, float height_m);

#endif
