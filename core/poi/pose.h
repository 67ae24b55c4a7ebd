/* pose.h -- turning a rigid body: the way back from axes to angles, and from one pose to another.
 */
#ifndef KINGYO_CORE_POI_POSE_H
#define KINGYO_CORE_POI_POSE_H

#include "core/base/vec.h"
#include "core/input.h"

/* The inverse of basis_from_angles; pitch in [-pi/2, pi/2]. Needs orthonormal axes. */
struct angles pose_angles(const struct basis *axes);

/* The axes turned by `angle_rad` about the world's unit `axis`, right-handed. */
struct basis pose_turn(const struct basis *axes, vec3 axis, float angle_rad);

/* The axes of a body that looks along unit `forward` with its back as near to `up` as can be. */
struct basis pose_look(vec3 forward, vec3 up);

/* From some angles toward others, each the short way round: `share` of the way, at most `step_rad`.
 * They come out in [-pi, pi). */
struct angles pose_toward(struct angles from, struct angles to, float share, float step_rad);

/* `share` in [0, 1] of the way from one place and pose to another. */
struct poi_target pose_between(struct poi_target from, struct poi_target to, float share);

#endif
