/* vec.h -- vectors and orientations in the world.
 *
 * The world is right-handed. The origin is the centre of the still water surface, +x points to the
 * player's right, +y up and +z toward the player. A body (a fish or a poi, the paper scoop) faces
 * along its own -z, with +x to its right and +y up. An orientation is a yaw about +y (0 faces -z,
 * positive turns left), followed by a pitch (positive lifts the front) and a roll (positive lowers
 * the right side). */
#pragma once

#include <stdbool.h>

#include "core/base/fmath.h"

typedef struct {
    float x, y, z;
} vec3;

struct angles {
    float yaw_rad, pitch_rad, roll_rad;
};

/* Axes of a body in world coordinates: unit vectors that are perpendicular to each other. `back` is
 * the body's +z, so the body faces along -back. */
struct basis {
    vec3 right, up, back;
};

static inline vec3 v3(float x, float y, float z)
{
    return (vec3){ x, y, z };
}

static inline vec3 v3_add(vec3 a, vec3 b)
{
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec3 v3_sub(vec3 a, vec3 b)
{
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec3 v3_scale(vec3 a, float s)
{
    return v3(a.x * s, a.y * s, a.z * s);
}

/* Returns a + b * s. */
static inline vec3 v3_muladd(vec3 a, vec3 b, float s)
{
    return v3(a.x + b.x * s, a.y + b.y * s, a.z + b.z * s);
}

static inline float v3_dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 v3_cross(vec3 a, vec3 b)
{
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline float v3_length(vec3 a)
{
    return f_sqrt(v3_dot(a, a));
}

/* Returns the horizontal unit vector along which a level body with the yaw `yaw_rad` faces. */
static inline vec3 v3_heading(float yaw_rad)
{
    return v3(-f_sin(yaw_rad), 0.0f, -f_cos(yaw_rad));
}

/* Returns the horizontal component of `a`. */
static inline vec3 v3_flat(vec3 a)
{
    return v3(a.x, 0.0f, a.z);
}

/* Returns the distance of `p` from the infinite line through `from` and `to`. Returns the distance
 * from `from` if `from` and `to` are less than 1e-6 apart. */
static inline float v3_from_line(vec3 p, vec3 from, vec3 to)
{
    const vec3 along = v3_sub(to, from), there = v3_sub(p, from);
    const float square = v3_dot(along, along);
    return v3_length(square < 1e-12f ? there
                                     : v3_muladd(there, along, -v3_dot(there, along) / square));
}

/* Returns the unit vector along `a`. Returns `otherwise` if `a` is not longer than 1e-9, because
 * the direction is then undefined. */
static inline vec3 v3_normalize_or(vec3 a, vec3 otherwise)
{
    const float length = v3_length(a);
    return length > 1e-9f ? v3_scale(a, 1.0f / length) : otherwise;
}

static inline vec3 v3_lerp(vec3 a, vec3 b, float t)
{
    return v3_muladd(a, v3_sub(b, a), t);
}

/* Returns `a` if its length is at most `length_max` >= 0. Otherwise returns the vector of length
 * `length_max` in the same direction. */
static inline vec3 v3_limit(vec3 a, float length_max)
{
    const float length = v3_length(a);
    return length > length_max ? v3_scale(a, length_max / length) : a;
}

static inline bool v3_is_finite(vec3 a)
{
    return f_is_finite(a.x) && f_is_finite(a.y) && f_is_finite(a.z);
}

struct basis vec_basis_from_angles(struct angles angles);

/* vec_basis_to_world() converts a vector from body coordinates to world coordinates.
 * vec_basis_to_body() converts a vector from world coordinates to body coordinates. */
vec3 vec_basis_to_world(const struct basis *basis, vec3 body);
vec3 vec_basis_to_body(const struct basis *basis, vec3 world);
