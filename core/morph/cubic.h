/* cubic.h -- interpolates points by a monotone cubic curve (PCHIP): the knots of a graph or the
 * points of a growth table.
 *
 * The curve passes through every point, has no corner, and stays between the values of adjacent
 * points. An interpolated weight is therefore never below 0, and a fish never shrinks where its
 * growth table increases. The slopes are computed by the method of Fritsch and Butland (1984). */
#pragma once

#include <stdint.h>

struct cubic_point {
    float at, value; /* Position and value of a point. `at` increases from point to point. */
};

/* Returns the slope of the curve at point `index`. Asserts that `count` is at least 2. */
float cubic_slope(const struct cubic_point *points, uint32_t count, uint32_t index);

/* Returns the value of the curve at the position `at`. Positions before the first point or after
 * the last point are clamped. The value is exact at every point. `last_slope` is the slope of the
 * curve at the last point; if it is null, the slope is the one that cubic_slope() returns. */
float cubic_curve(const struct cubic_point *points, uint32_t count, float at,
                  const float *last_slope);
