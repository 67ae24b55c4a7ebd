/* statistics.h -- tests whether two ways to play differ in their catches with the same seeds.
 *
 * Two methods are used. The paired t interval gives the size of the difference. It is valid
 * because the mean of 200 differences is close to normal. Wilcoxon's signed-rank test shows
 * whether there is any difference, without assuming a normal distribution. Its distribution is
 * computed exactly. */
#ifndef KINGYO_TESTS_BENCH_STATISTICS_H
#define KINGYO_TESTS_BENCH_STATISTICS_H

#include <stdint.h>

#define STATISTICS_PAIRS_MAX 2000u

struct comparison {
    double mean_a, mean_b;
    double difference; /* Mean of a - b. */
    /* 95 % confidence interval of `difference`. For a single pair it is infinite. */
    double low, high;
    double p; /* Two-sided p value; 1 if no pair differs. */
};

/* Compares `count` pairs, 1 .. STATISTICS_PAIRS_MAX. */
struct comparison statistics_compare(const uint32_t *a, const uint32_t *b, uint32_t count);

#define STATISTICS_SIGNIFICANT 0.05

enum verdict { VERDICT_PAYS, VERDICT_NOT_SHOWN, VERDICT_WRONG_WAY, VERDICT_COUNT };

/* Returns VERDICT_PAYS if the t interval and the signed ranks both show that `a` caught more than
 * `b`, and VERDICT_WRONG_WAY if both show the opposite. Otherwise returns VERDICT_NOT_SHOWN. */
enum verdict statistics_verdict(const struct comparison *found);

/* Returns the two-sided p value of Wilcoxon's signed-rank test for `count` differences (at most
 * STATISTICS_PAIRS_MAX). Zeros are excluded, equal sizes share their mean rank, and all 2^n sign
 * assignments count equally. */
double statistics_signed_rank_p(const double *differences, uint32_t count);

/* Returns the 95 % limit of Student's t: |t| is below it with a probability of 0.95. `freedom` is
 * the number of degrees of freedom, at least 1. */
double statistics_t_95(uint32_t freedom);

#endif
