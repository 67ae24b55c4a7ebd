/* pose.h -- rotates rigid bodies: converts between axes and angles, and interpolates poses. */
#pragma once

#include "core/base/vec.h"
#include "core/input.h"

/* Returns the yaw, pitch and roll of `axes`. The function is the inverse of
 * vec_basis_from_angles(). The pitch is in [-pi/2, pi/2]. The caller guarantees that `axes` are
 * orthonormal. */
struct angles pose_angles(const struct basis *axes);

/* Returns `axes` rotated by `angle_rad` about the world unit vector `axis`, according to the
 * right-hand rule. */
struct basis pose_turn(const struct basis *axes, vec3 axis, float angle_rad);

/* Returns the axes of a body that faces along the unit vector `forward`. The body's up axis is as
 * near to `up` as possible. */
struct basis pose_look(vec3 forward, vec3 up);

/* Returns angles between `from` and `to`. Each angle changes from `from` by the fraction `share` of
 * the difference, but by at most `step_rad`, in the shorter direction. The results are in [-pi,
 * pi). */
struct angles pose_toward(struct angles from, struct angles to, float share, float step_rad);

/* Returns the pose that is interpolated between the poses `from` and `to`. `share` is 0 at `from`
 * and 1 at `to`. */
struct poi_target pose_between(struct poi_target from, struct poi_target to, float share);
