/* pose.h -- rotation of rigid bodies: from axes to angles, and between two poses. */
#ifndef KINGYO_CORE_POI_POSE_H
#define KINGYO_CORE_POI_POSE_H

#include "core/base/vec.h"
#include "core/input.h"

/* Returns the angles of the axes: the inverse of vec_basis_from_angles(). The pitch is in [-pi/2,
 * pi/2]. The axes must be orthonormal. */
struct angles pose_angles(const struct basis *axes);

/* Returns the axes rotated by `angle_rad` about the world unit vector `axis`, right-handed. */
struct basis pose_turn(const struct basis *axes, vec3 axis, float angle_rad);

/* Returns the axes of a body that faces along unit `forward`, with its back as near to `up` as
 * possible. */
struct basis pose_look(vec3 forward, vec3 up);

/* Returns angles between `from` and `to`, each the shorter way: `share` of the difference, at most
 * `step_rad`. The results are in [-pi, pi). */
struct angles pose_toward(struct angles from, struct angles to, float share, float step_rad);

/* Returns the pose at `share` in [0, 1] of the way from one pose to another. */
struct poi_target pose_between(struct poi_target from, struct poi_target to, float share);

#endif
