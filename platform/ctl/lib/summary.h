/* summary.h -- summarizes many catches in three numbers. The functions are pure. */
#ifndef KINGYO_PLATFORM_CTL_LIB_SUMMARY_H
#define KINGYO_PLATFORM_CTL_LIB_SUMMARY_H

#include <stdint.h>

struct summary {
    /* Median and 90 % quantile. A quantile between two values is interpolated linearly. */
    double median, p90;
    uint32_t max;
};

/* Computes the summary and sorts `values` in place. `count` must be at least 1. */
struct summary summary_of(uint32_t *values, uint32_t count);

/* Returns the quantile of `share`, 0 .. 1, of `count` >= 1 sorted values. The k-th of n values has
 * the share (k - 1) / (n - 1), as in most statistics programs (type 7). */
double summary_quantile(const uint32_t *sorted, uint32_t count, double share);

#endif
