/* wire_fit.c -- fits a straight line to the marks. The coordinates are relative to the mean of the
 * marks to reduce rounding errors. */
#include "board/poi-gadget/wire_fit.h"

#include <assert.h>

#include "core/base/fmath.h"

void wire_fit_add(struct wire_fit *fit, float step, float length_m)
{
    assert(fit->count < sizeof fit->step / sizeof fit->step[0]);
    fit->step[fit->count] = step;
    fit->length_m[fit->count] = length_m;
    fit->count++;
}

static float span_of(const float *values, uint32_t count)
{
    float low = values[0], high = values[0];
    for (uint32_t i = 1; i < count; i++) {
        low = f_min(low, values[i]);
        high = f_max(high, values[i]);
    }
    return high - low;
}

static float mean_of(const float *values, uint32_t count)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < count; i++) {
        sum += values[i];
    }
    return sum / (float)count;
}

int wire_fit_solve(struct wire_fit *fit, const char **why)
{
    if (fit->count < 3) {
        *why = "three marks at least: two make any line true";
        return 0;
    }
    if (span_of(fit->step, fit->count) < WIRE_FIT_STEPS_MIN) {
        *why = "the converter hardly moved from mark to mark: is it on this channel?";
        return 0;
    }
    const float step_mean = mean_of(fit->step, fit->count);
    const float length_mean_m = mean_of(fit->length_m, fit->count);
    float both = 0.0f, square = 0.0f;
    for (uint32_t i = 0; i < fit->count; i++) {
        const float step = fit->step[i] - step_mean;
        both += step * (fit->length_m[i] - length_mean_m);
        square += step * step;
    }
    fit->step_m = both / square;
    fit->zero_m = length_mean_m - fit->step_m * step_mean;
    fit->miss_m = 0.0f;
    for (uint32_t i = 0; i < fit->count; i++) {
        const float length_m = fit->zero_m + fit->step_m * fit->step[i];
        fit->miss_m = f_max(fit->miss_m, f_abs(length_m - fit->length_m[i]));
    }
    if (fit->miss_m > WIRE_FIT_MISS_MAX_M || fit->step_m == 0.0f) {
        *why = "the marks miss a line by over 5 mm: is one misplaced, or the wire in layers?";
        return 0;
    }
    return 1;
}
