/* summary.h -- computes the median, the 90 % quantile and the maximum of many values, for example
 * of the catches of many rounds. The functions are pure. */
#ifndef KINGYO_PLATFORM_CTL_LIB_SUMMARY_H
#define KINGYO_PLATFORM_CTL_LIB_SUMMARY_H

#include <stdint.h>

struct summary {
    /* `median` is the 50 % quantile and `p90` the 90 % quantile. A quantile between two values is
     * interpolated linearly. */
    double median, p90;
    uint32_t max;
};

/* Computes the summary of `count` values. Sorts `values` in place. `count` must be at least 1. */
struct summary summary_of(uint32_t *values, uint32_t count);

/* Returns the quantile `share`, in [0, 1], of `count` sorted values. `count` must be at least 1.
 * The k-th of n values is the quantile (k - 1) / (n - 1), as in most statistics programs (type
 * 7). */
double summary_quantile(const uint32_t *sorted, uint32_t count, double share);

#endif
