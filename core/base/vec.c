/* vec.c -- converts yaw, pitch and roll into axes, and vectors between body and world
 * coordinates. */
#include "core/base/vec.h"

struct basis vec_basis_from_angles(struct angles angles)
{
    const float cy = f_cos(angles.yaw_rad), sy = f_sin(angles.yaw_rad);
    const float cp = f_cos(angles.pitch_rad), sp = f_sin(angles.pitch_rad);
    const float cr = f_cos(angles.roll_rad), sr = f_sin(angles.roll_rad);
    const vec3 right = v3(cy, 0.0f, -sy);        /* The body's +x axis after the yaw alone. */
    const vec3 back = v3(sy * cp, -sp, cy * cp); /* The body's +z axis after the yaw and the
                                                    pitch. */
    const vec3 up = v3_cross(back, right);
    return (struct basis){
        .right = v3_muladd(v3_scale(right, cr), up, -sr),
        .up = v3_muladd(v3_scale(up, cr), right, sr),
        .back = back,
    };
}

vec3 vec_basis_to_world(const struct basis *basis, vec3 body)
{
    return v3_muladd(v3_muladd(v3_scale(basis->right, body.x), basis->up, body.y), basis->back,
                     body.z);
}

vec3 vec_basis_to_body(const struct basis *basis, vec3 world)
{
    return v3(v3_dot(basis->right, world), v3_dot(basis->up, world), v3_dot(basis->back, world));
}
