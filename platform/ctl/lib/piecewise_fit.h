/* piecewise_fit.h -- approximates a function of progress by few samples that are connected by
 * straight lines.
 *
 * An animation in a glTF file is a table of samples. Samples are added only where the straight line
 * between two samples is not accurate enough. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Maximum number of times that an interval between two marks is halved. The smallest interval is
 * 1/16,384 of the interval between the marks. */
#define PIECEWISE_FIT_HALVINGS 14u

struct piecewise_fit_function {
    uint32_t width; /* Number of values (components) that the function returns for each progress. */
    void (*sample)(const void *self, float progress, float *values);
    /* Returns the error that occurs if the mean of `from` and `to` replaces `exact`. */
    float (*error)(const void *self, const float *from, const float *to, const float *exact);
    const void *self;
};

struct piecewise_fit {
    uint32_t count, width;
    /* Progress of each sample, in rising order. The array has `count` elements.
     * piecewise_fit_free() frees the array. */
    float *progress;
    /* Values of the samples. The array has `count` x `width` elements. piecewise_fit_free() frees
     * the array. */
    float *values;
};

/* Samples the function at every mark, and then adds samples until the error in the middle of each
 * interval is at most `tolerance`. A mark is a value of progress at which a sample is required. The
 * caller passes at least two marks in rising order from 0 to 1. Returns false if memory allocation
 * fails. */
bool piecewise_fit_fit(struct piecewise_fit *track, const struct piecewise_fit_function *function,
                       const float *marks, uint32_t mark_count, float tolerance);

/* Frees the arrays of the samples. */
void piecewise_fit_free(struct piecewise_fit *track);
