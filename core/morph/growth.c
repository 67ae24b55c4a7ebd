/* growth.c -- how long a fish is at an age, and how old at a length. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

#define DAYS_PER_YEAR 365.25f
#define AGE_MAX_DAYS (40.0f * DAYS_PER_YEAR) /* The oldest goldfish on record lived 43 years. */
#define BISECTIONS 20                        /* 14,610 days halved so often are 0.014 days. */

/* The plain curve gives 12 to 32 cm at hatching for most adult fits, and moving t0 to mend that
 * spoils the adults; so the hatch length fades into the curve instead, within a few tau. */
float growth_length_m(const struct growth *growth, float age_days)
{
    CORE_ASSERT(age_days >= 0.0f);
    CORE_ASSERT(growth->hatch_tau_year > 0.0f);
    const float age_years = f_min(age_days, AGE_MAX_DAYS) / DAYS_PER_YEAR;
    const float adult =
        growth->length_inf_m * (1.0f - f_exp(-growth->k_per_year * (age_years - growth->t0_year)));
    const float young = f_exp(-age_years / growth->hatch_tau_year);
    return f_max(adult + (growth->hatch_length_m - adult) * young, growth->hatch_length_m);
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
