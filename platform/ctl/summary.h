/* summary.h -- many catches in three figures. Pure. */
#ifndef KINGYO_PLATFORM_CTL_SUMMARY_H
#define KINGYO_PLATFORM_CTL_SUMMARY_H

#include <stdint.h>

struct summary {
    double median, p90; /* Between two of the values, in proportion, where they fall between two. */
    uint32_t max;
};

/* Sorts `values` in place; `count` >= 1. */
struct summary summary_of(uint32_t *values, uint32_t count);

/* The value that a share of 0 .. 1 of all lies below, of `count` >= 1 sorted ones: the k-th of n
 * stands for the share (k - 1) / (n - 1), as most statistics programs have it (type 7). */
double summary_quantile(const uint32_t *sorted, uint32_t count, double share);

#endif
