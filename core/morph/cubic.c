/* cubic.c -- interpolates points by a cubic curve that never overshoots the points. */
#include "core/morph/cubic.h"

#include <stdbool.h>

#include "core/base/fmath.h"
#include "core/base/panic.h"

static float rise(const struct cubic_point *from)
{
    return (from[1].value - from->value) / (from[1].at - from->at);
}

/* Returns the slope of the curve at the first or the last point. h0 and d0 are the width and the
 * slope of the interval at that end. h1 and d1 are the width and the slope of the next interval
 * toward the middle. */
static float end_slope(float h0, float d0, float h1, float d1)
{
    const float slope = ((2.0f * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (!(slope * d0 > 0.0f)) {
        return 0.0f;
    }
    return d0 * d1 <= 0.0f && f_abs(slope) > 3.0f * f_abs(d0) ? 3.0f * d0 : slope;
}

float cubic_slope(const struct cubic_point *points, uint32_t count, uint32_t index)
{
    CORE_ASSERT(count >= 2 && index < count);
    if (count == 2) {
        return rise(points);
    }
    const uint32_t last = count - 1u;
    const struct cubic_point *middle = &points[index == 0 ? 1u : index == last ? last - 1u : index];
    /* h0 and d0 are the width and the slope of the interval before `middle`. h1 and d1 are the
     * width and the slope of the interval after `middle`. */
    const float h0 = middle->at - middle[-1].at, d0 = rise(middle - 1);
    const float h1 = middle[1].at - middle->at, d1 = rise(middle);
    if (index == 0) {
        return end_slope(h0, d0, h1, d1);
    }
    if (index == last) {
        return end_slope(h1, d1, h0, d0);
    }
    if (!(d0 * d1 > 0.0f)) {
        return 0.0f; /* At a peak, at a trough and beside a level interval, the slope is 0. */
    }
    /* The slope at an inner point is the weighted harmonic mean of the slopes on both sides. */
    const float near = 2.0f * h1 + h0, far = h1 + 2.0f * h0;
    return (near + far) / (near / d0 + far / d1);
}

float cubic_curve(const struct cubic_point *points, uint32_t count, float at,
                  const float *last_slope)
{
    uint32_t next = 1;
    CORE_ASSERT(count >= 2);
    while (next + 1u < count && at > points[next].at) {
        next++;
    }
    const struct cubic_point *from = &points[next - 1], *to = &points[next];
    const float t = f_clamp((at - from->at) / (to->at - from->at), 0.0f, 1.0f), left = 1.0f - t;
    const float slope_from = cubic_slope(points, count, next - 1);
    const bool is_given = next + 1u == count && last_slope;
    const float slope_to = is_given ? *last_slope : cubic_slope(points, count, next);
    const float risen = t * t * (3.0f - 2.0f * t);
    const float bend = (to->at - from->at) * t * left * (slope_from * left - slope_to * t);
    return from->value * (1.0f - risen) + to->value * risen + bend;
}
