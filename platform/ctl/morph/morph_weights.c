/* morph_weights.c -- `kingyoctl morph weights`, which prints the weights of the deformation graph
 * as a table. */
#include <stdio.h>

#include "platform/ctl/morph/morph_curve.h"
#include "platform/ctl/morph/morph_options.h"

static const char name[] = "weights";

struct weights_plan {
    struct morph_options pick;
    uint32_t steps;
    const char *curve_name;
    bool drawn;
    uint32_t curve;
};

static void print_row(const struct weights_plan *plan, float progress, float length_max_m)
{
    const struct species_card *card = &plan->pick.fish->card;
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

static enum exit_code morph_weights_run(int argc, const char *const *argv)
{
    static struct weights_plan plan;
    plan = (struct weights_plan){ .steps = 100 };
    const struct morph_option options[] = {
        { .name = "--steps", .count = &plan.steps, .min = 1, .max = 100000 },
        { .name = "--curve", .text = &plan.curve_name },
        { .name = "--drawn", .flag = &plan.drawn },
    };
    enum exit_code code = morph_options_read(&plan.pick, name, MORPH_REQUIRES_CURVES, options,
                                             sizeof options / sizeof options[0], argc, argv);
    if (code == EXIT_OK) {
        code = morph_curve_find(&plan.pick.fish->card, name, plan.curve_name, &plan.curve);
    }
    if (code != EXIT_OK) {
        return code;
    }
    const struct species_card *card = &plan.pick.fish->card;
    float length_min_m, length_max_m;
    morph_options_lengths(card, &length_min_m, &length_max_m);
    fputs("progress,age_days,length_mm,scale", stdout);
    for (uint32_t key = 0; key < card->key_count; key++) {
        printf(",w_%s", card->key_names[key]);
    }
    putchar('\n');
    for (uint32_t i = 0; i <= plan.steps; i++) {
        print_row(&plan, (float)i / (float)plan.steps, length_max_m);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_weights = {
    .name = name,
    .words = "SPECIES|FILE [--template T] [--thesis] [--steps N] [--curve NAME] [--drawn]",
    .summary = "the deformation graph as CSV: progress,age_days,length_mm,scale,w_KEY...",
    .usage =
        "  --steps N     rows but one, 1 to 100000; 100 otherwise\n"
        "  --curve NAME  a part's own curve instead of the whole fish's\n"
        "  --drawn       the weights of the drawn keys: where shapes are solved so that the\n"
        "                fish passes through every drawing, these may be negative; the graph's\n"
        "                never are\n"
        "\nThe first key stands at progress 0, the last at 1. scale is the length as a share of\n"
        "the greatest between them: [0, 1]. Each row's weights sum to 1.\n",
    .run = morph_weights_run,
};
