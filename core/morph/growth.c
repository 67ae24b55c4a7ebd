/* growth.c -- computes the length of a fish at an age, and its age at a length.
 *
 * The growth table has measured lengths up to an age, and von Bertalanffy's curve VB (2005
 * thesis, eq. 3.3) continues the table. VB is fitted to adults. Without the table, VB gives 12
 * to 32 cm at hatching for most species. The thesis shifts the constant t0 to correct the length
 * at hatching, but then the adults are too small (a bigeye of one year is 38 cm long instead of
 * 64 cm). In this code, the length gradually changes from the last measured length L0 to VB: L =
 * L0 + (VB - L0) * (1 - e^(-s / fade)). s is the time after the last measured point, and fade is
 * the time constant. */
#include "core/morph/morph.h"

#include "core/base/panic.h"
#include "core/morph/cubic.h"

#define DAYS_PER_YEAR 365.25f
/* Highest age that the growth functions use. Hardly any fish is older; the oldest goldfish on
 * record lived for 43 years. */
#define AGE_MAX_DAYS (40.0f * DAYS_PER_YEAR)
/* Time constant of half a minute for growth_shifted(). With this short time, the length follows von
 * Bertalanffy's curve practically from hatching. */
#define FADE_NONE_YEAR 1e-6f
/* Number of bisections of an age range. After 24 bisections, a range of 14,610 days is 0.001 days
 * wide. */
#define BISECTIONS 24

/* Returns the difference, in metres, by which von Bertalanffy's curve exceeds the last measured
 * length. Returns 0 if the curve is below the last measured length, so that the fish keeps its
 * length and does not shrink. */
static float curve_lead_m(const struct growth *growth, float age_days)
{
    const struct growth_point *last = &growth->points[growth->point_count - 1];
    const float age_years = f_min(age_days, AGE_MAX_DAYS) / DAYS_PER_YEAR;
    const float grown = 1.0f - f_exp(-growth->k_per_year * (age_years - growth->t0_year));
    return f_max(growth->length_inf_m * grown - last->length_m, 0.0f);
}

/* Returns the length at an age before the last measured point. At that point, the growth rate
 * equals the initial growth rate of the curve for older fish, so that the length has no corner. The
 * growth rate is limited so that the length stays monotone. */
static float among_points_m(const struct growth *growth, float age_days)
{
    struct cubic_point points[GROWTH_POINT_MAX];
    CORE_ASSERT(growth->point_count >= 2);
    for (uint32_t i = 0; i < growth->point_count; i++) {
        points[i] = (struct cubic_point){ growth->points[i].age_days, growth->points[i].length_m };
    }
    const struct cubic_point *last = &points[growth->point_count - 1u];
    const float steepest = 3.0f * (last->value - last[-1].value) / (last->at - last[-1].at);
    const float onward = curve_lead_m(growth, last->at) / (growth->fade_year * DAYS_PER_YEAR);
    const float slope = f_clamp(onward, 0.0f, f_max(steepest, 0.0f));
    return cubic_curve(points, growth->point_count, age_days, &slope);
}

float growth_length_m(const struct growth *growth, float age_days)
{
    CORE_ASSERT(age_days >= 0.0f);
    CORE_ASSERT(growth->fade_year > 0.0f);
    CORE_ASSERT(growth->point_count >= 1 && growth->point_count <= GROWTH_POINT_MAX);
    const struct growth_point *last = &growth->points[growth->point_count - 1];
    if (age_days < last->age_days) {
        return among_points_m(growth, age_days);
    }
    const float since_years = (f_min(age_days, AGE_MAX_DAYS) - last->age_days) / DAYS_PER_YEAR;
    const float young = f_exp(-f_max(since_years, 0.0f) / growth->fade_year);
    return last->length_m + curve_lead_m(growth, age_days) * (1.0f - young);
}

struct growth growth_shifted(const struct growth *growth)
{
    CORE_ASSERT(growth->point_count >= 1 && growth->length_inf_m > 0.0f);
    const struct growth_point hatching = growth->points[0];
    const float share = f_clamp(hatching.length_m / growth->length_inf_m, 0.0f, 0.999f);
    return (struct growth){
        .length_inf_m = growth->length_inf_m,
        .k_per_year = growth->k_per_year,
        .t0_year = f_log(1.0f - share) / growth->k_per_year,
        .fade_year = FADE_NONE_YEAR,
        .point_count = 1,
        .points = { hatching },
    };
}

/* Returns the age at which a fish has the length `length_m`, found by bisection. The caller
 * guarantees that no measured point lies between the two ages. The length is therefore monotone
 * between the ages. */
static float age_in_span(const struct growth *growth, float from_days, float to_days,
                         float length_m)
{
    const bool rises = growth_length_m(growth, to_days) > growth_length_m(growth, from_days);
    for (int i = 0; i < BISECTIONS; i++) {
        const float middle = 0.5f * (from_days + to_days);
        if ((growth_length_m(growth, middle) < length_m) == rises) {
            from_days = middle;
        } else {
            to_days = middle;
        }
    }
    return 0.5f * (from_days + to_days);
}

float growth_age_between(const struct growth *growth, float from_days, float to_days,
                         float length_m)
{
    CORE_ASSERT(from_days >= 0.0f && from_days <= to_days);
    float from = from_days, at_m = growth_length_m(growth, from);
    if (at_m == length_m) {
        return from;
    }
    for (uint32_t i = 0; i <= growth->point_count; i++) {
        const float point_days = i < growth->point_count ? growth->points[i].age_days : to_days;
        const float to = f_clamp(point_days, from, to_days);
        const float next_m = growth_length_m(growth, to);
        if ((at_m < length_m) != (next_m < length_m) || next_m == length_m) {
            return next_m == length_m ? to : age_in_span(growth, from, to, length_m);
        }
        from = to;
        at_m = next_m;
    }
    return -1.0f;
}

float growth_age_days(const struct growth *growth, float length_m)
{
    if (!(length_m > growth_length_m(growth, 0.0f))) {
        return 0.0f;
    }
    const float age_days = growth_age_between(growth, 0.0f, AGE_MAX_DAYS, length_m);
    return age_days < 0.0f ? AGE_MAX_DAYS : age_days;
}

bool growth_is_one_way(const struct growth *growth, float from_days, float to_days)
{
    CORE_ASSERT(from_days <= to_days);
    const float end_m = growth_length_m(growth, to_days);
    float at_m = growth_length_m(growth, from_days);
    const bool rises = end_m > at_m;
    if (end_m == at_m) {
        return false;
    }
    for (uint32_t i = 0; i < growth->point_count; i++) {
        const struct growth_point *point = &growth->points[i];
        if (point->age_days > from_days && point->age_days < to_days) {
            if ((point->length_m > at_m) != rises) {
                return false;
            }
            at_m = point->length_m;
        }
    }
    return (end_m > at_m) == rises;
}
