/* summary.c -- sorts values and computes quantiles. */
#include "platform/ctl/lib/summary.h"

#include <stdlib.h>

static int by_size(const void *left, const void *right)
{
    const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
    return (a > b) - (a < b);
}

double summary_quantile(const uint32_t *sorted, uint32_t count, double share)
{
    const double place = share * (double)(count - 1u);
    const uint32_t below = (uint32_t)place;
    const uint32_t above = below + 1u < count ? below + 1u : below;
    const double part = place - (double)below;
    return (double)sorted[below] * (1.0 - part) + (double)sorted[above] * part;
}

struct summary summary_of(uint32_t *values, uint32_t count)
{
    qsort(values, count, sizeof values[0], by_size);
    return (struct summary){
        .median = summary_quantile(values, count, 0.5),
        .p90 = summary_quantile(values, count, 0.9),
        .max = values[count - 1u],
    };
}
