/* statistics.c -- computes Wilcoxon's signed-rank test with its exact distribution, and Student's t
 * distribution. */
#include "tests/bench/statistics.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

/* ---- Wilcoxon's signed-rank test ------------------------------------------------------------ */

struct ranked {
    double size; /* Absolute value of the difference of a pair. */
    int positive;
    /* Twice the rank. The mean rank of equal differences may end in .5, so the rank is doubled to
     * be an integer. */
    uint32_t twice;
};

static int by_size(const void *left, const void *right)
{
    const double a = ((const struct ranked *)left)->size, b = ((const struct ranked *)right)->size;
    return (a > b) - (a < b);
}

/* Ranks the differences that are not zero by their absolute value, in ascending order, and writes
 * them to `out`. Returns the number of ranked differences. */
static uint32_t rank(const double *differences, uint32_t count, struct ranked *out)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (differences[i] > 0.0 || differences[i] < 0.0) {
            out[kept++] = (struct ranked){ fabs(differences[i]), differences[i] > 0.0, 0 };
        }
    }
    qsort(out, kept, sizeof out[0], by_size);
    for (uint32_t first = 0, end = 0; first < kept; first = end) {
        for (end = first; end < kept && out[end].size <= out[first].size; end++) {
        }
        for (uint32_t i = first; i < end; i++) {
            /* Equal differences share the mean of the ranks first + 1 .. end. The doubled mean is
             * first + 1 + end. */
            out[i].twice = first + 1u + end;
        }
    }
    return kept;
}

/* Computes the exact distribution of the rank sum if each sign is random. share[s] is the fraction
 * of the 2^n sign assignments in which the doubled ranks with a positive sign sum to s. With each
 * rank added, half of the assignments give it a positive sign. */
static void count_ways(const struct ranked *ranked, uint32_t count, double *share)
{
    uint32_t sum = 0;
    share[0] = 1.0;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t step = ranked[i].twice;
        sum += step;
        for (uint32_t s = sum + 1u; s-- > 0;) {
            const double without = s <= sum - step ? share[s] : 0.0;
            share[s] = 0.5 * (without + (s >= step ? share[s - step] : 0.0));
        }
    }
}

/* Returns the two-sided p value: the probability of a rank sum at least as far from the mean as
 * `observed`. `sum` is the sum of all doubled ranks. */
static double two_sided(const double *share, uint32_t sum, uint32_t observed)
{
    const uint32_t far = observed > sum - observed ? observed : sum - observed;
    double tail = 0.0;
    for (uint32_t s = sum + 1u; s-- > far;) {
        tail += share[s];
    }
    return 2.0 * tail < 1.0 ? 2.0 * tail : 1.0;
}

double statistics_signed_rank_p(const double *differences, uint32_t count)
{
    struct ranked *ranked = calloc(count + 1u, sizeof *ranked);
    double *share = calloc((size_t)count * (count + 1u) + 1u, sizeof *share);
    double p = NAN;
    if (ranked && share) {
        const uint32_t kept = rank(differences, count, ranked);
        uint32_t sum = 0, observed = 0;
        for (uint32_t i = 0; i < kept; i++) {
            sum += ranked[i].twice;
            observed += ranked[i].positive ? ranked[i].twice : 0;
        }
        count_ways(ranked, kept, share);
        p = kept > 0 ? two_sided(share, sum, observed) : 1.0;
    }
    free(ranked);
    free(share);
    return p;
}

/* ---- Student's t ----------------------------------------------------------------------------- */

/* Returns P(|T| <= t) for Student's t distribution, by the finite series of Abramowitz and Stegun
 * (26.7.3 and 26.7.4). `freedom` is the number of degrees of freedom. */
static double t_within(double t, uint32_t freedom)
{
    const double angle = atan(t / sqrt((double)freedom));
    const double c2 = cos(angle) * cos(angle);
    const int odd = freedom % 2u == 1u;
    double term = odd ? cos(angle) : 1.0, sum = 0.0;
    for (uint32_t k = odd ? 1u : 0u; k + 2u <= freedom; k += 2u) {
        sum += term;
        term *= c2 * (double)(k + 1u) / (double)(k + 2u);
    }
    return odd ? 2.0 / PI * (angle + sin(angle) * sum) : sin(angle) * sum;
}

double statistics_t_95(uint32_t freedom)
{
    double low = 1.0, high = 20.0;
    for (uint32_t i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        if (t_within(middle, freedom) < 0.95) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

/* ---- Public functions ----------------------------------------------------------------------- */

static double spread_of(const double *values, uint32_t count, double mean)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        sum += (values[i] - mean) * (values[i] - mean);
    }
    return sqrt(sum / (double)(count - 1u));
}

struct comparison statistics_compare(const uint32_t *a, const uint32_t *b, uint32_t count)
{
    double differences[STATISTICS_PAIRS_MAX];
    struct comparison result = { .low = -INFINITY, .high = INFINITY };
    for (uint32_t i = 0; i < count; i++) {
        differences[i] = (double)a[i] - (double)b[i];
        result.mean_a += (double)a[i] / (double)count;
        result.mean_b += (double)b[i] / (double)count;
    }
    result.difference = result.mean_a - result.mean_b;
    if (count > 1) {
        const double error = spread_of(differences, count, result.difference) / sqrt((double)count);
        const double reach = statistics_t_95(count - 1u) * error;
        result.low = result.difference - reach;
        result.high = result.difference + reach;
    }
    result.p = statistics_signed_rank_p(differences, count);
    return result;
}

enum verdict statistics_verdict(const struct comparison *found)
{
    if (found->p >= STATISTICS_SIGNIFICANT) {
        return VERDICT_NOT_SHOWN;
    }
    return found->low > 0.0    ? VERDICT_PAYS
           : found->high < 0.0 ? VERDICT_WRONG_WAY
                               : VERDICT_NOT_SHOWN;
}
