/* statistics.h -- tests whether two ways to play differ in the number of fish that they catch with
 * the same seeds.
 *
 * Two methods are used. The paired t interval gives the size of the difference. The t interval is
 * valid because the mean of 200 differences has nearly a normal distribution. Wilcoxon's
 * signed-rank test shows whether there is any difference, without assuming a normal distribution.
 * The distribution of the rank sum is computed exactly. */
#ifndef KINGYO_TESTS_BENCH_STATISTICS_H
#define KINGYO_TESTS_BENCH_STATISTICS_H

#include <stdint.h>

#define STATISTICS_PAIRS_MAX 2000u

struct comparison {
    double mean_a, mean_b;
    /* Mean of the differences a - b. */
    double difference;
    /* Bounds of the 95 % confidence interval of `difference`. With a single pair the interval is
     * infinite. */
    double low, high;
    double p; /* Two-sided p value; 1 if no pair differs. */
};

/* Compares the catches `a` and `b` of `count` pairs. `count` is in 1 .. STATISTICS_PAIRS_MAX. */
struct comparison statistics_compare(const uint32_t *a, const uint32_t *b, uint32_t count);

#define STATISTICS_SIGNIFICANT 0.05

enum verdict { VERDICT_PAYS, VERDICT_NOT_SHOWN, VERDICT_WRONG_WAY, VERDICT_COUNT };

/* Returns VERDICT_PAYS if the t interval and the signed-rank test both show that `a` caught more
 * than `b`. Returns VERDICT_WRONG_WAY if both show that `b` caught more, and VERDICT_NOT_SHOWN
 * otherwise. */
enum verdict statistics_verdict(const struct comparison *found);

/* Returns the two-sided p value of Wilcoxon's signed-rank test for `count` differences (at most
 * STATISTICS_PAIRS_MAX). Differences of zero are excluded, and differences of equal size share
 * their mean rank. All 2^n assignments of signs are equally likely. */
double statistics_signed_rank_p(const double *differences, uint32_t count);

/* Returns the bound b of Student's t distribution for which P(|t| < b) is 0.95. `freedom` is the
 * number of degrees of freedom, at least 1. */
double statistics_t_95(uint32_t freedom);

#endif
