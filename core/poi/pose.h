/* pose.h -- rotation of rigid bodies: conversion between axes and angles, and interpolation of
 * poses. */
#ifndef KINGYO_CORE_POI_POSE_H
#define KINGYO_CORE_POI_POSE_H

#include "core/base/vec.h"
#include "core/input.h"

/* Returns yaw, pitch and roll of `axes`, which is the inverse of vec_basis_from_angles(). The pitch
 * is in [-pi/2, pi/2]. The caller guarantees orthonormal axes. */
struct angles pose_angles(const struct basis *axes);

/* Returns `axes` rotated right-handed by `angle_rad` about the world unit vector `axis`. */
struct basis pose_turn(const struct basis *axes, vec3 axis, float angle_rad);

/* Returns the axes of a body that faces along the unit vector `forward`. The body's up axis is as
 * near to `up` as possible. */
struct basis pose_look(vec3 forward, vec3 up);

/* Returns angles on the way from `from` to `to`. Each angle takes the shorter direction by `share`
 * of the difference, but by at most `step_rad`. The results are in [-pi, pi). */
struct angles pose_toward(struct angles from, struct angles to, float share, float step_rad);

/* Returns the pose at `share` in [0, 1] of the way from the pose `from` to the pose `to`. */
struct poi_target pose_between(struct poi_target from, struct poi_target to, float share);

#endif
