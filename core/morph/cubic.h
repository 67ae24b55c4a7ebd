/* cubic.h -- a monotone cubic curve (PCHIP) through points: the knots of a graph or the points of a
 * growth table.
 *
 * The curve passes through every point, has no corner, and stays between the values of adjacent
 * points. A curve through weights is therefore never below 0, and a fish never shrinks where its
 * growth table rises. The slopes follow Fritsch and Butland (1984). */
#ifndef KINGYO_CORE_MORPH_CUBIC_H
#define KINGYO_CORE_MORPH_CUBIC_H

#include <stdint.h>

struct cubic_point {
    float at, value; /* Position and value of a point; `at` increases from point to point. */
};

/* Returns the slope of the curve at point `index`. Asserts that `count` is at least 2. */
float cubic_slope(const struct cubic_point *points, uint32_t count, uint32_t index);

/* Returns the value between two adjacent points at the share `t` in [0, 1] of the way. The result
 * is exact at both points. */
float cubic_between(const struct cubic_point *from, float slope_from, const struct cubic_point *to,
                    float slope_to, float t);

/* Returns the value of the curve at position `at`, which is clamped to the ends of the curve. */
float cubic_curve(const struct cubic_point *points, uint32_t count, float at);

#endif
