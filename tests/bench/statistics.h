/* statistics.h -- whether two ways to play differ, by what they caught of the same seeds. Pure.
 *
 * Two answers that share no assumption: how large the difference is, by the paired t (the mean of
 * 200 differences is as good as normal, whatever the catches are); and whether there is one at all,
 * by the signed ranks of Wilcoxon's test, whose distribution is counted out and not approached. */
#ifndef KINGYO_TESTS_BENCH_STATISTICS_H
#define KINGYO_TESTS_BENCH_STATISTICS_H

#include <stdint.h>

#define STATISTICS_PAIRS_MAX 2000u

struct comparison {
    double mean_a, mean_b;
    double difference;    /* Mean of a - b ... */
    double low, high;     /* ... and its 95 % confidence interval; infinite for a single pair. */
    double p;             /* Two-sided; 1 where no pair differs. */
};

/* `count` in 1 .. STATISTICS_PAIRS_MAX pairs. */
struct comparison statistics_compare(const uint32_t *a, const uint32_t *b, uint32_t count);

#define STATISTICS_SIGNIFICANT 0.05

enum verdict { VERDICT_PAYS, VERDICT_NOT_SHOWN, VERDICT_WRONG_WAY, VERDICT_COUNT };

/* Whether a caught more than b: it pays only where the interval and the ranks both say so, and goes
 * the wrong way only where both say that. */
enum verdict statistics_verdict(const struct comparison *found);

/* Two-sided p of the signed ranks of `count` <= STATISTICS_PAIRS_MAX differences: zeros are left
 * out, equal sizes share their mean rank, and every one of the 2^n ways to deal out the signs
 * counts the same. */
double statistics_signed_rank_p(const double *differences, uint32_t count);

/* What |t| with `freedom` >= 1 degrees of freedom does not exceed with probability 0.95. */
double statistics_t_95(uint32_t freedom);

#endif
