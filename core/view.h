/* view.h -- where the player's eyes are.
 *
 * The camera belongs to the core's contracts because two sides must agree on it: the renderer that
 * draws the tank, and a pointer device that finds the spot of water under the pointer. */
#ifndef KINGYO_CORE_VIEW_H
#define KINGYO_CORE_VIEW_H

#include "core/base/vec.h"

struct view {
    vec3 eye_m;
    vec3 target_m;
    float half_height_tan; /* tan of half the vertical field of view at `aspect_min` and wider. */
    float aspect_min;      /* Narrower screens see more above and below: the tank still fits. */
};

/* The eye's axes: `back` points from the target to the eye. */
struct basis view_basis(const struct view *view);

/* tan of half the vertical field for a screen of width / height `aspect` > 0. */
float view_half_height_tan(const struct view *view, float aspect);

/* The point of the plane y = `height_m` under a screen point: x -1 left .. 1 right, y -1 bottom ..
 * 1 top. Rays that miss the plane (above the horizon) end 4 m away. */
vec3 view_point_on_plane(const struct view *view, float aspect, float x, float y, float height_m);

#endif
