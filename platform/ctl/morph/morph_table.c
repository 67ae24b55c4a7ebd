/* morph_table.c -- the commands that print tables as CSV: `kingyoctl morph growth` and `kingyoctl
 * morph weights`.
 *
 * `kingyoctl morph growth` compares three formulas for the length of a
 * fish at an age.
 *
 * The growth curve of von Bertalanffy (2005 thesis, eq. 3.3) gives far too great lengths at
 * hatching for most species. The thesis shifts the start of the curve, which gives too small
 * lengths for adults. Kingyo uses measured lengths for young fish and blends into the curve of von
 * Bertalanffy. The command prints a table with all three lengths. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_options.h"

static const char growth_name[] = "growth";

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

struct growth_plan {
    struct morph_options pick;
    uint32_t steps;
    double to_days; /* Age in days at which the table ends. 0 selects the age at which the fish has
                       about 95 % of its greatest length. */
    bool thesis;
};

static const struct option growth_options[] = {
    { "to-days", "D", "last age in days; the default is the age of 95 % of the length",
      OPTION_DECIMAL, .offset = offsetof(struct growth_plan, to_days), 1,
      YEARS_MAX *DAYS_PER_YEAR },
    { "steps", "N", "number of rows minus one", OPTION_WHOLE,
      .offset = offsetof(struct growth_plan, steps), 1, 100000, .initial = "200" },
    { "thesis", NULL, "length_mm is the thesis' own method: shifted_mm", OPTION_FLAG,
      .offset = offsetof(struct growth_plan, thesis) },
};

static const struct option_table growth_table = { growth_options,
                                                  sizeof growth_options / sizeof growth_options[0],
                                                  &morph_options_table };

static enum exit_code morph_growth_run(int argc, const char *const *argv)
{
    static struct growth_plan plan;
    plan = (struct growth_plan){ .steps = 0 };
    const enum exit_code code =
        morph_options_read(&plan.pick, growth_name, MORPH_REQUIRES_FISH, &growth_table, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    CORE_ASSERT(plan.steps >= 1);
    const struct growth *growth = &plan.pick.fish->card.growth;
    /* `t0_year` is the start of the curve for which eq. 3.3 gives the true length at hatching (2005
     * thesis, section 3.2). */
    const double share = (double)growth->points[0].length_m / (double)growth->length_inf_m;
    const double t0_year = log(1.0 - share) / (double)growth->k_per_year;
    double to_days = plan.to_days;
    if (to_days <= 0.0) {
        /* At this age the fish has about 95 % of its greatest length. */
        const double years = (double)growth->t0_year + 3.0 / (double)growth->k_per_year;
        to_days = DAYS_PER_YEAR * fmin(fmax(years, 1.0), YEARS_MAX);
    }
    puts("age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm");
    for (uint32_t i = 0; i <= plan.steps; i++) {
        const double age_days = to_days * (double)i / (double)plan.steps;
        const double shifted_mm = von_bertalanffy_mm(growth, age_days, t0_year);
        const double ours_mm = 1e3 * (double)growth_length_m(growth, (float)age_days);
        printf("%.3f,%.5f,%.4f,%.4f,%.4f\n", age_days, age_days / DAYS_PER_YEAR,
               plan.thesis ? shifted_mm : ours_mm,
               von_bertalanffy_mm(growth, age_days, (double)growth->t0_year), shifted_mm);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_growth = {
    .name = growth_name,
    .options = &growth_table,
    .groups = MORPH_REQUIRES_FISH,
    .words = "SPECIES|FILE [--to-days D] [--steps N] [--thesis]",
    .summary = "length by age as CSV: ours beside von Bertalanffy's curve, plain and shifted",
    .usage = "age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm\n\n"
             "  length_mm           measured lengths first, which fade into the plain curve\n"
             "  von_bertalanffy_mm  equation 3.3 of the 2005 thesis as fitted: giants hatch\n"
             "  shifted_mm          the same, its start moved so that it hatches with the true\n"
             "                      length (section 3.2): adults become too small\n",
    .run = morph_growth_run,
};

/* ---- Weights of the deformation graph -------------------------------------------------------- */

/* `kingyoctl morph weights`, which prints the weights of the deformation graph as a table. */

static const char weights_name[] = "weights";

struct weights_plan {
    struct morph_options pick;
    uint32_t steps;
    const char *curve_name;
    bool drawn;
    uint32_t curve;
};

static const struct option weights_options[] = {
    { "steps", "N", "number of rows minus one", OPTION_WHOLE,
      .offset = offsetof(struct weights_plan, steps), 1, 100000, .initial = "100" },
    { "curve", "NAME", "curve of a part instead of the curve of the whole fish", OPTION_TEXT,
      .offset = offsetof(struct weights_plan, curve_name), .expects = "the name of a curve" },
    { "drawn", NULL,
      "print the weights of the drawn keys. They may be negative where the shapes are solved so "
      "that the fish passes through every drawing. The weights of the graph are never negative",
      OPTION_FLAG, .offset = offsetof(struct weights_plan, drawn) },
};

static const struct option_table weights_table = {
    weights_options, sizeof weights_options / sizeof weights_options[0], &morph_options_table
};

static enum exit_code morph_weights_run(int argc, const char *const *argv)
{
    static struct weights_plan plan;
    plan = (struct weights_plan){ .steps = 0 };
    enum exit_code code = morph_options_read(&plan.pick, weights_name, MORPH_REQUIRES_CURVES,
                                             &weights_table, argc, argv);
    if (code == EXIT_OK) {
        code = morph_curve_find(&plan.pick.fish->card, weights_name, plan.curve_name, &plan.curve);
    }
    if (code != EXIT_OK) {
        return code;
    }
    const struct species_card *card = &plan.pick.fish->card;
    CORE_ASSERT(plan.steps >= 1 && plan.curve < card->curve_count);
    float length_min_m, length_max_m;
    morph_options_lengths(card, &length_min_m, &length_max_m);
    fputs("progress,age_days,length_mm,scale", stdout);
    for (uint32_t key = 0; key < card->key_count; key++) {
        printf(",w_%s", card->key_names[key]);
    }
    putchar('\n');
    for (uint32_t i = 0; i <= plan.steps; i++) {
        const float progress = (float)i / (float)plan.steps;
        const float length_m = life_length_m(card, progress);
        float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
        if (plan.drawn) {
            morph_weights(&plan.pick.rig, progress, weights);
        } else {
            graph_weights(&plan.pick.rig.curves[plan.curve], card->key_count, progress,
                          weights[plan.curve]);
        }
        printf("%.6f,%.3f,%.4f,%.6f", (double)progress, (double)life_age_days(card, progress),
               1e3 * (double)length_m, (double)f_min(length_m / length_max_m, 1.0f));
        for (uint32_t key = 0; key < card->key_count; key++) {
            printf(",%.7f", (double)weights[plan.curve][key]);
        }
        putchar('\n');
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_weights = {
    .name = weights_name,
    .options = &weights_table,
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE [--template T] [--thesis] [--steps N] [--curve NAME] [--drawn]",
    .summary = "the deformation graph as CSV: progress,age_days,length_mm,scale,w_KEY...",
    .usage =
        "The first key stands at progress 0, the last at 1. scale is the length as a share of\n"
        "the greatest between them: [0, 1]. Each row's weights sum to 1.\n",
    .run = morph_weights_run,
};
