/* pose.c -- rotates rigid bodies; core/base/vec.h defines the order of the angles. */
#include "core/poi/pose.h"

#include "core/base/panic.h"

struct angles pose_angles(const struct basis *axes)
{
    const vec3 forward = v3_scale(axes->back, -1.0f);
    const float level = f_sqrt(forward.x * forward.x + forward.z * forward.z);
    struct angles angles = { .pitch_rad = f_atan2(forward.y, level) };
    if (level > 1e-4f) {
        angles.yaw_rad = f_atan2(-forward.x, -forward.z);
    } else { /* If the body faces straight up or down, yaw and roll rotate about the same axis. The
                function returns the whole rotation as yaw. */
        angles.yaw_rad = f_atan2(-axes->right.z, axes->right.x);
    }
    const struct basis flat =
        vec_basis_from_angles((struct angles){ angles.yaw_rad, angles.pitch_rad, 0.0f });
    angles.roll_rad = f_atan2(v3_dot(axes->up, flat.right), v3_dot(axes->up, flat.up));
    return angles;
}

/* Rotates `v` about the unit vector `axis` by Rodrigues' formula. */
static vec3 rotate_about(vec3 v, vec3 axis, float sine, float cosine)
{
    const vec3 across = v3_cross(axis, v);
    const vec3 along = v3_scale(axis, v3_dot(axis, v) * (1.0f - cosine));
    return v3_add(v3_muladd(v3_scale(v, cosine), across, sine), along);
}

struct basis pose_turn(const struct basis *axes, vec3 axis, float angle_rad)
{
    CORE_ASSERT(f_is_finite(angle_rad));
    const float sine = f_sin(angle_rad), cosine = f_cos(angle_rad);
    return (struct basis){
        .right = rotate_about(axes->right, axis, sine, cosine),
        .up = rotate_about(axes->up, axis, sine, cosine),
        .back = rotate_about(axes->back, axis, sine, cosine),
    };
}

struct basis pose_look(vec3 forward, vec3 up)
{
    const vec3 back = v3_scale(forward, -1.0f);
    const vec3 spare = f_abs(forward.y) < 0.9f ? v3(0.0f, 1.0f, 0.0f) : v3(1.0f, 0.0f, 0.0f);
    vec3 right = v3_cross(up, back);
    if (v3_dot(right, right) < 1e-8f) {
        right = v3_cross(spare, back);
    }
    right = v3_normalize_or(right, v3(1.0f, 0.0f, 0.0f));
    return (struct basis){ .right = right, .up = v3_cross(back, right), .back = back };
}

static float turn_toward(float from_rad, float to_rad, float share, float step_rad)
{
    CORE_ASSERT(step_rad >= 0.0f);
    const float way_rad = f_wrap_angle(to_rad - from_rad) * share;
    return f_wrap_angle(from_rad + f_clamp(way_rad, -step_rad, step_rad));
}

struct angles pose_toward(struct angles from, struct angles to, float share, float step_rad)
{
    return (struct angles){
        .yaw_rad = turn_toward(from.yaw_rad, to.yaw_rad, share, step_rad),
        .pitch_rad = turn_toward(from.pitch_rad, to.pitch_rad, share, step_rad),
        .roll_rad = turn_toward(from.roll_rad, to.roll_rad, share, step_rad),
    };
}

struct poi_target pose_between(struct poi_target from, struct poi_target to, float share)
{
    return (struct poi_target){
        .position_m = v3_lerp(from.position_m, to.position_m, share),
        .angles = pose_toward(from.angles, to.angles, share, F_PI),
    };
}
