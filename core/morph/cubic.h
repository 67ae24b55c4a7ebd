/* cubic.h -- the monotone cubic (PCHIP) through the knots of a graph and the points of a growth
 * table.
 *
 * The curve passes through every point, has no corner, and stays between the values of adjacent
 * points. No weight is therefore below 0, and no fish shrinks where the table grows (slopes:
 * Fritsch and Butland, 1984). */
#ifndef KINGYO_CORE_MORPH_CUBIC_H
#define KINGYO_CORE_MORPH_CUBIC_H

#include <stdint.h>

struct cubic_point {
    float at, value; /* `at` increases from point to point. */
};

/* Returns the slope of the curve through `count` >= 2 points at point `index`. */
float cubic_slope(const struct cubic_point *points, uint32_t count, uint32_t index);

/* Returns the value between two points `span` apart, at `t` in [0, 1]; exact at both ends. */
float cubic_between(const struct cubic_point *from, float slope_from, const struct cubic_point *to,
                    float slope_to, float t);

/* Returns the value of the curve at `at`, clamped to its ends. */
float cubic_curve(const struct cubic_point *points, uint32_t count, float at);

#endif
