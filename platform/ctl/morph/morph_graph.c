/* morph_graph.c -- `kingyoctl morph graph`, which draws the deformation graph of a species (2005
 * thesis, figures 3.7 to 3.9).
 *
 * The graph has one curve for the weight of each key and a purple curve for the size. The shapes of
 * the keys are drawn above the graph, and the ages below. */
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_graph.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/ctl/morph/morph_outline.h"

static const char name[] = "graph";

#define SAMPLES 400u
#define KEY_WIDTH 190.0 /* Maximum width of the outline of a key, in pixels. */
#define KEY_HEIGHT 124.0
/* Number of samples in the search for peaks and troughs of the length. If the length changes by
 * 20 % within 1/20 of a life, neighbouring samples differ by 0.02 %. */
#define TURN_SAMPLES 20000u
/* Minimum relative change of the length after a peak or a trough. A smaller peak or trough is not
 * labelled. */
#define TURN_LEAST 0.01

struct graph_plan {
    struct morph_options pick;
    const char *path, *curve_name;
    uint32_t curve;
    struct morph_rig keys; /* Rig whose weights select exactly one key at the progress of each
                              key. */
    struct morph_graph_lengths lengths;
    struct svg svg;
};

static void draw_title(struct graph_plan *plan)
{
    char title[SPECIES_NAME_SIZE];
    const struct morph_options *pick = &plan->pick;
    const struct graph *graph = &pick->rig.curves[plan->curve];
    const enum graph_template template_id =
        pick->template_id != TEMPLATE_OWN || !pick->thesis
            ? pick->template_id
            : (enum graph_template)pick->drawn->card.thesis_template;
    morph_outline_title(title, pick->fish->card.id);
    svg_text(&plan->svg, MORPH_GRAPH_LEFT, 50.0, 28.0, "start", SVG_INK, "%s", title);
    svg_text(&plan->svg, MORPH_GRAPH_LEFT, 78.0, 15.0, "start", SVG_GREY, "%s%s curve%s%s%s%s",
             pick->thesis ? "chapter 4 of the 2005 thesis: " : "", morph_template_name(template_id),
             plan->curve > 0 ? " of the part " : "",
             plan->curve > 0 ? pick->fish->card.curve_names[plan->curve] : "",
             graph->line == GRAPH_SMOOTH ? ", smooth" : ", straight from knot to knot",
             graph->solved ? ", its shapes solved so that each drawing is passed through" : "");
}

/* ---- Keys and curves ------------------------------------------------------------------------- */

/* Draws the shape of a key with its name, age and length, and a line down to the progress of the
 * key. */
static void draw_key(struct graph_plan *plan, uint32_t key)
{
    CORE_ASSERT(key < plan->pick.fish->card.key_count);
    const struct species_card *card = &plan->pick.fish->card;
    const double spacing = (MORPH_GRAPH_RIGHT - MORPH_GRAPH_LEFT) / (card->key_count - 1.0);
    const double x = morph_graph_x(key / (card->key_count - 1.0));
    char age[MORPH_GRAPH_WORDS], length[MORPH_GRAPH_WORDS], words[SPECIES_NAME_SIZE];
    /* The shape is as large as possible and centred at `x`. */
    struct morph_outline outline = {
        .species = plan->pick.fish,
        .rig = &plan->keys,
        .view = morph_outline_view_of(card),
        .progress = (float)key / (float)(card->key_count - 1u),
        .length_px = 1.0,
        .colour = morph_outline_key_colour(card, key),
        .opacity = 0.75,
    };
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    morph_outline_measure(&outline, low, high);
    outline.length_px =
        fmin(fmin(0.85 * spacing, KEY_WIDTH) / (high[0] - low[0]), KEY_HEIGHT / (high[1] - low[1]));
    outline.x = x - 0.5 * (low[0] + high[0]) * outline.length_px;
    outline.y = 156.0 - 0.5 * (low[1] + high[1]) * outline.length_px;
    morph_outline_draw(&plan->svg, &outline);
    morph_graph_print_age(age, (double)card->key_age_days[key]);
    morph_graph_print_length(length, 1e3 * (double)card->key_length_m[key], 4);
    morph_outline_words(words, card->key_names[key]);
    svg_text(&plan->svg, x, MORPH_GRAPH_TOP - 38.0, 16.0, "middle",
             morph_outline_key_colour(card, key), "%s", words);
    svg_text(&plan->svg, x, MORPH_GRAPH_TOP - 18.0, 13.0, "middle", SVG_GREY, "%s, %s", age,
             length);
    svg_line(&plan->svg, x, MORPH_GRAPH_TOP - 10.0, x, MORPH_GRAPH_BOTTOM, SVG_GREY, 1.0, "3 4");
}

static void draw_curve(struct graph_plan *plan, uint32_t key)
{
    CORE_ASSERT(key < plan->pick.fish->card.key_count);
    CORE_ASSERT(plan->curve < plan->pick.rig.curve_count);
    const struct species_card *card = &plan->pick.fish->card;
    const struct graph *graph = &plan->pick.rig.curves[plan->curve];
    svg_begin_line(&plan->svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        float weights[MORPH_KEY_MAX];
        const float progress = (float)i / (float)SAMPLES;
        graph_weights(graph, card->key_count, progress, weights);
        svg_point(&plan->svg, morph_graph_x((double)progress), morph_graph_y((double)weights[key]));
    }
    svg_end_line(&plan->svg, morph_outline_key_colour(card, key), 3.5, NULL);
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        svg_dot(&plan->svg, morph_graph_x((double)graph->knots[i].progress),
                morph_graph_y((double)graph->knots[i].weight[key]), 4.5, SVG_PAPER,
                morph_outline_key_colour(card, key));
    }
}

/* Labels the peaks and troughs of the length. For example, a conger larva is longest before its
 * metamorphosis to an eel. */
static void draw_turns(struct graph_plan *plan)
{
    const struct species_card *card = &plan->pick.fish->card;
    double last = 1e3 * (double)life_length_m(card, 0.0f), turned = last, at = 0.0;
    /* Direction of the change: 1 while the length increases, -1 while it decreases, 0 before the
     * first change. */
    int way = 0;
    for (uint32_t i = 1; i <= TURN_SAMPLES; i++) {
        const double progress = (double)i / (double)TURN_SAMPLES;
        const double mm = 1e3 * (double)life_length_m(card, (float)progress);
        if (way == 0 || (mm - turned) * way >= 0.0) { /* The length is the greatest so far while the
                                                         fish grows, or the least so far while the
                                                         fish shrinks. */
            way = way != 0 ? way : mm > last ? 1 : mm < last ? -1 : 0;
            turned = mm;
            at = progress;
        } else if (fabs(mm - turned) > TURN_LEAST * turned) {
            /* The label of a peak is above the curve, and the label of a trough below. */
            const double x = morph_graph_x(at), y = morph_graph_length_y(&plan->lengths, turned);
            svg_dot(&plan->svg, x, y, 4.5, MORPH_SCALE_COLOUR, SVG_PAPER);
            svg_text(&plan->svg, x, y + (way > 0 ? -12.0 : 24.0), 15.0, "middle",
                     MORPH_SCALE_COLOUR, "%.1f mm", turned);
            way = -way;
            turned = mm;
            at = progress;
        }
        last = mm;
    }
}

/* Writes two notes below the graph: the meaning of the lines, and the names of the curves that the
 * graph does not show. */
static void draw_foot(struct graph_plan *plan)
{
    CORE_ASSERT(plan->pick.fish->card.curve_count <= MORPH_CURVE_MAX);
    const struct species_card *card = &plan->pick.fish->card;
    const double y = MORPH_GRAPH_HEIGHT - 28.0;
    char list[MORPH_CURVE_MAX * (SPECIES_NAME_SIZE + 2u)] = "";
    for (uint32_t i = 0; i < card->curve_count; i++) {
        const size_t used = strlen(list);
        if (i != plan->curve) {
            snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "",
                     card->curve_names[i]);
        }
    }
    svg_text(&plan->svg, MORPH_GRAPH_RIGHT, y, 13.0, "end", SVG_GREY,
             "Solid: what each key counts for, in its colour. Dashed: the fish's length%s.",
             plan->lengths.is_log ? ", by factors" : "");
    if (list[0]) {
        svg_text(&plan->svg, MORPH_GRAPH_LEFT, y, 13.0, "start", SVG_GREY, "Other curves: %s.",
                 list);
    }
}

static const struct option options[] = {
    { "svg", "FILE", "file of the picture", OPTION_TEXT,
      .offset = offsetof(struct graph_plan, path) },
    { "curve", "NAME", "curve of a part instead of the curve of the whole fish", OPTION_TEXT,
      .offset = offsetof(struct graph_plan, curve_name), .expects = "the name of a curve" },
};

static const struct option_table table = { options, sizeof options / sizeof options[0],
                                           &morph_options_table };

static enum exit_code morph_graph_run(int argc, const char *const *argv)
{
    static struct graph_plan plan;
    plan = (struct graph_plan){ 0 };
    enum exit_code code =
        morph_options_read(&plan.pick, name, MORPH_REQUIRES_CURVES, &table, argc, argv);
    if (code == EXIT_OK) {
        code = plan.path
                   ? morph_curve_find(&plan.pick.fish->card, name, plan.curve_name, &plan.curve)
                   : morph_usage(name, "--svg FILE is missing");
    }
    if (code != EXIT_OK) {
        return code;
    }
    if (!svg_open(&plan.svg, plan.path, MORPH_GRAPH_WIDTH, MORPH_GRAPH_HEIGHT,
                  "Deformation graph")) {
        return morph_fail(EXIT_IO, name, "%.200s: %s", plan.path, strerror(errno));
    }
    const struct species_card *card = &plan.pick.fish->card;
    plan.lengths = morph_graph_lengths(card, plan.pick.thesis);
    morph_rig_init(&plan.keys, card, TEMPLATE_PAIRWISE);
    draw_title(&plan);
    morph_graph_axes(&plan.svg, card, &plan.lengths);
    for (uint32_t key = 0; key < card->key_count; key++) {
        draw_key(&plan, key);
    }
    svg_begin_line(&plan.svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        const float progress = (float)i / (float)SAMPLES;
        svg_point(&plan.svg, morph_graph_x((double)progress),
                  morph_graph_length_y(&plan.lengths, 1e3 * (double)life_length_m(card, progress)));
    }
    svg_end_line(&plan.svg, MORPH_SCALE_COLOUR, 2.5, "9 5");
    for (uint32_t key = 0; key < card->key_count; key++) {
        draw_curve(&plan, key);
    }
    if (!plan.pick.thesis) {
        draw_turns(&plan);
    }
    draw_foot(&plan);
    if (!svg_close(&plan.svg)) {
        return morph_fail(EXIT_IO, name, "%.200s: %s", plan.path, strerror(errno));
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_graph = {
    .name = name,
    .options = &table,
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE --svg FILE [--template T] [--thesis] [--curve NAME]",
    .summary = "the deformation graph as a picture: a curve for each key, the size, the ages",
    .usage =
        "Three keys are red, green and blue as in the 2005 thesis; of more, those between have\n"
        "the colours between, as in the growth lab: red, orange, green, teal, blue for five. The\n"
        "size is purple, read off on the right: by factors where it spans more than ten, with\n"
        "the lengths where it turns round. With --thesis its axis is even, as in the thesis.\n",
    .run = morph_graph_run,
};
