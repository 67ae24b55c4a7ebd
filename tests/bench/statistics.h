/* statistics.h -- tests whether two ways to play differ in their catches with the same seeds.
 *
 * Two methods answer two questions. The paired t interval gives the size of the difference; the
 * mean of 200 differences is close to normal for any distribution of the catches. Wilcoxon's
 * signed-rank test shows whether there is any difference, and needs no normal distribution. Its
 * distribution is computed exactly. The functions have no side effects. */
#ifndef KINGYO_TESTS_BENCH_STATISTICS_H
#define KINGYO_TESTS_BENCH_STATISTICS_H

#include <stdint.h>

#define STATISTICS_PAIRS_MAX 2000u

struct comparison {
    double mean_a, mean_b;
    double difference; /* Mean of a - b. */
    double low, high;  /* Lower and upper end of the 95 % confidence interval of `difference`.
                          The interval is infinite for a single pair. */
    double p;          /* Two-sided p value; 1 if no pair differs. */
};

/* Compares `count` pairs, 1 .. STATISTICS_PAIRS_MAX. */
struct comparison statistics_compare(const uint32_t *a, const uint32_t *b, uint32_t count);

#define STATISTICS_SIGNIFICANT 0.05

enum verdict { VERDICT_PAYS, VERDICT_NOT_SHOWN, VERDICT_WRONG_WAY, VERDICT_COUNT };

/* Returns whether `a` caught more than `b`. The result is VERDICT_PAYS only if the t interval and
 * the signed ranks both show it, and VERDICT_WRONG_WAY only if both show the opposite. */
enum verdict statistics_verdict(const struct comparison *found);

/* Returns the two-sided p of the signed ranks of `count` differences, at most STATISTICS_PAIRS_MAX.
 * Zeros are excluded, equal sizes share their mean rank, and each of the 2^n sign assignments has
 * the same weight. */
double statistics_signed_rank_p(const double *differences, uint32_t count);

/* Returns the limit that the magnitude of Student's t, with `freedom` degrees of freedom, does not
 * exceed with a probability of 0.95. `freedom` must be at least 1. */
double statistics_t_95(uint32_t freedom);

#endif
