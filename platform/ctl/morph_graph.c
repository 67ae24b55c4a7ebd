/* morph_graph.c -- `kingyoctl morph graph`: the deformation graph as a picture (2005 thesis,
 * figures 3.7 to 3.9): a curve for each key, purple the size, the key shapes above, ages below. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/morph_curve.h"
#include "platform/ctl/morph_outline.h"
#include "platform/ctl/morph_pick.h"

static const char name[] = "graph";

#define WIDTH 1280.0
#define HEIGHT 760.0
#define LEFT 110.0
#define RIGHT 1150.0
#define TOP 270.0
#define BOTTOM 600.0
#define AGES 652.0
#define SAMPLES 400u
#define YEAR_DAYS 365.25
#define AGE_MAX 16u     /* Ages that are marked ... */
#define AGE_ROOM 78.0   /* ... and how far apart, for their words. */
#define KEY_WIDTH 190.0 /* How large a key's outline may be. */
#define KEY_HEIGHT 124.0

struct graph_plan {
    struct morph_pick pick;
    const char *path, *curve_name;
    uint32_t curve;
    struct morph_rig keys; /* That reaches every key whole. */
    struct svg svg;
};

static double x_at(double progress)
{
    return LEFT + (RIGHT - LEFT) * progress;
}

static double y_at(double share)
{
    return BOTTOM + (TOP - BOTTOM) * share;
}

/* ---- Words ---------------------------------------------------------------------------------- */

static void print_age(char out[24], double days)
{
    if (days < 2.0 * YEAR_DAYS - 0.5) {
        snprintf(out, 24, "%.0f d", days);
    } else {
        snprintf(out, 24, "%.3g y", days / YEAR_DAYS);
    }
}

/* Keys are drawn at measured lengths: 125.5 mm; between them three digits are enough. */
static void print_length(char out[24], double mm, int digits)
{
    snprintf(out, 24, "%.*g %s", digits, mm < 1000.0 ? mm : 1e-3 * mm, mm < 1000.0 ? "mm" : "m");
}

static void draw_title(struct graph_plan *plan)
{
    const struct morph_pick *pick = &plan->pick;
    const struct graph *graph = &pick->rig.curves[plan->curve];
    const enum graph_template template =
        pick->template != TEMPLATE_OWN || !pick->thesis
            ? pick->template
            : (enum graph_template)pick->drawn->card.thesis_template;
    svg_text(&plan->svg, LEFT, 50.0, 28.0, "start", SVG_INK, "%c%s", pick->fish->card.id[0] - 32,
             pick->fish->card.id + 1);
    svg_text(&plan->svg, LEFT, 78.0, 15.0, "start", SVG_GREY, "%s%s curve%s%s%s%s",
             pick->thesis ? "chapter 4 of the 2005 thesis: " : "", morph_template_name(template),
             plan->curve > 0 ? " of the part " : "",
             plan->curve > 0 ? pick->fish->card.curve_names[plan->curve] : "",
             graph->line == GRAPH_SMOOTH ? ", smooth" : ", straight from knot to knot",
             graph->solved ? ", its shapes solved so that each drawing is passed through" : "");
}

/* ---- Axes ----------------------------------------------------------------------------------- */

static void draw_shares(struct svg *svg)
{
    for (int percent = 0; percent <= 100; percent += 25) {
        const double y = y_at(0.01 * percent);
        svg_line(svg, LEFT, y, RIGHT, y, SVG_FAINT, 1.0, NULL);
        svg_text(svg, LEFT - 12.0, y + 5.0, 14.0, "end", SVG_INK, "%d %%", percent);
    }
    svg_put(svg, "<g transform=\"rotate(-90 40 %.0f)\">\n", y_at(0.5));
    svg_text(svg, 40.0, y_at(0.5), 15.0, "middle", SVG_INK, "share of each key");
    svg_put(svg, "</g>\n");
}

/* 1, 2 or 5 times a power of ten: four to ten of it fit in `range`. */
static double round_step(double range)
{
    const double power = pow(10.0, floor(log10(range / 4.0)));
    const double part = range / 4.0 / power;
    return power * (part >= 5.0 ? 5.0 : part >= 2.0 ? 2.0 : 1.0);
}

static void draw_lengths(struct svg *svg, double max_mm)
{
    const double step = round_step(max_mm);
    for (double mm = 0.0; mm <= max_mm * 1.0001; mm += step) {
        char text[24];
        print_length(text, mm, 4);
        svg_line(svg, RIGHT, y_at(mm / max_mm), RIGHT + 6.0, y_at(mm / max_mm), MORPH_SCALE_COLOUR,
                 1.5, NULL);
        svg_text(svg, RIGHT + 12.0, y_at(mm / max_mm) + 5.0, 14.0, "start", MORPH_SCALE_COLOUR,
                 "%s", text);
    }
    svg_line(svg, RIGHT, TOP, RIGHT, BOTTOM, MORPH_SCALE_COLOUR, 1.5, NULL);
}

static void draw_progress(struct svg *svg)
{
    svg_line(svg, LEFT, BOTTOM, RIGHT, BOTTOM, SVG_INK, 1.2, NULL);
    for (int i = 0; i <= 10; i++) {
        const double x = x_at(0.1 * i);
        svg_line(svg, x, BOTTOM, x, BOTTOM + 6.0, SVG_INK, 1.2, NULL);
        svg_text(svg, x, BOTTOM + 24.0, 14.0, "middle", SVG_INK, "%g", 0.1 * i);
    }
    svg_text(svg, LEFT - 24.0, BOTTOM + 24.0, 14.0, "end", SVG_INK, "progress");
}

/* The ages on the axis: which are marked, and where. */
struct age_axis {
    const struct species_card *card;
    double youngest, oldest;
    double x[AGE_MAX];
    uint32_t count;
};

static bool has_room(const struct age_axis *axis, double x)
{
    for (uint32_t i = 0; i < axis->count; i++) {
        if (fabs(axis->x[i] - x) < AGE_ROOM) {
            return false;
        }
    }
    return axis->count < AGE_MAX;
}

static void draw_age(struct svg *svg, struct age_axis *axis, double days)
{
    const float progress = life_progress(axis->card, (float)days);
    const double x = x_at((double)progress);
    char age[24], length[24];
    if (!has_room(axis, x)) {
        return;
    }
    axis->x[axis->count++] = x;
    print_age(age, days);
    print_length(length, 1e3 * (double)life_length_m(axis->card, progress), 3);
    svg_line(svg, x, AGES, x, AGES + 6.0, SVG_INK, 1.2, NULL);
    svg_text(svg, x, AGES + 24.0, 14.0, "middle", SVG_INK, "%s", age);
    svg_text(svg, x, AGES + 44.0, 13.0, "middle", MORPH_SCALE_COLOUR, "%s", length);
}

/* A tick at round ages with the length there: the roundest first, then what has room between. Young
 * fish are told apart by days, old ones by years. */
static void draw_ages(struct svg *svg, const struct species_card *card)
{
    static const double steps_days[] = { 10.0 * YEAR_DAYS, 5.0 * YEAR_DAYS, 2.0 * YEAR_DAYS,
                                         YEAR_DAYS, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0 };
    struct age_axis axis = { .card = card,
                             .youngest = ceil((double)life_age_days(card, 0.0f) - 0.01),
                             .oldest = (double)life_age_days(card, 1.0f) + 0.01 };
    svg_line(svg, LEFT, AGES, RIGHT, AGES, SVG_INK, 1.2, NULL);
    for (size_t i = 0; i < sizeof steps_days / sizeof steps_days[0]; i++) {
        const double step = steps_days[i], last = fmin(axis.oldest, 40.0 * step);
        const double first = step < YEAR_DAYS ? 0.0 : 2.0 * YEAR_DAYS;
        for (double days = 0.0; days <= last; days += step) {
            if (days >= fmax(axis.youngest, first)) {
                draw_age(svg, &axis, days);
            }
        }
    }
    svg_text(svg, LEFT - 36.0, AGES + 24.0, 14.0, "end", SVG_INK, "age");
    svg_text(svg, LEFT - 36.0, AGES + 44.0, 13.0, "end", MORPH_SCALE_COLOUR, "length");
}

/* ---- Keys and curves ------------------------------------------------------------------------ */

/* The key's own shape, as large as fits, its middle above its progress. */
static void draw_shape(struct graph_plan *plan, uint32_t key, double x, double width_max)
{
    const struct species_card *card = &plan->pick.fish->card;
    struct outline outline = {
        .species = plan->pick.fish, .rig = &plan->keys, .view = outline_view_of(card),
        .progress = (float)key / (float)(card->key_count - 1u), .length_px = 1.0,
        .colour = outline_key_colour(key), .opacity = 0.75,
    };
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    outline_measure(&outline, low, high);
    outline.length_px = fmin(width_max / (high[0] - low[0]), KEY_HEIGHT / (high[1] - low[1]));
    outline.x = x - 0.5 * (low[0] + high[0]) * outline.length_px;
    outline.y = 156.0 - 0.5 * (low[1] + high[1]) * outline.length_px;
    outline_draw(&plan->svg, &outline);
}

/* Its shape, its name, age and length, and a line down to its progress. */
static void draw_key(struct graph_plan *plan, uint32_t key)
{
    const struct species_card *card = &plan->pick.fish->card;
    const double spacing = (RIGHT - LEFT) / (card->key_count - 1.0);
    const double x = x_at(key / (card->key_count - 1.0));
    char age[24], length[24];
    draw_shape(plan, key, x, fmin(0.85 * spacing, KEY_WIDTH));
    print_age(age, (double)card->key_age_days[key]);
    print_length(length, 1e3 * (double)card->key_length_m[key], 4);
    svg_text(&plan->svg, x, TOP - 38.0, 16.0, "middle", outline_key_colour(key), "%s",
             card->key_names[key]);
    svg_text(&plan->svg, x, TOP - 18.0, 13.0, "middle", SVG_GREY, "%s, %s", age, length);
    svg_line(&plan->svg, x, TOP - 10.0, x, BOTTOM, SVG_GREY, 1.0, "3 4");
}

static void draw_curve(struct graph_plan *plan, uint32_t key)
{
    const struct graph *graph = &plan->pick.rig.curves[plan->curve];
    svg_begin_line(&plan->svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        float weights[MORPH_KEY_MAX];
        const float progress = (float)i / (float)SAMPLES;
        graph_weights(graph, plan->pick.fish->card.key_count, progress, weights);
        svg_point(&plan->svg, x_at((double)progress), y_at((double)weights[key]));
    }
    svg_end_line(&plan->svg, outline_key_colour(key), 3.5, NULL);
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        svg_dot(&plan->svg, x_at((double)graph->knots[i].progress),
                y_at((double)graph->knots[i].weight[key]), 4.5, SVG_PAPER,
                outline_key_colour(key));
    }
}

static void draw_scale(struct graph_plan *plan, double max_m)
{
    const struct species_card *card = &plan->pick.fish->card;
    svg_begin_line(&plan->svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        const float progress = (float)i / (float)SAMPLES;
        svg_point(&plan->svg, x_at((double)progress),
                  y_at((double)life_length_m(card, progress) / max_m));
    }
    svg_end_line(&plan->svg, MORPH_SCALE_COLOUR, 2.5, "9 5");
}

static void draw(struct graph_plan *plan)
{
    const struct species_card *card = &plan->pick.fish->card;
    const double max_m = (double)morph_pick_length_max_m(card);
    morph_rig_init(&plan->keys, card, TEMPLATE_PAIRWISE);
    draw_title(plan);
    draw_shares(&plan->svg);
    for (uint32_t key = 0; key < card->key_count; key++) {
        draw_key(plan, key);
    }
    draw_progress(&plan->svg);
    draw_ages(&plan->svg, card);
    draw_lengths(&plan->svg, 1e3 * max_m);
    draw_scale(plan, max_m);
    for (uint32_t key = 0; key < card->key_count; key++) {
        draw_curve(plan, key);
    }
    svg_text(&plan->svg, RIGHT, HEIGHT - 28.0, 13.0, "end", SVG_GREY,
             "Solid: what each key counts for, in its colour. Dashed: the fish's length.");
}

static enum exit_code run(int argc, const char *const *argv)
{
    static struct graph_plan plan;
    plan = (struct graph_plan){ 0 };
    const struct morph_option options[] = {
        { .name = "--svg", .text = &plan.path },
        { .name = "--curve", .text = &plan.curve_name },
    };
    enum exit_code code = morph_pick_read(&plan.pick, name, MORPH_ASKS_CURVES, options,
                                          sizeof options / sizeof options[0], argc, argv);
    if (code == EXIT_OK) {
        code = plan.path ? morph_curve_find(&plan.pick.fish->card, name, plan.curve_name,
                                            &plan.curve)
                         : morph_usage(name, "--svg FILE is missing");
    }
    if (code != EXIT_OK) {
        return code;
    }
    if (!svg_open(&plan.svg, plan.path, WIDTH, HEIGHT, "Deformation graph")) {
        return morph_fail(EXIT_IO, name, "%.200s: %s", plan.path, strerror(errno));
    }
    draw(&plan);
    if (!svg_close(&plan.svg)) {
        return morph_fail(EXIT_IO, name, "%.200s: %s", plan.path, strerror(errno));
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_graph = {
    .name = name,
    .words = "SPECIES|FILE --svg FILE [--template T] [--thesis] [--curve NAME]",
    .summary = "the deformation graph as a picture: a curve for each key, the size, the ages",
    .usage =
        "  --svg FILE    where the picture goes\n"
        "  --curve NAME  a part's own curve instead of the whole fish's\n"
        "\nKeys are red, green and blue as in the 2005 thesis, further ones orange, teal, pink,\n"
        "brown and grey; the size is purple, read off on the right.\n",
    .run = run,
};
