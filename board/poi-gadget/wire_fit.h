/* wire_fit.h -- what a wire's converter means, by holding its end at known places. Pure.
 *
 * A drum of one layer winds evenly, so length is a line over steps: two numbers a wire, found by
 * least squares from as many marks as there are. */
#ifndef KINGYO_POI_GADGET_WIRE_FIT_H
#define KINGYO_POI_GADGET_WIRE_FIT_H

#include <stdint.h>

#define WIRE_FIT_STEPS_MIN 100.0f   /* Marks nearer to each other say nothing of a step. */
#define WIRE_FIT_MISS_MAX_M 0.005f  /* Worse is a wrong mark or a wire that is wound in layers. */

struct wire_fit {
    uint32_t count;
    float step[8], length_m[8]; /* Measured; POI_CONFIG_MARK_MAX of them. */
    float zero_m, step_m;       /* Found. */
    float miss_m;               /* The worst mark's. */
};

/* Takes one mark: what the converter said, and how long the wire then was. */
void wire_fit_add(struct wire_fit *fit, float step, float length_m);

/* Fits: 1; 0 and one phrase in `why` (static): marks too few, too near, or at odds. */
int wire_fit_solve(struct wire_fit *fit, const char **why);

#endif
