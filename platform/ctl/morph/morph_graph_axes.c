/* morph_graph_axes.c -- draws the axes of a deformation graph and their labels. */
#include "platform/ctl/morph/morph_graph.h"

#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/ctl/morph/morph_outline.h"

#define AGES 652.0 /* Distance of the row of ages from the top of the picture, in pixels. */
#define YEAR_DAYS 365.25
/* Ratio of the least length to the lower end of a logarithmic axis. The margin leaves room for the
 * label of a trough. */
#define FOOT 1.4
/* Ratio of the greatest to the least length above which the length axis is logarithmic. */
#define LOG_FROM 10.0f
#define AGE_MAX 16u   /* Maximum number of ages with a label. */
#define AGE_ROOM 78.0 /* Minimum distance between two labelled ages in pixels. */

double morph_graph_x(double progress)
{
    return MORPH_GRAPH_LEFT + (MORPH_GRAPH_RIGHT - MORPH_GRAPH_LEFT) * progress;
}

double morph_graph_y(double share)
{
    return MORPH_GRAPH_BOTTOM + (MORPH_GRAPH_TOP - MORPH_GRAPH_BOTTOM) * share;
}

void morph_graph_print_age(char out[MORPH_GRAPH_WORDS], double days)
{
    if (days < 2.0 * YEAR_DAYS - 0.5) {
        snprintf(out, MORPH_GRAPH_WORDS, "%.0f d", days);
    } else {
        snprintf(out, MORPH_GRAPH_WORDS, "%.3g y", days / YEAR_DAYS);
    }
}

void morph_graph_print_length(char out[MORPH_GRAPH_WORDS], double mm, int digits)
{
    const bool small = mm < 1000.0;
    snprintf(out, MORPH_GRAPH_WORDS, "%.*g %s", digits, small ? mm : 1e-3 * mm, small ? "mm" : "m");
}

/* Returns the greatest value that is 1, 2 or 5 times a power of ten and at most `mm`. */
static double round_below(double mm)
{
    const double power = pow(10.0, floor(log10(mm) + 1e-9)), part = mm / power + 1e-6;
    return power * (part >= 5.0 ? 5.0 : part >= 2.0 ? 2.0 : 1.0);
}

struct morph_graph_lengths morph_graph_lengths(const struct species_card *card, bool is_even)
{
    float min_m, max_m;
    morph_options_lengths(card, &min_m, &max_m);
    if (is_even || max_m <= LOG_FROM * min_m) {
        return (struct morph_graph_lengths){ 0.0, 1e3 * (double)max_m, false };
    }
    return (struct morph_graph_lengths){ 1e3 * (double)min_m / FOOT, 1e3 * (double)max_m, true };
}

double morph_graph_length_y(const struct morph_graph_lengths *lengths, double mm)
{
    return morph_graph_y(lengths->is_log
                             ? log(mm / lengths->low_mm) / log(lengths->high_mm / lengths->low_mm)
                             : mm / lengths->high_mm);
}

static void draw_length(struct svg *svg, const struct morph_graph_lengths *lengths, double mm)
{
    const double y = morph_graph_length_y(lengths, mm);
    char text[MORPH_GRAPH_WORDS];
    morph_graph_print_length(text, mm, 4);
    svg_line(svg, MORPH_GRAPH_RIGHT, y, MORPH_GRAPH_RIGHT + 6.0, y, MORPH_SCALE_COLOUR, 1.5, NULL);
    svg_text(svg, MORPH_GRAPH_RIGHT + 12.0, y + 5.0, 14.0, "start", MORPH_SCALE_COLOUR, "%s", text);
}

/* State of placing the labelled ages on the axis. */
struct age_axis {
    const struct species_card *card;
    double youngest, oldest;
    double x[AGE_MAX];
    uint32_t count;
};

/* Draws one mark with an age and the length at this age, if the mark has room between the marks
 * that are already drawn. */
static void draw_age(struct svg *svg, struct age_axis *axis, double days)
{
    const float progress = life_progress(axis->card, (float)days);
    const double x = morph_graph_x((double)progress);
    char age[MORPH_GRAPH_WORDS], length[MORPH_GRAPH_WORDS];
    bool has_room = axis->count < AGE_MAX;
    for (uint32_t i = 0; i < axis->count; i++) {
        has_room = has_room && fabs(axis->x[i] - x) >= AGE_ROOM;
    }
    if (!has_room) {
        return;
    }
    axis->x[axis->count++] = x;
    morph_graph_print_age(age, days);
    morph_graph_print_length(length, 1e3 * (double)life_length_m(axis->card, progress), 3);
    svg_line(svg, x, AGES, x, AGES + 6.0, SVG_INK, 1.2, NULL);
    svg_text(svg, x, AGES + 24.0, 14.0, "middle", SVG_INK, "%s", age);
    svg_text(svg, x, AGES + 44.0, 13.0, "middle", MORPH_SCALE_COLOUR, "%s", length);
}

/* Draws a mark at round ages, with the age and the length. The roundest ages are placed first, and
 * less round ages are added if there is room. Young fish need steps of days and old fish steps of
 * years. */
static void draw_ages(struct svg *svg, const struct species_card *card)
{
    static const double steps_days[] = { 10.0 * YEAR_DAYS,
                                         5.0 * YEAR_DAYS,
                                         2.0 * YEAR_DAYS,
                                         YEAR_DAYS,
                                         100.0,
                                         50.0,
                                         20.0,
                                         10.0,
                                         5.0,
                                         2.0,
                                         1.0 };
    struct age_axis axis = { .card = card,
                             .youngest = ceil((double)life_age_days(card, 0.0f) - 0.01),
                             .oldest = (double)life_age_days(card, 1.0f) + 0.01 };
    svg_line(svg, MORPH_GRAPH_LEFT, AGES, MORPH_GRAPH_RIGHT, AGES, SVG_INK, 1.2, NULL);
    for (size_t i = 0; i < sizeof steps_days / sizeof steps_days[0]; i++) {
        const double step = steps_days[i], last = fmin(axis.oldest, 40.0 * step);
        const double first = step < YEAR_DAYS ? 0.0 : 2.0 * YEAR_DAYS;
        for (double days = 0.0; days <= last; days += step) {
            if (days >= fmax(axis.youngest, first)) {
                draw_age(svg, &axis, days);
            }
        }
    }
    svg_text(svg, MORPH_GRAPH_LEFT - 36.0, AGES + 24.0, 14.0, "end", SVG_INK, "age");
    svg_text(svg, MORPH_GRAPH_LEFT - 36.0, AGES + 44.0, 13.0, "end", MORPH_SCALE_COLOUR, "length");
}

void morph_graph_axes(struct svg *svg, const struct species_card *card,
                      const struct morph_graph_lengths *lengths)
{
    CORE_ASSERT(lengths->high_mm > 0.0 && lengths->low_mm <= lengths->high_mm);
    CORE_ASSERT(card->key_count >= 2);
    for (int percent = 0; percent <= 100; percent += 25) {
        const double y = morph_graph_y(0.01 * percent);
        svg_line(svg, MORPH_GRAPH_LEFT, y, MORPH_GRAPH_RIGHT, y, SVG_FAINT, 1.0, NULL);
        svg_text(svg, MORPH_GRAPH_LEFT - 12.0, y + 5.0, 14.0, "end", SVG_INK, "%d %%", percent);
    }
    svg_put(svg, "<g transform=\"rotate(-90 40 %.0f)\">\n", morph_graph_y(0.5));
    svg_text(svg, 40.0, morph_graph_y(0.5), 15.0, "middle", SVG_INK, "share of each key");
    svg_put(svg, "</g>\n");
    svg_line(svg, MORPH_GRAPH_LEFT, MORPH_GRAPH_BOTTOM, MORPH_GRAPH_RIGHT, MORPH_GRAPH_BOTTOM,
             SVG_INK, 1.2, NULL);
    for (int i = 0; i <= 10; i++) {
        const double x = morph_graph_x(0.1 * i);
        svg_line(svg, x, MORPH_GRAPH_BOTTOM, x, MORPH_GRAPH_BOTTOM + 6.0, SVG_INK, 1.2, NULL);
        svg_text(svg, x, MORPH_GRAPH_BOTTOM + 24.0, 14.0, "middle", SVG_INK, "%g", 0.1 * i);
    }
    svg_text(svg, MORPH_GRAPH_LEFT - 24.0, MORPH_GRAPH_BOTTOM + 24.0, 14.0, "end", SVG_INK,
             "progress");
    draw_ages(svg, card);
    /* The step of the scale is 1, 2 or 5 times a power of ten. The scale has four to ten steps. */
    const double power = pow(10.0, floor(log10(lengths->high_mm / 4.0)));
    const double part = lengths->high_mm / 4.0 / power;
    const double step = power * (part >= 5.0   ? 5.0
                                 : part >= 2.0 ? 2.0
                                               : 1.0),
                 most = lengths->high_mm * 1.0001;
    svg_line(svg, MORPH_GRAPH_RIGHT, MORPH_GRAPH_TOP, MORPH_GRAPH_RIGHT, MORPH_GRAPH_BOTTOM,
             MORPH_SCALE_COLOUR, 1.5, NULL);
    for (double mm = 0.0; !lengths->is_log && step > 0.0 && mm <= most; mm += step) {
        draw_length(svg, lengths, mm);
    }
    /* A logarithmic scale has the round lengths 1, 2, 5, 10 and so on. */
    for (double mm = round_below(2.5 * lengths->low_mm); lengths->is_log && mm > 0.0 && mm <= most;
         mm = round_below(2.51 * mm)) {
        draw_length(svg, lengths, mm);
    }
}
