/* fmath.c -- implements the functions of fmath.h by polynomials. Each function first reduces its
 * argument to a small range, in which the polynomial is accurate. fmath.h gives the largest errors,
 * which the tests check. */
#include "core/base/fmath.h"

#include <stdint.h>

#include "core/base/mem.h"

#define WHOLE_FROM 8388608.0f /* 2^23. A float of at least this magnitude has no fractional part. */

static uint32_t bits_of(float x)
{
    uint32_t bits;
    MEM_COPY(&bits, &x, sizeof bits);
    return bits;
}

static float float_of(uint32_t bits)
{
    float x;
    MEM_COPY(&x, &bits, sizeof x);
    return x;
}

bool f_is_finite(float x)
{
    return (bits_of(x) & 0x7f800000u) != 0x7f800000u;
}

float f_floor(float x)
{
    if (f_abs(x) >= WHOLE_FROM) {
        return x;
    }
    const float whole = (float)(int32_t)x; /* The conversion to an integer rounds toward zero. */
    return whole > x ? whole - 1.0f : whole;
}

float f_wrap_angle(float x)
{
    if (f_abs(x) < 3.0f) { /* The result of the formula below would be the same. Returning `x` is
                              faster. */
        return x;
    }
    return x - F_TAU * f_floor((x + F_PI) / F_TAU);
}

/* Returns the sine for `x` in [-pi/4, pi/4]. Taylor terms up to x^9 leave an error of 2e-8. */
static float sin_core(float x)
{
    const float s = x * x;
    const float high = 1.0f / 120.0f - s * (1.0f / 5040.0f - s * (1.0f / 362880.0f));
    return x * (1.0f - s * (1.0f / 6.0f - s * high));
}

static float cos_core(float x)
{
    const float s = x * x;
    return 1.0f - s * (0.5f - s * (1.0f / 24.0f - s * (1.0f / 720.0f - s * (1.0f / 40320.0f))));
}

/* Returns the sine of x + shift * pi/2. The range reduction subtracts multiples of pi/2, which is
 * split into a high and a low part. This split keeps the reduction accurate for |x| < 1000. */
static float sin_quadrant(float x, int32_t shift)
{
    const float half_pi_high = 1.5703125f;
    const float half_pi_low = 4.83826794897e-4f;
    const float turns = f_floor(x / (half_pi_high + half_pi_low) + 0.5f);
    const float r = (x - turns * half_pi_high) - turns * half_pi_low;
    switch (((int32_t)turns + shift) & 3) {
    case 0:
        return sin_core(r);
    case 1:
        return cos_core(r);
    case 2:
        return -sin_core(r);
    default:
        return -cos_core(r);
    }
}

float f_sin(float x)
{
    return sin_quadrant(x, 0);
}

float f_cos(float x)
{
    return sin_quadrant(x, 1);
}

/* Returns the arctangent for `x` in [0, 1]. For `x` above tan(pi/8), the function computes the
 * arctangent of a smaller number and adds pi/4. Therefore the polynomial is needed only in [0,
 * tan(pi/8)]. */
static float atan_unit(float x)
{
    const float offset = x > 0.41421356f ? F_PI / 4.0f : 0.0f;
    const float t = x > 0.41421356f ? (x - 1.0f) / (x + 1.0f) : x;
    const float s = t * t;
    const float high = 1.0f / 7.0f - s * (1.0f / 9.0f - s / 11.0f);
    return offset + t * (1.0f - s * (1.0f / 3.0f - s * (0.2f - s * high)));
}

float f_atan2(float y, float x)
{
    const float ay = f_abs(y);
    const float ax = f_abs(x);
    if (ax + ay == 0.0f) {
        return 0.0f;
    }
    const float first = ay <= ax ? atan_unit(ay / ax) : F_PI / 2.0f - atan_unit(ax / ay);
    const float half = x < 0.0f ? F_PI - first : first;
    return y < 0.0f ? -half : half;
}

float f_acos(float x)
{
    const float c = f_clamp(x, -1.0f, 1.0f);
    return f_atan2(f_sqrt(1.0f - c * c), c);
}

float f_exp(float x)
{
    const float c = f_clamp(x, -87.0f, 88.0f);
    const float n = f_floor(c * 1.44269504f + 0.5f);
    const float r = (c - n * 0.693359375f) + n * 2.12194440e-4f; /* The constant ln 2 is split
                                                                    into two parts, which keeps
                                                                    the range reduction accurate. */
    const float high = 1.0f / 6.0f + r * (1.0f / 24.0f + r * (1.0f / 120.0f + r * (1.0f / 720.0f)));
    const float p = 1.0f + r * (1.0f + r * (0.5f + r * high));
    return p * float_of((uint32_t)((int32_t)n + 127) << 23);
}

float f_log(float x)
{
    const uint32_t bits = bits_of(x);
    int32_t exponent = (int32_t)(bits >> 23) - 127;
    float m = float_of((bits & 0x007fffffu) | 0x3f800000u);
    if (m > 1.41421356f) {
        m *= 0.5f;
        exponent++;
    }
    const float t = (m - 1.0f) / (m + 1.0f); /* ln(m) equals 2 * atanh(t). The series of atanh(t)
                                                converges fast, because |t| is below 0.172. */
    const float s = t * t;
    const float high = 0.2f + s * (1.0f / 7.0f + s / 9.0f);
    const float p = 2.0f * t * (1.0f + s * (1.0f / 3.0f + s * high));
    return p + (float)exponent * 0.693147181f;
}
