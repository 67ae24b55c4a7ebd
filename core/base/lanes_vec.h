/* lanes_vec.h -- SIMD form of vec.h: LANES vectors at once, each bit-equal to the scalar form. */
#ifndef KINGYO_CORE_BASE_LANES_VEC_H
#define KINGYO_CORE_BASE_LANES_VEC_H

#include "core/base/lanes.h"

struct lanes_v3 {
    flanes x, y, z;
};

struct lanes_basis {
    struct lanes_v3 right, up, back;
};

static inline struct lanes_v3 lanes_v3(flanes x, flanes y, flanes z)
{
    return (struct lanes_v3){ x, y, z };
}

static inline struct lanes_v3 lanes_v3_sub(struct lanes_v3 a, struct lanes_v3 b)
{
    return lanes_v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct lanes_v3 lanes_v3_scale(struct lanes_v3 a, flanes s)
{
    return lanes_v3(a.x * s, a.y * s, a.z * s);
}

/* Returns a + b * s. */
static inline struct lanes_v3 lanes_v3_mad(struct lanes_v3 a, struct lanes_v3 b, flanes s)
{
    return lanes_v3(a.x + b.x * s, a.y + b.y * s, a.z + b.z * s);
}

static inline flanes lanes_v3_dot(struct lanes_v3 a, struct lanes_v3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct lanes_v3 lanes_v3_cross(struct lanes_v3 a, struct lanes_v3 b)
{
    return lanes_v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline flanes lanes_v3_length(struct lanes_v3 a)
{
    return lanes_sqrt(lanes_v3_dot(a, a));
}

/* SIMD form of v3_limit(). */
static inline struct lanes_v3 lanes_v3_limit(struct lanes_v3 a, flanes length_max)
{
    const flanes length = lanes_v3_length(a);
    const ilanes longer = length > length_max;
    const flanes s = length_max / length;
    return lanes_v3(lanes_select(longer, a.x * s, a.x), lanes_select(longer, a.y * s, a.y),
                    lanes_select(longer, a.z * s, a.z));
}

/* SIMD form of basis_from_angles(), from the sines and cosines of the angles. */
static inline struct lanes_basis lanes_basis(struct lanes_sin_cos yaw, struct lanes_sin_cos pitch,
                                             struct lanes_sin_cos roll)
{
    const struct lanes_v3 right = { yaw.cos, lanes_of(0.0f), -yaw.sin };
    const struct lanes_v3 back = { yaw.sin * pitch.cos, -pitch.sin, yaw.cos * pitch.cos };
    const struct lanes_v3 up = lanes_v3_cross(back, right);
    return (struct lanes_basis){
        .right = lanes_v3_mad(lanes_v3_scale(right, roll.cos), up, -roll.sin),
        .up = lanes_v3_mad(lanes_v3_scale(up, roll.cos), right, roll.sin),
        .back = back,
    };
}

#endif
