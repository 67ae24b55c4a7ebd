/* view.h -- the camera: position, direction and field of view.
 *
 * The camera is part of the core's contracts because two sides must agree on it. The renderer draws
 * the tank with the camera, and pointer devices find the point of the water under the pointer. */
#pragma once

#include <stdbool.h>

#include "core/base/fmath.h"
#include "core/base/vec.h"

struct view {
    vec3 eye_m;
    vec3 target_m;
    /* Tangent of half the vertical field of view, for screens whose aspect ratio is at least
     * `aspect_min`. */
    float half_height_tan;
    /* Smallest aspect ratio, width over height, with the field of view of `half_height_tan`.
     * Narrower screens use a larger vertical field of view, so that the whole width of the tank is
     * still visible. */
    float aspect_min;
};

/* A tank is shown from its short side on a portrait screen. The player then stands at the right end
 * of the tank (+x), so that the player's axes differ from the axes of the world by a quarter turn:
 * the player's right is -z, and the direction toward the player is +x. Controllers and their
 * drivers always use the player's axes. The core uses the axes of the world. */

/* Converts a vector from the player's axes to the axes of the world. */
static inline vec3 view_to_world(bool is_turned, vec3 v)
{
    return is_turned ? v3(v.z, v.y, 0.0f - v.x) : v;
}

/* Converts a vector from the axes of the world to the player's axes. */
static inline vec3 view_from_world(bool is_turned, vec3 v)
{
    return is_turned ? v3(0.0f - v.z, v.y, v.x) : v;
}

/* Returns the stereo position of the place `at_m` in a tank of the size `size_m`, both in the axes
 * of the world: from -1 at the player's left end of the tank to 1 at the right end. */
static inline float view_pan(bool is_turned, vec3 size_m, vec3 at_m)
{
    const float width_m = f_abs(view_from_world(is_turned, size_m).x);
    return f_clamp(2.0f * view_from_world(is_turned, at_m).x / width_m, -1.0f, 1.0f);
}

/* Yaw in rad that a pose has in the world if its yaw is 0 in the player's axes. */
#define VIEW_TURN_RAD (90.0f * F_DEG)

/* Returns the axes of the camera. The axis `back` points from the target to the eye. */
struct basis view_basis(const struct view *view);

/* Returns the place of `point_m` in the picture of the camera, at a distance of 1 from the eye: to
 * the right (x) and up (y). z is the length in this picture of one metre at the point. */
vec3 view_project(const struct view *view, vec3 point_m);

/* Returns true if the camera shows the tank from its short side. */
bool view_is_turned(const struct view *view);

/* Returns the tangent of half the vertical field of view for a screen of aspect ratio `aspect`
 * (width over height) > 0. */
float view_half_height_tan(const struct view *view, float aspect);

/* Returns the point of the horizontal plane y = `height_m` that the camera shows at a screen point.
 * `x` runs from -1 (left) to 1 (right), and `y` from -1 (bottom) to 1 (top). If the camera ray
 * misses the plane, because the screen point is above the horizon, the returned point is 4 m
 * away. */
vec3 view_point_on_plane(const struct view *view, float aspect, float x, float y, float height_m);
