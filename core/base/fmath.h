/* fmath.h -- single-precision mathematics that gives the same bits on every platform.
 *
 * The functions do not use libm. Each function is a fixed sequence of IEEE additions,
 * multiplications, divisions and square roots. Therefore gcc, clang, every optimisation level and
 * every CPU agree to the last bit (with -ffp-contract=off). Angles are in radians. The caller
 * guarantees finite arguments. */
#pragma once

#include <stdbool.h>

#define F_PI 3.14159265f
#define F_TAU 6.28318531f
#define F_DEG (F_PI / 180.0f) /* Factor from degrees to radians. */

/* Returns the square root, rounded to the nearest float. The function is a single instruction on
 * every target with a floating-point unit. */
static inline float f_sqrt(float x)
{
    return __builtin_sqrtf(x);
}

static inline float f_abs(float x)
{
    return __builtin_fabsf(x);
}

static inline float f_min(float a, float b)
{
    return a < b ? a : b;
}

static inline float f_max(float a, float b)
{
    return a > b ? a : b;
}

static inline float f_clamp(float x, float low, float high)
{
    return f_min(f_max(x, low), high);
}

static inline float f_lerp(float a, float b, float t)
{
    return a + (b - a) * t;
}

/* Returns 0 if x <= low, 1 if x >= high, and otherwise a cubic that is flat at both ends. The
 * caller guarantees low < high. */
static inline float f_smoothstep(float low, float high, float x)
{
    const float t = f_clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

float f_floor(float x);
float f_sin(float x); /* |error| < 2e-6 for |x| < 1000. */
float f_cos(float x); /* |error| < 2e-6 for |x| < 1000. */
/* Returns the angle of the point (x, y) in (-pi, pi], with an error below 3e-6. For (0, 0) the
 * result is 0. */
float f_atan2(float y, float x);
float f_acos(float x); /* Returns the arc cosine of x, clamped to [-1, 1]. The error is below
                          1e-4. */
/* Returns e^x, with x clamped to [-87, 88]. The relative error is below 3e-6. */
float f_exp(float x);
/* Returns the natural logarithm. The caller guarantees that x is > 0 and no denormal number. The
 * error is below 3e-6 for x in [1e-6, 1e6]. */
float f_log(float x);
/* Returns the angle in [-pi, pi) that points in the same direction as x, for |x| < 1000. */
float f_wrap_angle(float x);
bool f_is_finite(float x);
