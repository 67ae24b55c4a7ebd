/* cubic.h -- the monotone cubic (PCHIP) that joins a graph's knots and a growth table's points.
 *
 * It runs through every point, has no corner, and between two points never leaves what lies between
 * them: no weight below 0, no fish that shrinks where the table grows (slopes: Fritsch and Butland,
 * 1984). */
#ifndef KINGYO_CORE_MORPH_CUBIC_H
#define KINGYO_CORE_MORPH_CUBIC_H

#include <stdint.h>

struct cubic_point {
    float at, value; /* `at` rises from point to point. */
};

/* How steeply the curve through `count` >= 2 points passes number `index`. */
float cubic_slope(const struct cubic_point *points, uint32_t count, uint32_t index);

/* Between two points `span` apart, at `t` in [0, 1] of the way; exact at both ends. */
float cubic_between(const struct cubic_point *from, float slope_from, const struct cubic_point *to,
                    float slope_to, float t);

/* The curve at `at`, clamped to its ends. */
float cubic_curve(const struct cubic_point *points, uint32_t count, float at);

#endif
