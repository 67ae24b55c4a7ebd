/* wire_fit.h -- calibrates the converter of a draw wire from known positions of the wire's end. The
 * functions are pure.
 *
 * A drum that winds the wire in one layer makes the length a linear function of the converter
 * steps. The two coefficients of the function are found by least squares from all marks. A mark is
 * a known position at which the user holds the wire's end. */
#ifndef KINGYO_BOARD_POI_GADGET_WIRE_FIT_H
#define KINGYO_BOARD_POI_GADGET_WIRE_FIT_H

#include <stdint.h>

/* Minimum range of the converter steps over all marks. A smaller range gives no accurate step
 * size. */
#define WIRE_FIT_STEPS_MIN 100.0f
/* Maximum error of a mark in metres. A larger error means that a mark is wrong, or that the wire is
 * wound in several layers. */
#define WIRE_FIT_MISS_MAX_M 0.005f

struct wire_fit {
    uint32_t count;
    /* Converter steps (`step`) and wire length in metres (`length_m`) of each mark. The arrays have
     * POI_CONFIG_MARK_MAX elements. */
    float step[8], length_m[8];
    float zero_m, step_m; /* Results in metres. `zero_m` is the length at step 0, and `step_m` is
                             the length of one step. */
    float miss_m;         /* Greatest difference in metres between the measured and the fitted
                             length of a mark. */
};

/* Adds a mark with its converter steps and its wire length in metres. Asserts that the arrays have
 * room. */
void wire_fit_add(struct wire_fit *fit, float step, float length_m);

/* Computes the coefficients from all marks. Returns 1. If the marks are too few, too close together
 * or inconsistent, sets `why` to a static text and returns 0. */
int wire_fit_solve(struct wire_fit *fit, const char **why);

#endif
