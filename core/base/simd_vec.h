/* simd_vec.h -- SIMD form of vec.h: computes SIMD_LANES vectors at once. The result of each lane is
 * bit-identical to the result of the scalar function. */
#pragma once

#include "core/base/simd.h"

struct simd_v3 {
    flanes x, y, z;
};

struct simd_basis {
    struct simd_v3 right, up, back;
};

static inline struct simd_v3 simd_v3(flanes x, flanes y, flanes z)
{
    return (struct simd_v3){ x, y, z };
}

static inline struct simd_v3 simd_v3_sub(struct simd_v3 a, struct simd_v3 b)
{
    return simd_v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct simd_v3 simd_v3_scale(struct simd_v3 a, flanes s)
{
    return simd_v3(a.x * s, a.y * s, a.z * s);
}

/* Returns a + b * s. */
static inline struct simd_v3 simd_v3_muladd(struct simd_v3 a, struct simd_v3 b, flanes s)
{
    return simd_v3(a.x + b.x * s, a.y + b.y * s, a.z + b.z * s);
}

static inline flanes simd_v3_dot(struct simd_v3 a, struct simd_v3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct simd_v3 simd_v3_cross(struct simd_v3 a, struct simd_v3 b)
{
    return simd_v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline flanes simd_v3_length(struct simd_v3 a)
{
    return simd_sqrt(simd_v3_dot(a, a));
}

/* Returns v3_limit() of each lane. */
static inline struct simd_v3 simd_v3_limit(struct simd_v3 a, flanes length_max)
{
    const flanes length = simd_v3_length(a);
    const ilanes longer = length > length_max;
    const flanes s = length_max / length;
    return simd_v3(simd_select(longer, a.x * s, a.x), simd_select(longer, a.y * s, a.y),
                   simd_select(longer, a.z * s, a.z));
}

/* Returns vec_basis_from_angles() of each lane, given the sines and cosines of the angles. */
static inline struct simd_basis simd_basis(struct simd_sin_cos yaw, struct simd_sin_cos pitch,
                                           struct simd_sin_cos roll)
{
    const struct simd_v3 right = { yaw.cos, simd_splat(0.0f), -yaw.sin };
    const struct simd_v3 back = { yaw.sin * pitch.cos, -pitch.sin, yaw.cos * pitch.cos };
    const struct simd_v3 up = simd_v3_cross(back, right);
    return (struct simd_basis){
        .right = simd_v3_muladd(simd_v3_scale(right, roll.cos), up, -roll.sin),
        .up = simd_v3_muladd(simd_v3_scale(up, roll.cos), right, roll.sin),
        .back = back,
    };
}
