/* morph_table.c -- the commands that print tables as CSV: `kingyoctl morph growth`, `kingyoctl
 * morph weights` and `kingyoctl morph path`.
 *
 * `kingyoctl morph growth` compares three formulas for the length of a fish at an age. The growth
 * curve of von Bertalanffy (2005 thesis, eq. 3.3) gives far too great lengths at hatching for most
 * species. The thesis shifts the start of the curve, which gives too small lengths for adults.
 * Kingyo uses measured lengths for young fish and blends into the curve of von Bertalanffy. The
 * command prints a table with all three lengths. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_outline.h"
#include "platform/species/part.h"

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

static struct growth_plan {
    struct morph_options pick;
    uint32_t steps;
    double to_days; /* Age in days at which the table ends. 0 selects the age at which the fish has
                       about 95 % of its greatest length. */
    bool thesis;
} growth_plan;

static const struct option growth_options[] = {
    { "to-days", "D", "last age in days; the default is the age of 95 % of the length",
      OPTION_DECIMAL, .offset = offsetof(struct growth_plan, to_days), 1,
      YEARS_MAX *DAYS_PER_YEAR },
    { "steps", "N", "number of rows minus one", OPTION_WHOLE,
      .offset = offsetof(struct growth_plan, steps), 1, 100000, .initial = "200" },
    { "thesis", NULL, "print the shifted curve of the thesis as length_mm", OPTION_FLAG,
      .offset = offsetof(struct growth_plan, thesis) },
};

static enum exit_code print_growth(void)
{
    const struct growth_plan *plan = &growth_plan;
    CORE_ASSERT(plan->steps >= 1);
    const struct growth *growth = &plan->pick.fish->card.growth;
    /* `t0_year` is the start of the curve for which eq. 3.3 gives the true length at hatching (2005
     * thesis, section 3.2). */
    const double share = (double)growth->points[0].length_m / (double)growth->length_inf_m;
    const double t0_year = log(1.0 - share) / (double)growth->k_per_year;
    double to_days = plan->to_days;
    if (to_days <= 0.0) {
        /* Without an end in the options, the table ends at the age at which the fish has about 95 %
         * of its greatest length. */
        const double years = (double)growth->t0_year + 3.0 / (double)growth->k_per_year;
        to_days = DAYS_PER_YEAR * fmin(fmax(years, 1.0), YEARS_MAX);
    }
    puts("age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm");
    for (uint32_t i = 0; i <= plan->steps; i++) {
        const double age_days = to_days * (double)i / (double)plan->steps;
        const double shifted_mm = von_bertalanffy_mm(growth, age_days, t0_year);
        const double ours_mm = 1e3 * (double)growth_length_m(growth, (float)age_days);
        printf("%.3f,%.5f,%.4f,%.4f,%.4f\n", age_days, age_days / DAYS_PER_YEAR,
               plan->thesis ? shifted_mm : ours_mm,
               von_bertalanffy_mm(growth, age_days, (double)growth->t0_year), shifted_mm);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_growth = {
    .name = "growth",
    .options = MORPH_OPTION_TABLE(growth_options),
    .groups = MORPH_REQUIRES_FISH,
    .words = "SPECIES|FILE [--to-days D] [--steps N] [--thesis]",
    .summary =
        "prints the length by age as CSV, beside von Bertalanffy's curve and the shifted curve",
    .usage =
        "age_days,age_years,length_mm,von_bertalanffy_mm,shifted_mm\n\n"
        "  length_mm           measured lengths, then a blend into von Bertalanffy's curve\n"
        "  von_bertalanffy_mm  equation 3.3 of the 2005 thesis; too long at hatching\n"
        "  shifted_mm          the curve shifted to the true length at hatching (section 3.2);\n"
        "                      too short for adults\n",
    .plan = &growth_plan.pick,
    .run_fish = print_growth,
};

/* ---- `kingyoctl morph weights`: the weights of the deformation graph ------------------------- */

static const char weights_name[] = "weights";

static struct weights_plan {
    struct morph_options pick;
    uint32_t steps;
    const char *curve_name;
    bool drawn;
    uint32_t curve;
} weights_plan;

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

static enum exit_code print_weights(void)
{
    struct weights_plan *plan = &weights_plan;
    const enum exit_code code =
        morph_curve_find(&plan->pick.fish->card, weights_name, plan->curve_name, &plan->curve);
    if (code != EXIT_OK) {
        return code;
    }
    const struct species_card *card = &plan->pick.fish->card;
    CORE_ASSERT(plan->steps >= 1 && plan->curve < card->curve_count);
    float length_min_m, length_max_m;
    morph_options_lengths(card, &length_min_m, &length_max_m);
    fputs("progress,age_days,length_mm,scale", stdout);
    for (uint32_t key = 0; key < card->key_count; key++) {
        printf(",w_%s", card->key_names[key]);
    }
    putchar('\n');
    for (uint32_t i = 0; i <= plan->steps; i++) {
        const float progress = (float)i / (float)plan->steps;
        const float length_m = life_length_m(card, progress);
        float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
        if (plan->drawn) {
            morph_weights(&plan->pick.rig, progress, weights);
        } else {
            graph_weights(&plan->pick.rig.curves[plan->curve], card->key_count, progress,
                          weights[plan->curve]);
        }
        printf("%.6f,%.3f,%.4f,%.6f", (double)progress, (double)life_age_days(card, progress),
               1e3 * (double)length_m, (double)f_min(length_m / length_max_m, 1.0f));
        for (uint32_t key = 0; key < card->key_count; key++) {
            printf(",%.7f", (double)weights[plan->curve][key]);
        }
        putchar('\n');
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_weights = {
    .name = weights_name,
    .options = MORPH_OPTION_TABLE(weights_options),
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE [--template T] [--thesis] [--steps N] [--curve NAME] [--drawn]",
    .summary = "prints the deformation graph as CSV: progress,age_days,length_mm,scale,w_KEY...",
    .usage = "The first key is at progress 0, and the last key at progress 1. scale is the length\n"
             "divided by the greatest length. The weights of each row sum to 1.\n",
    .plan = &weights_plan.pick,
    .run_fish = print_weights,
};

/* ---- `kingyoctl morph path`: the path of a part ---------------------------------------------- */

/* `kingyoctl morph path` compares the path of a part with the straight line of ordinary morphing
 * (2005 thesis, figures 3.2 to 3.5). */

static const char path_name[] = "path";

static struct morph_path_plan path_plan = { .view = MORPH_OUTLINE_COUNT };

static enum exit_code find_vertex(void)
{
    const struct species_mesh *mesh = &path_plan.pick.fish->lod[0];
    const enum species_part part = path_plan.part ? part_of_vertex(path_plan.part) : PART_COUNT;
    if (!path_plan.part) {
        return morph_usage(path_name, "--part is missing; --help lists the parts");
    }
    if (part == PART_COUNT) {
        return morph_usage(path_name, "--part: '%.40s' is not a part; --help lists the parts",
                           path_plan.part);
    }
    path_plan.vertex = part_vertex_range(mesh, part, path_plan.side == 0 ? SIDE_RIGHT : SIDE_LEFT);
    if (path_plan.vertex == mesh->vertex_count) {
        return morph_usage(path_name, "--part: %s has no %s", path_plan.pick.fish->card.id,
                           path_plan.part);
    }
    return EXIT_OK;
}

static struct chord chord_of(const struct species *fish, const struct morph_rig *rig,
                             uint32_t vertex)
{
    return (struct chord){ part_of_place(fish, rig, vertex, 0.0f),
                           part_of_place(fish, rig, vertex, 1.0f) };
}

#define AT(member) .offset = offsetof(struct morph_path_plan, member)

static const char *const side_names[] = { "right", "left", NULL };
static const char *const view_names[] = { "side", "front", "top", NULL };

static const struct option path_options[] = {
    { "part", "PART",
      "body (its back at the deepest point), eye (the pupil), tail (the tip of the upper lobe), or "
      "the root of the leading ray of dorsal, anal, pectoral, pelvic, dorsal2, finlets_upper or "
      "finlets_lower",
      OPTION_TEXT, AT(part), .expects = "the name of a part" },
    { "side", "right|left", "side of a paired part", OPTION_CHOICE, AT(side), .choices = side_names,
      .initial = "right" },
    { "steps", "N", "number of rows minus one", OPTION_WHOLE, AT(steps), 1, 100000,
      .initial = "100" },
    { "svg", "FILE",
      "write a picture instead of the table: the outlines of the keys with the path across them, "
      "and the straight line dashed",
      OPTION_TEXT, AT(svg) },
    { "view", "VIEW", "view of the picture; the default shows the longest path", OPTION_CHOICE,
      AT(view), .choices = view_names },
};

static enum exit_code print_path(void)
{
    const enum exit_code code = find_vertex();
    if (code != EXIT_OK) {
        return code;
    }
    path_plan.chord = chord_of(path_plan.pick.fish, &path_plan.pick.rig, path_plan.vertex);
    if (path_plan.view != MORPH_OUTLINE_COUNT && !path_plan.svg) {
        return morph_usage(path_name, "--view needs --svg");
    }
    if (path_plan.svg) {
        return morph_path_picture(&path_plan, path_name);
    }
    struct morph_rig rig;
    const struct species *ordinary = morph_options_ordinary(&path_plan.pick, &rig);
    const struct chord chord = chord_of(ordinary, &rig, path_plan.vertex);
    puts("progress,age_days,length_mm,x,y,z,from_chord,ordinary_x,ordinary_y,ordinary_z,"
         "ordinary_from_chord");
    for (uint32_t i = 0; i <= path_plan.steps; i++) {
        const float progress = (float)i / (float)path_plan.steps;
        const struct species_card *card = &path_plan.pick.fish->card;
        const vec3 p =
            part_of_place(path_plan.pick.fish, &path_plan.pick.rig, path_plan.vertex, progress);
        const vec3 o = part_of_place(ordinary, &rig, path_plan.vertex, progress);
        printf("%.6f,%.3f,%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", (double)progress,
               (double)life_age_days(card, progress), 1e3 * (double)life_length_m(card, progress),
               (double)p.x, (double)p.y, (double)p.z,
               (double)v3_from_line(p, path_plan.chord.from, path_plan.chord.to), (double)o.x,
               (double)o.y, (double)o.z, (double)v3_from_line(o, chord.from, chord.to));
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_path = {
    .name = path_name,
    .options = MORPH_OPTION_TABLE(path_options),
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE --part PART [--side right|left] [--template T] [--thesis] "
             "[--steps N] [--svg FILE]",
    .summary = "prints or draws the path of a part while the fish grows, beside ordinary morphing",
    .usage =
        "progress,age_days,length_mm,x,y,z,from_chord,ordinary_x,ordinary_y,ordinary_z,\n"
        "ordinary_from_chord\n\n"
        "Positions and distances are in body lengths: x to the right of the fish,\n"
        "y up, z backward, and the snout at z = -0.5. from_chord is the distance from the\n"
        "straight line between the first and the last position. Ordinary morphing stays on this\n"
        "line.\n",
    .plan = &path_plan.pick,
    .run_fish = print_path,
};
