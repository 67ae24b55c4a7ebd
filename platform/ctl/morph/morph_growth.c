/* morph_growth.c -- `kingyoctl morph growth`, which compares three formulas for the length of a
 * fish at an age.
 *
 * The growth curve of von Bertalanffy (2005 thesis, eq. 3.3) gives far too great lengths at
 * hatching for most species. The thesis shifts the start of the curve, which gives too small
 * lengths for adults. Kingyo uses measured lengths for young fish and blends into the curve of von
 * Bertalanffy. The command prints a table with all three lengths. */
#include <math.h>
#include <stdio.h>

#include "platform/ctl/morph/morph_options.h"

static const char name[] = "growth";

#define DAYS_PER_YEAR 365.25
#define YEARS_MAX 40.0

/* Returns the length in mm by eq. 3.3 of the 2005 thesis. `t0_year` is the age in years at which
 * the curve starts with length 0. */
static double von_bertalanffy_mm(const struct growth *growth, double age_days, double t0_year)
{
    const double since_year = age_days / DAYS_PER_YEAR - t0_year;
    const double grown = 1.0 - exp(-(double)growth->k_per_year * since_year);
    return 1e3 * (double)growth->length_inf_m * grown;
}

/* Returns the start of the curve for which eq. 3.3 gives the true length at hatching (2005 thesis,
 * section 3.2). */
static double shifted_t0_year(const struct growth *growth)
{
    const double share = (double)growth->points[0].length_m / (double)growth->length_inf_m;
    return log(1.0 - share) / (double)growth->k_per_year;
}

/* Returns the age in days at which the fish has about 95 % of its greatest length. */
static double grown_days(const struct growth *growth)
{
    const double years = (double)growth->t0_year + 3.0 / (double)growth->k_per_year;
    return DAYS_PER_YEAR * fmin(fmax(years, 1.0), YEARS_MAX);
}

static void print_row(const struct growth *growth, double age_days, double t0_year, bool thesis)
{
    const double shifted_mm = von_bertalanffy_mm(growth, age_days, t0_year);
    const double ours_mm = 1e3 * (double)growth_length_m(growth, (float)age_days);
    printf("%.3f,%.5f,%.4f,%.4f,%.4f\n", age_days, age_days / DAYS_PER_YEAR,
           thesis ? shifted_mm : ours_mm,
           von_bertalanffy_mm(growth, age_days, (double)growth->t0_year), shifted_mm);
}

static enum exit_code morph_growth_run(int argc, const char *const *argv)
{
    static struct morph_options pick;
    uint32_t steps = 200;
    double to_days = 0.0;
    bool thesis = false;
    const struct morph_option options[] = {
        { .name = "--steps", .count = &steps, .min = 1, .max = 100000 },
        { .name = "--to-days", .number = &to_days, .min = 1, .max = YEARS_MAX * DAYS_PER_YEAR },
        { .name = "--thesis", .flag = &thesis },
    };
    const enum exit_code code = morph_options_read(&pick, name, MORPH_REQUIRES_FISH, options,
                                                   sizeof options / sizeof options[0], argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    const struct growth *growth = &pick.fish->card.growth;
    const double t0_year = shifted_t0_year(growth);
    if (to_days <= 0.0) {
        to_days = grown_days(growth);
    }
    puts("age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm");
    for (uint32_t i = 0; i <= steps; i++) {
        print_row(growth, to_days * (double)i / (double)steps, t0_year, thesis);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_growth = {
    .name = name,
    .words = "SPECIES|FILE [--to-days D] [--steps N] [--thesis]",
    .summary = "length by age as CSV: ours beside von Bertalanffy's curve, plain and shifted",
    .usage =
        "age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm\n\n"
        "  length_mm           measured lengths first, which fade into the plain curve\n"
        "  von_bertalanffy_mm  equation 3.3 of the 2005 thesis as fitted: giants hatch\n"
        "  shifted_mm          the same, its start moved so that it hatches with the true\n"
        "                      length (section 3.2): adults become too small\n"
        "  --to-days D         the last age, 1 to 14610; otherwise that of 95 % of the length\n"
        "  --steps N           rows but one, 1 to 100000; 200 otherwise\n"
        "  --thesis            length_mm is the thesis' own method: shifted_mm\n",
    .run = morph_growth_run,
};
