/* morph_graph.c -- `kingyoctl morph graph`, which draws the deformation graph of a species (2005
 * thesis, figures 3.7 to 3.9).
 *
 * The graph has one curve for the weight of each key and a purple curve for the size. The shapes of
 * the keys are drawn above the graph, and the ages below. */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/caption.h"
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

#define WIDTH 1280.0
#define HEIGHT 760.0
/* Edges of the graph in the picture, in pixels. */
#define LEFT 110.0
#define RIGHT 1150.0
#define TOP 270.0
#define BOTTOM 600.0
#define WORDS 24u
#define AGES 652.0 /* Distance of the row of ages from the top of the picture, in pixels. */
#define YEAR_DAYS 365.25
/* The lower end of a logarithmic length axis is the least length divided by this ratio. The margin
 * leaves room for the label of a trough. */
#define FOOT 1.4
/* The length axis is logarithmic if the greatest length is more than this number times the least
 * length. */
#define LOG_FROM 10.0f
#define AGE_MAX 16u   /* Maximum number of ages with a label. */
#define AGE_ROOM 78.0 /* Minimum distance between two labelled ages in pixels. */

static struct graph_plan {
    struct morph_options pick;
    const char *path, *curve_name;
    uint32_t curve;
    /* Weights of the keys over the life in which exactly one key has the weight 1 at the progress
     * of that key. */
    struct morph_rig keys;
    double low_mm, high_mm; /* Range of the length axis at the right of the picture. */
    bool is_log; /* True for a logarithmic length axis. False for a linear axis that starts at 0. */
    struct svg svg;
} plan;

static struct svg *const svg = &plan.svg;

static double graph_x(double progress)
{
    return LEFT + (RIGHT - LEFT) * progress;
}

static double graph_y(double share)
{
    return BOTTOM + (TOP - BOTTOM) * share;
}

/* Writes an age in days, for example "545 d". An age of two years or more is written in years, for
 * example "4.01 y". */
static void print_age(char out[WORDS], double days)
{
    if (days < 2.0 * YEAR_DAYS - 0.5) {
        snprintf(out, WORDS, "%.0f d", days);
    } else {
        snprintf(out, WORDS, "%.3g y", days / YEAR_DAYS);
    }
}

/* Writes a length in mm with `digits` significant digits. Lengths at keys are measured with four
 * digits, for example 125.5 mm. Lengths between keys need only three digits. */
static void print_length(char out[WORDS], double mm, int digits)
{
    const bool small = mm < 1000.0;
    snprintf(out, WORDS, "%.*g %s", digits, small ? mm : 1e-3 * mm, small ? "mm" : "m");
}

/* Returns the greatest value that is 1, 2 or 5 times a power of ten and at most `mm`. */
static double round_below(double mm)
{
    const double power = pow(10.0, floor(log10(mm) + 1e-9)), part = mm / power + 1e-6;
    return power * (part >= 5.0 ? 5.0 : part >= 2.0 ? 2.0 : 1.0);
}

/* Converts a length in mm to pixels from the top of the picture. */
static double length_y(double mm)
{
    return graph_y(plan.is_log ? log(mm / plan.low_mm) / log(plan.high_mm / plan.low_mm)
                               : mm / plan.high_mm);
}

static void draw_length(double mm)
{
    const double y = length_y(mm);
    char text[WORDS];
    print_length(text, mm, 4);
    svg_line(svg, RIGHT, y, RIGHT + 6.0, y, MORPH_SCALE_COLOUR, 1.5, NULL);
    svg_text(svg, RIGHT + 12.0, y + 5.0, 14.0, "start", MORPH_SCALE_COLOUR, "%s", text);
}

/* Draws round ages below the graph, each with the fish's length at this age. The roundest ages are
 * placed first, and less round ages are added where there is room. Young fish need steps of days
 * and old fish steps of years. */
static void draw_ages(void)
{
    /* Steps of 10, 5, 2 and 1 years, then steps of 100 days to 1 day. */
    static const double steps_days[] = { 3652.5, 1826.25, 730.5, YEAR_DAYS, 100.0, 50.0,
                                         20.0,   10.0,    5.0,   2.0,       1.0 };
    const struct species_card *card = &plan.pick.fish->card;
    const double youngest = ceil((double)life_age_days(card, 0.0f) - 0.01);
    const double oldest = (double)life_age_days(card, 1.0f) + 0.01;
    double labelled[AGE_MAX]; /* Positions of the labelled ages, in pixels. */
    uint32_t count = 0;
    svg_line(svg, LEFT, AGES, RIGHT, AGES, SVG_INK, 1.2, NULL);
    for (size_t i = 0; i < sizeof steps_days / sizeof steps_days[0]; i++) {
        const double step = steps_days[i], last = fmin(oldest, 40.0 * step);
        const double first = step < YEAR_DAYS ? 0.0 : 2.0 * YEAR_DAYS;
        for (uint32_t n = 0; (double)n * step <= last; n++) {
            const double days = (double)n * step;
            bool has_room = count < AGE_MAX && days >= fmax(youngest, first);
            const float progress = has_room ? life_progress(card, (float)days) : 0.0f;
            const double x = graph_x((double)progress);
            for (uint32_t k = 0; k < count; k++) {
                has_room = has_room && fabs(labelled[k] - x) >= AGE_ROOM;
            }
            if (has_room) {
                char age[WORDS], length[WORDS];
                labelled[count++] = x;
                print_age(age, days);
                print_length(length, 1e3 * (double)life_length_m(card, progress), 3);
                svg_line(svg, x, AGES, x, AGES + 6.0, SVG_INK, 1.2, NULL);
                svg_text(svg, x, AGES + 24.0, 14.0, "middle", SVG_INK, "%s", age);
                svg_text(svg, x, AGES + 44.0, 13.0, "middle", MORPH_SCALE_COLOUR, "%s", length);
            }
        }
    }
    svg_text(svg, LEFT - 36.0, AGES + 24.0, 14.0, "end", SVG_INK, "age");
    svg_text(svg, LEFT - 36.0, AGES + 44.0, 13.0, "end", MORPH_SCALE_COLOUR, "length");
}

/* Draws the axes of the graph. The left axis shows weights and the right axis shows lengths. Below
 * the graph are the progress and the ages with their lengths. */
static void draw_axes(void)
{
    CORE_ASSERT(plan.high_mm > 0.0 && plan.low_mm <= plan.high_mm);
    for (int percent = 0; percent <= 100; percent += 25) {
        const double y = graph_y(0.01 * percent);
        svg_line(svg, LEFT, y, RIGHT, y, SVG_FAINT, 1.0, NULL);
        svg_text(svg, LEFT - 12.0, y + 5.0, 14.0, "end", SVG_INK, "%d %%", percent);
    }
    svg_put(svg, "<g transform=\"rotate(-90 40 %.0f)\">\n", graph_y(0.5));
    svg_text(svg, 40.0, graph_y(0.5), 15.0, "middle", SVG_INK, "share of each key");
    svg_put(svg, "</g>\n");
    svg_line(svg, LEFT, BOTTOM, RIGHT, BOTTOM, SVG_INK, 1.2, NULL);
    for (int i = 0; i <= 10; i++) {
        const double x = graph_x(0.1 * i);
        svg_line(svg, x, BOTTOM, x, BOTTOM + 6.0, SVG_INK, 1.2, NULL);
        svg_text(svg, x, BOTTOM + 24.0, 14.0, "middle", SVG_INK, "%g", 0.1 * i);
    }
    svg_text(svg, LEFT - 24.0, BOTTOM + 24.0, 14.0, "end", SVG_INK, "progress");
    draw_ages();
    svg_line(svg, RIGHT, TOP, RIGHT, BOTTOM, MORPH_SCALE_COLOUR, 1.5, NULL);
    const double most = plan.high_mm * 1.0001;
    if (plan.is_log) {
        /* On a logarithmic axis, ticks are drawn at the round lengths 1, 2, 5, 10 and so on. */
        double mm = round_below(2.5 * plan.low_mm);
        while (mm <= most) {
            draw_length(mm);
            mm = round_below(2.51 * mm);
        }
        return;
    }
    /* On a linear axis, the distance between two ticks is a round length. The axis has four to ten
     * ticks. */
    const double step = round_below(plan.high_mm / 4.0);
    double mm = 0.0;
    while (mm <= most) {
        draw_length(mm);
        mm += step;
    }
}

/* ---- Contents of the picture ----------------------------------------------------------------- */

static void draw_title(void)
{
    char title[CAPTION_WORDS_SIZE];
    const struct morph_options *pick = &plan.pick;
    const struct graph *graph = &pick->rig.curves[plan.curve];
    const enum graph_template template_id =
        pick->template_id != TEMPLATE_OWN || !pick->thesis
            ? pick->template_id
            : (enum graph_template)pick->drawn->card.thesis_template;
    caption_name(title, pick->fish->card.id);
    title[0] = (char)toupper((unsigned char)title[0]);
    svg_text(svg, LEFT, 50.0, 28.0, "start", SVG_INK, "%s", title);
    svg_text(svg, LEFT, 78.0, 15.0, "start", SVG_GREY, "%s%s curve%s%s%s%s",
             pick->thesis ? "chapter 4 of the 2005 thesis: " : "", morph_template_name(template_id),
             plan.curve > 0 ? " of the part " : "",
             plan.curve > 0 ? pick->fish->card.curve_names[plan.curve] : "",
             graph->line == GRAPH_SMOOTH ? ", smooth" : ", straight from knot to knot",
             graph->solved ? ", its shapes solved so that each drawing is passed through" : "");
}

/* Draws the shape of a key with its name, age and length, and a line down to the progress of the
 * key. */
static void draw_key(uint32_t key)
{
    CORE_ASSERT(key < plan.pick.fish->card.key_count);
    const struct species_card *card = &plan.pick.fish->card;
    const double spacing = (RIGHT - LEFT) / (card->key_count - 1.0);
    const double x = graph_x(key / (card->key_count - 1.0));
    char age[WORDS], length[WORDS], words[CAPTION_WORDS_SIZE];
    /* The shape is as large as possible and centred at `x`. */
    struct morph_outline outline = {
        .species = plan.pick.fish,
        .rig = &plan.keys,
        /* The outline shows the fish in the view in which its body has the largest area. */
        .view = card->form == FORM_DEPRESSED ? MORPH_OUTLINE_TOP : MORPH_OUTLINE_SIDE,
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
    morph_outline_draw(svg, &outline);
    print_age(age, (double)card->key_age_days[key]);
    print_length(length, 1e3 * (double)card->key_length_m[key], 4);
    caption_name(words, card->key_names[key]);
    svg_text(svg, x, TOP - 38.0, 16.0, "middle", morph_outline_key_colour(card, key), "%s", words);
    svg_text(svg, x, TOP - 18.0, 13.0, "middle", SVG_GREY, "%s, %s", age, length);
    svg_line(svg, x, TOP - 10.0, x, BOTTOM, SVG_GREY, 1.0, "3 4");
}

static void draw_curve(uint32_t key)
{
    CORE_ASSERT(key < plan.pick.fish->card.key_count);
    CORE_ASSERT(plan.curve < plan.pick.rig.curve_count);
    const struct species_card *card = &plan.pick.fish->card;
    const struct graph *graph = &plan.pick.rig.curves[plan.curve];
    svg_begin_line(svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        float weights[MORPH_KEY_MAX];
        const float progress = (float)i / (float)SAMPLES;
        graph_weights(graph, card->key_count, progress, weights);
        svg_point(svg, graph_x((double)progress), graph_y((double)weights[key]));
    }
    svg_end_line(svg, morph_outline_key_colour(card, key), 3.5, NULL);
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        svg_dot(svg, graph_x((double)graph->knots[i].progress),
                graph_y((double)graph->knots[i].weight[key]), 4.5, SVG_PAPER,
                morph_outline_key_colour(card, key));
    }
}

/* Labels the peaks and troughs of the length. For example, a conger larva is longest before its
 * metamorphosis to an eel. */
static void draw_turns(void)
{
    const struct species_card *card = &plan.pick.fish->card;
    double last = 1e3 * (double)life_length_m(card, 0.0f), turned = last, at = 0.0;
    /* Direction in which the length changes: 1 while it increases, -1 while it decreases, 0 before
     * the first change. */
    int way = 0;
    for (uint32_t i = 1; i <= TURN_SAMPLES; i++) {
        const double progress = (double)i / (double)TURN_SAMPLES;
        const double mm = 1e3 * (double)life_length_m(card, (float)progress);
        /* The length still changes in the direction `way`, so it becomes the new extreme length. */
        if (way == 0 || (mm - turned) * way >= 0.0) {
            way = way != 0 ? way : mm > last ? 1 : mm < last ? -1 : 0;
            turned = mm;
            at = progress;
        } else if (fabs(mm - turned) > TURN_LEAST * turned) {
            /* The label of a peak is above the curve, and the label of a trough below. */
            const double x = graph_x(at), y = length_y(turned);
            svg_dot(svg, x, y, 4.5, MORPH_SCALE_COLOUR, SVG_PAPER);
            svg_text(svg, x, y + (way > 0 ? -12.0 : 24.0), 15.0, "middle", MORPH_SCALE_COLOUR,
                     "%.1f mm", turned);
            way = -way;
            turned = mm;
            at = progress;
        }
        last = mm;
    }
}

/* Writes two notes below the graph: the meaning of the lines, and the names of the curves that the
 * graph does not show. */
static void draw_foot(void)
{
    CORE_ASSERT(plan.pick.fish->card.curve_count <= MORPH_CURVE_MAX);
    const struct species_card *card = &plan.pick.fish->card;
    const double y = HEIGHT - 28.0;
    char list[MORPH_CURVE_MAX * (SPECIES_NAME_SIZE + 2u)] = "";
    for (uint32_t i = 0; i < card->curve_count; i++) {
        if (i != plan.curve) {
            ctl_list_word(list, sizeof list, card->curve_names[i]);
        }
    }
    svg_text(svg, RIGHT, y, 13.0, "end", SVG_GREY,
             "Solid: what each key counts for, in its colour. Dashed: the fish's length%s.",
             plan.is_log ? ", by factors" : "");
    if (list[0]) {
        svg_text(svg, LEFT, y, 13.0, "start", SVG_GREY, "Other curves: %s.", list);
    }
}

static const struct option options[] = {
    { "svg", "FILE", "file of the picture", OPTION_TEXT,
      .offset = offsetof(struct graph_plan, path) },
    { "curve", "NAME", "curve of a part instead of the curve of the whole fish", OPTION_TEXT,
      .offset = offsetof(struct graph_plan, curve_name), .expects = "the name of a curve" },
};

static enum exit_code draw(void)
{
    if (!plan.path) {
        return morph_usage(name, "--svg FILE is missing");
    }
    const struct species_card *card = &plan.pick.fish->card;
    const enum exit_code code = morph_curve_find(card, name, plan.curve_name, &plan.curve);
    if (code != EXIT_OK) {
        return code;
    }
    if (!svg_open(svg, plan.path, WIDTH, HEIGHT, "Deformation graph")) {
        return morph_written(name, plan.path, -errno);
    }
    /* The length axis is logarithmic if the greatest length of the life is more than ten times the
     * least length. --thesis forces a linear axis, as in the 2005 thesis. */
    float min_m, max_m;
    morph_options_lengths(card, &min_m, &max_m);
    plan.is_log = !plan.pick.thesis && max_m > LOG_FROM * min_m;
    plan.low_mm = plan.is_log ? 1e3 * (double)min_m / FOOT : 0.0;
    plan.high_mm = 1e3 * (double)max_m;
    morph_rig_init(&plan.keys, card, TEMPLATE_PAIRWISE);
    draw_title();
    draw_axes();
    for (uint32_t key = 0; key < card->key_count; key++) {
        draw_key(key);
    }
    svg_begin_line(svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        const float progress = (float)i / (float)SAMPLES;
        svg_point(svg, graph_x((double)progress),
                  length_y(1e3 * (double)life_length_m(card, progress)));
    }
    svg_end_line(svg, MORPH_SCALE_COLOUR, 2.5, "9 5");
    for (uint32_t key = 0; key < card->key_count; key++) {
        draw_curve(key);
    }
    if (!plan.pick.thesis) {
        draw_turns();
    }
    draw_foot();
    return morph_written(name, plan.path, svg_close(svg) ? 0 : -errno);
}

const struct morph_command ctl_morph_graph = {
    .name = name,
    .options = MORPH_OPTION_TABLE(options),
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE --svg FILE [--template T] [--thesis] [--curve NAME]",
    .summary = "draws the deformation graph: a curve for each key, the length, and the ages",
    .usage =
        "The colours of the keys range from red to blue, as in the growth lab. Three keys are\n"
        "red, green and blue, as in the 2005 thesis. The length is purple, with its axis at the\n"
        "right. The axis is logarithmic if the greatest length is more than ten times the least\n"
        "length. With --thesis the axis is linear, as in the thesis.\n",
    .plan = &plan.pick,
    .run_fish = draw,
};
