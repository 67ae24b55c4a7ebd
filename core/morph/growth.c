/* growth.c -- how long a fish is at an age, and how old at a length. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

#define DAYS_PER_YEAR 365.25f
#define AGE_MAX_DAYS (40.0f * DAYS_PER_YEAR) /* The oldest goldfish on record lived 43 years. */
#define BISECTIONS 20                        /* 14,610 days halved so often are 0.014 days. */

/* The plain curve gives 12 to 32 cm at hatching for most adult fits, and moving t0 to mend that
 * spoils the adults; so the last measured length fades into the curve instead, within a few tau. */
static float beyond_points_m(const struct growth *growth, float age_days)
{
    const struct growth_point *last = &growth->points[growth->point_count - 1];
    const float age_years = f_min(age_days, AGE_MAX_DAYS) / DAYS_PER_YEAR;
    const float adult =
        growth->length_inf_m * (1.0f - f_exp(-growth->k_per_year * (age_years - growth->t0_year)));
    const float since_years = age_years - last->age_days / DAYS_PER_YEAR;
    const float young = f_exp(-since_years / growth->fade_year);
    return adult + (last->length_m - adult) * young;
}

float growth_length_m(const struct growth *growth, float age_days)
{
    const struct growth_point *point = growth->points;
    CORE_ASSERT(age_days >= 0.0f);
    CORE_ASSERT(growth->fade_year > 0.0f);
    CORE_ASSERT(growth->point_count >= 1 && growth->point_count <= GROWTH_POINT_MAX);
    for (uint32_t i = 1; i < growth->point_count; i++) {
        if (age_days < point[i].age_days) {
            const float span = point[i].age_days - point[i - 1].age_days;
            const float part = (age_days - point[i - 1].age_days) / span;
            return f_lerp(point[i - 1].length_m, point[i].length_m, part);
        }
    }
    return beyond_points_m(growth, age_days);
}

float growth_age_days(const struct growth *growth, float length_m)
{
    float low = 0.0f;
    float high = AGE_MAX_DAYS;
    if (length_m <= growth_length_m(growth, low)) {
        return low;
    }
    if (length_m >= growth_length_m(growth, high)) {
        return high;
    }
    for (int i = 0; i < BISECTIONS; i++) {
        const float middle = 0.5f * (low + high);
        if (growth_length_m(growth, middle) < length_m) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5f * (low + high);
}
