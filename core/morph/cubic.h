/* cubic.h -- the monotone cubic (PCHIP) that joins a graph's knots and a growth table's points.
 *
 * It runs through every point, has no corner, and between two points never leaves what lies between
 * them: no weight below 0, no fish that shrinks where the table grows (slopes: Fritsch and Butland,
 * 1984). */
#ifndef KINGYO_CORE_MORPH_CUBIC_H
#define KINGYO_CORE_MORPH_CUBIC_H

#include "core/base/fmath.h"

/* The slope at a point between spans of lengths h0, h1 > 0 that rise by d0, d1 a unit. */
static inline float cubic_slope(float h0, float d0, float h1, float d1)
{
    if (!(d0 * d1 > 0.0f)) {
        return 0.0f; /* A peak, a trough or a level stretch stays one. */
    }
    const float near = 2.0f * h1 + h0, far = h1 + 2.0f * h0;
    return (near + far) / (near / d0 + far / d1);
}

/* The slope at an end, beside a span h0 that rises by d0; h1 and d1 are the next span's. */
static inline float cubic_end_slope(float h0, float d0, float h1, float d1)
{
    const float slope = ((2.0f * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (!(slope * d0 > 0.0f)) {
        return 0.0f;
    }
    return d0 * d1 <= 0.0f && f_abs(slope) > 3.0f * f_abs(d0) ? 3.0f * d0 : slope;
}

/* `t` in [0, 1] of a span `h` long from `a` to `b`; exact at both ends. */
static inline float cubic_at(float a, float slope_a, float b, float slope_b, float h, float t)
{
    const float rise = t * t * (3.0f - 2.0f * t);
    const float left = 1.0f - t;
    const float bend = h * t * left * (slope_a * left - slope_b * t);
    return a * (1.0f - rise) + b * rise + bend;
}

#endif
