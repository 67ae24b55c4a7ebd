/* draw_wires.h -- computes the point at which three draw wires meet from the lengths of the wires,
 * and calibrates the converter of a wire from known positions of the wire's end. The functions are
 * pure.
 *
 * Each wire leads from a spool above the tank to an eye on the neck of the poi (a paper scoop). The
 * lengths define three spheres around the spools. The spheres meet in two points, above and below
 * the plane of the spools. The eye is at the lower point.
 *
 * A drum that winds the wire in one layer makes the length a linear function of the converter
 * steps. The two coefficients of the function are found by least squares from all marks. A mark is
 * a known position at which the user holds the wire's end. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"

#define DRAW_WIRE_COUNT 3u
/* Maximum length of a wire in metres. The longest wire of cheap spools has this length. */
#define DRAW_WIRE_MAX_M 3.0f
/* Maximum distance in metres by which the wires may fail to meet in a point. Wires sag and stretch,
 * and the eye in which they end is 5 mm wide. */
#define DRAW_WIRE_SLACK_M 0.020f
/* Minimum depth in metres of the eye below the plane of the spools. For a smaller depth, the
 * computed height is too inaccurate. */
#define DRAW_WIRE_NEAR_M 0.100f

enum draw_wires_result {
    DRAW_WIRES_OK = 0,
    /* The length of at least one wire is invalid, because the wire is not connected or not
     * calibrated. */
    DRAW_WIRES_LENGTH,
    /* The wires do not meet in a point, because a wire is slack, caught or broken. */
    DRAW_WIRES_APART,
    /* The wires meet too high: less than DRAW_WIRE_NEAR_M below the plane of the spools. */
    DRAW_WIRES_HIGH,
    DRAW_WIRES_RESULT_COUNT,
};

/* Returns a static text that describes the result, without a full stop. */
const char *draw_wires_text(enum draw_wires_result result);

/* Returns true if spools at these positions determine where the three wires meet. Two spools must
 * be at least 10 cm apart, and the three spools must not lie on one line. */
bool draw_wires_is_determined(const vec3 spool_m[DRAW_WIRE_COUNT]);

/* Computes the position of the eye in world axes, in metres. The spools must satisfy
 * draw_wires_is_determined(). Leaves `out` unchanged unless the result is DRAW_WIRES_OK. */
enum draw_wires_result draw_wires_meet(const vec3 spool_m[DRAW_WIRE_COUNT],
                                       const float length_m[DRAW_WIRE_COUNT], vec3 *out);

/* Computes the lengths of the wires for a position of the eye, as the inverse of draw_wires_meet().
 * The simulated sensors use this function. */
void draw_wires_lengths(const vec3 spool_m[DRAW_WIRE_COUNT], vec3 eye_m,
                        float length_m[DRAW_WIRE_COUNT]);

/* ---- Calibration ----------------------------------------------------------------------------- */

/* Minimum difference between the largest and the smallest converter step of the calibration marks.
 * With a smaller difference, the fitted step size is inaccurate. */
#define WIRE_FIT_STEPS_MIN 100.0f
/* Maximum error of a calibration mark in metres. A larger error means that a mark is wrong, or that
 * the wire is wound in several layers. */
#define WIRE_FIT_MISS_MAX_M 0.005f

struct wire_fit {
    uint32_t count;
    /* Converter steps (`step`) and wire length in metres (`length_m`) of each mark. The arrays have
     * POI_CONFIG_MARK_MAX elements. */
    float step[8], length_m[8];
    /* Results of the fit in metres. `zero_m` is the wire length at converter step 0, and `step_m`
     * is the length of one step. */
    float zero_m, step_m;
    /* Maximum difference in metres between the measured and the fitted wire length, over all
     * marks. */
    float miss_m;
};

/* Adds a mark with its converter steps and its wire length in metres. Asserts that the arrays have
 * room. */
void draw_wires_fit_add(struct wire_fit *fit, float step, float length_m);

/* Computes the coefficients from all marks. Returns true. If the marks are too few, too close
 * together or inconsistent, sets `why` to a static text and returns false. */
bool draw_wires_fit_solve(struct wire_fit *fit, const char **why);
