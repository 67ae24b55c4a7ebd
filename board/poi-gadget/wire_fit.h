/* wire_fit.h -- calibrates the converter of a draw wire from known positions of the wire's end. The
 * functions are pure.
 *
 * A drum with one layer winds evenly, so the length is a linear function of the converter steps.
 * Its two numbers for each wire are found by least squares from all marks. */
#ifndef KINGYO_BOARD_POI_GADGET_WIRE_FIT_H
#define KINGYO_BOARD_POI_GADGET_WIRE_FIT_H

#include <stdint.h>

/* Least range of the marks in converter steps. A smaller range gives no accurate step size. */
#define WIRE_FIT_STEPS_MIN 100.0f
/* Greatest error of a mark. A larger error means a wrong mark or a wire that is wound in layers. */
#define WIRE_FIT_MISS_MAX_M 0.005f

struct wire_fit {
    uint32_t count;
    /* Converter step and wire length of each mark. The arrays have POI_CONFIG_MARK_MAX elements. */
    float step[8], length_m[8];
    float zero_m, step_m; /* Results: the length at step 0 and the length of one step. */
    float miss_m;         /* Error of the worst mark. */
};

/* Adds one mark: the converter steps and the length of the wire. */
void wire_fit_add(struct wire_fit *fit, float step, float length_m);

/* Fits the line. Returns 1. Returns 0 and sets `why` to a static phrase if the marks are too few,
 * too close together or inconsistent. */
int wire_fit_solve(struct wire_fit *fit, const char **why);

#endif
