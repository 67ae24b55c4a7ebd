/* piecewise_fit.h -- approximates a function of progress by a small number of samples with straight
 * lines between.
 *
 * An animation in a file is a table of samples. The required density depends on the curvature of
 * the function, so samples are added only where the straight line is not accurate enough. */
#ifndef KINGYO_PLATFORM_CTL_LIB_PIECEWISE_FIT_H
#define KINGYO_PLATFORM_CTL_LIB_PIECEWISE_FIT_H

#include <stdbool.h>
#include <stdint.h>

/* Maximum number of halvings. The smallest interval is a 16,384th of the interval between two
 * marks. */
#define PIECEWISE_FIT_HALVINGS 14u

struct piecewise_fit_function {
    uint32_t width; /* Number of values of the function at one progress. */
    void (*ask)(const void *self, float progress, float *values);
    /* Returns the error if the mean of `from` and `to` is used instead of `exact`. */
    float (*error)(const void *self, const float *from, const float *to, const float *exact);
    const void *self;
};

struct piecewise_fit {
    uint32_t count, width;
    /* Progress of each sample, in rising order. The array has `count` elements and belongs to the
     * track. */
    float *progress;
    /* Values of the samples. The array has `count` x `width` elements and belongs to the track. */
    float *values;
};

/* Samples the function at every mark. There are at least two marks, in rising order from 0 to 1.
 * Adds samples until the error in the middle of every two neighbours is at most `tolerance`.
 * Returns false if memory allocation fails. */
bool piecewise_fit_fit(struct piecewise_fit *track, const struct piecewise_fit_function *function,
                       const float *marks, uint32_t mark_count, float tolerance);

/* Frees the samples of a track. */
void piecewise_fit_free(struct piecewise_fit *track);

#endif
