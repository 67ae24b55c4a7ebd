/* ui_lab_graph.c -- draws the deformation graph on paper, with one weight curve for each key
 * (modelled growth stage) and one curve for the fish's length. Draws the growth curve below the
 * deformation graph. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/lab/lab.h"
#include "platform/render/ui/lab/ui_lab.h"

#define CURVE_STEPS 40u
#define CHART_STEPS 60u
#define GRID 0xb5a58a70u

/* ---- Paper background ----------------------------------------------------------------------- */

static void draw_graph_paper(const struct lab_page *page, enum lab_part part)
{
    const float u = page->frame.unit;
    const struct ui_box box = lab_place(page, part);
    const struct ui_box shade = { box.x + 3.0f * u, box.y + 5.0f * u, box.width, box.height };
    ui_panel(&page->frame, UI_PANEL, shade, 12.0f * u, 0.0f, 0x04061880u, 0);
    ui_panel(&page->frame, UI_WASHI, box, 12.0f * u, 2.0f * u, LAB_PAPER, LAB_PAPER_LINE);
}

static void in_field(struct ui_box field, float x, float y, float out[2])
{
    out[0] = field.x + x * field.width;
    out[1] = field.y + (1.0f - y) * field.height;
}

static void line_in(const struct lab_page *page, struct ui_box field, const float shares[4],
                    float width, uint32_t colour)
{
    float from[2], to[2];
    in_field(field, shares[0], shares[1], from);
    in_field(field, shares[2], shares[3], to);
    ui_segment(page->frame.batch, from, to, width * page->frame.unit, colour);
}

static void dot_in(const struct lab_page *page, struct ui_box field, float x, float y, float radius,
                   uint32_t fill, uint32_t line)
{
    float at[2];
    const float r = radius * page->frame.unit;
    in_field(field, x, y, at);
    ui_disc(&page->frame, at[0], at[1], r, 2.0f * page->frame.unit, fill, line);
}

/* ---- Deformation graph ---------------------------------------------------------------------- */

static void percent_axis(const struct lab_page *page, struct ui_box field)
{
    const float u = page->frame.unit;
    struct ui_text style = lab_text(page, 15.0f, LAB_INK_SOFT);
    style.align = 1.0f;
    style.fit_px = 38.0f * u; /* The maximum width keeps the label away from the paper's frame and
                                 from a dragged knot. */
    for (uint32_t i = 0; i <= 4u; i++) {
        const float share = 0.25f * (float)i;
        char words[8];
        line_in(page, field, (const float[4]){ 0.0f, share, 1.0f, share }, i % 4u ? 1.0f : 1.8f,
                i % 4u ? GRID : LAB_INK_SOFT);
        if (i % 2u == 0) {
            float at[2];
            in_field(field, 0.0f, share, at);
            snprintf(words, sizeof words, "%u%%", i * 25u);
            ui_text_at(&page->frame, &style, at[0] - 10.0f * u, at[1], words);
        }
    }
}

/* Draws the right-hand axis of lengths. Its labels are those of 1 mm, 10 mm, 100 mm and 1 m that
 * lie in the range of the length curve. */
static void length_axis(const struct lab_page *page, struct ui_box field)
{
    static const struct {
        float length_m;
        const char *words;
    } marks[] = {
        { 0.001f, "1mm" }, { 0.01f, "1cm" }, { 0.1f, "10cm" }, { 1.0f, "1m" }, { 10.0f, "10m" }
    };
    const struct ui_text style = lab_text(page, 15.5f, LAB_PURPLE);
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++) {
        const float share = lab_length_share(&page->lab->card, marks[i].length_m);
        if (share < 0.0f || share > 1.0f) {
            continue;
        }
        float at[2];
        in_field(field, 1.0f, share, at);
        const float from[2] = { at[0], at[1] }, to[2] = { at[0] + 5.0f * page->frame.unit, at[1] };
        ui_segment(page->frame.batch, from, to, 1.6f * page->frame.unit, LAB_PURPLE);
        ui_text_at(&page->frame, &style, at[0] + 8.0f * page->frame.unit, at[1], marks[i].words);
    }
}

/* Draws the weight curve of a key (modelled growth stage). A straight line between two knots is
 * drawn as one segment. */
static void weight_curve(const struct lab_page *page, struct ui_box field, uint32_t key,
                         float width)
{
    CORE_ASSERT(key < page->lab->card.key_count);
    const struct graph *graph = &page->lab->card.curves[0];
    const uint32_t count = page->lab->card.key_count;
    const int straight = graph->line == GRAPH_STRAIGHT;
    const uint32_t steps = straight ? graph->knot_count - 1u : CURVE_STEPS;
    float before[MORPH_KEY_MAX], after[MORPH_KEY_MAX];
    float from = 0.0f;
    graph_weights(graph, count, 0.0f, before);
    for (uint32_t i = 1; i <= steps; i++) {
        const float to = straight ? graph->knots[i].progress : (float)i / (float)steps;
        graph_weights(graph, count, to, after);
        line_in(page, field, (const float[4]){ from, before[key], to, after[key] }, width,
                lab_key_colour(count, key));
        from = to;
        before[key] = after[key];
    }
}

static float size_share(const struct lab_page *page, float progress)
{
    const struct species_card *card = &page->lab->card;
    const float share = lab_length_share(card, life_length_m(card, progress));
    return fminf(fmaxf(share, 0.0f), 1.0f);
}

static void size_curve(const struct lab_page *page, struct ui_box field, float width)
{
    float before = size_share(page, 0.0f);
    for (uint32_t i = 1; i <= CURVE_STEPS; i++) {
        const float from = (float)(i - 1u) / (float)CURVE_STEPS;
        const float to = (float)i / (float)CURVE_STEPS, after = size_share(page, to);
        line_in(page, field, (const float[4]){ from, before, to, after }, width, LAB_PURPLE);
        before = after;
    }
}

static void weight_knots(const struct lab_page *page, struct ui_box field, uint32_t key)
{
    CORE_ASSERT(key < MORPH_KEY_MAX);
    const struct scene_lab *lab = page->lab;
    const struct graph *graph = &lab->card.curves[0];
    const int in_hand = lab->layer == key;
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        const int held = in_hand && lab->holds == HOLD_WEIGHT && lab->held_knot == i;
        dot_in(page, field, graph->knots[i].progress, graph->knots[i].weight[key],
               held      ? 12.0f
               : in_hand ? 9.0f
                         : 5.5f,
               lab_key_colour(lab->card.key_count, key), held ? LAB_INK : 0xffffffffu);
    }
}

/* Draws all curves of the deformation graph. The curve that the player drags is drawn last. */
static void draw_graph_curves(const struct lab_page *page, struct ui_box field)
{
    const struct scene_lab *lab = page->lab;
    const uint32_t count = lab->card.key_count;
    const int sizes = lab->layer >= MORPH_KEY_MAX;
    if (!sizes) {
        size_curve(page, field, 2.4f);
    }
    for (uint32_t key = 0; key < count; key++) {
        if (lab->layer != key) {
            weight_curve(page, field, key, sizes ? 2.0f : 3.0f);
        }
    }
    for (uint32_t key = 0; key < count && !sizes; key++) {
        if (lab->layer != key) {
            weight_knots(page, field, key);
        }
    }
    if (sizes) {
        size_curve(page, field, 4.2f);
        for (uint32_t i = 0; i < lab->scale_knot_count; i++) {
            const int held = lab->holds == HOLD_SIZE && lab->held_knot == i;
            const float share = lab_length_share(&lab->card, lab->scale_knots[i].length_m);
            dot_in(page, field, lab->scale_knots[i].progress, fminf(fmaxf(share, 0.0f), 1.0f),
                   held ? 12.0f : 9.0f, LAB_PURPLE, held ? LAB_INK : 0xffffffffu);
        }
    } else {
        weight_curve(page, field, lab->layer, 4.2f);
        weight_knots(page, field, lab->layer);
    }
}

/* Draws a small tool button on the paper. The button is slightly lower while it is pressed. */
static void tool(const struct lab_page *page, enum lab_part part, enum text_key key, int is_on,
                 uint32_t colour)
{
    const float u = page->frame.unit;
    const struct ui_box box = lab_place(page, part);
    const int pointed = lab_is_pointed(page, part);
    ui_panel(&page->frame, UI_PANEL, box, 9.0f * u, (pointed ? 2.6f : 1.6f) * u,
             is_on     ? colour
             : pointed ? 0xffffffffu
                       : 0xf0e2c4ffu,
             colour);
    const struct ui_text style = lab_text(page, 19.5f, is_on ? 0xffffffffu : colour);
    const struct ui_box room = { box.x + 6.0f * u, box.y, box.width - 12.0f * u, box.height };
    ui_words_in(&page->frame, room, &style, ui_words(&page->frame, key));
}

void lab_graph(const struct lab_page *page)
{
    const struct ui_box field = lab_place(page, LAB_PLOT);
    draw_graph_paper(page, LAB_CARD);
    const float u = page->frame.unit;
    const struct ui_box card = lab_place(page, LAB_CARD), plot = lab_place(page, LAB_PLOT);
    const struct ui_text style = lab_text(page, 22.0f, LAB_INK);
    const struct ui_box room = { card.x + 16.0f * u, card.y + 4.0f * u, card.width - 32.0f * u,
                                 plot.y - card.y - 8.0f * u };
    ui_words_in(&page->frame, room, &style, ui_words(&page->frame, TEXT_LAB_TITLE));
    const uint32_t count = page->lab->card.key_count;
    for (uint32_t key = 0; key < count; key++) {
        const float key_x = (float)key / (float)(count - 1u);
        line_in(page, field, (const float[4]){ key_x, 0.0f, key_x, 1.0f }, 1.0f, GRID);
    }
    percent_axis(page, field);
    length_axis(page, field);
    const float x = page->lab->progress;
    line_in(page, field, (const float[4]){ x, -0.03f, x, 1.03f }, 2.2f, UI_VERMILION);
    draw_graph_curves(page, field);
    tool(page, LAB_SIZE, TEXT_LAB_SIZE, page->lab->layer >= MORPH_KEY_MAX, LAB_PURPLE);
    tool(page, LAB_ADD, TEXT_LAB_ADD, 0, LAB_INK_SOFT);
    tool(page, LAB_REMOVE, TEXT_LAB_REMOVE, 0, LAB_INK_SOFT);
}

/* ---- Growth curve: length over age ---------------------------------------------------------- */

/* A point of the growth curve: age and length, as fractions of the chart's width and height. */
struct moment {
    float x, y;
};

static struct moment moment_at(const struct species_card *card, float progress, float most_days,
                               float most_m)
{
    return (struct moment){ life_age_days(card, progress) / most_days,
                            life_length_m(card, progress) / most_m };
}

void lab_chart(const struct lab_page *page)
{
    const struct scene_lab *lab = page->lab;
    const struct species_card *card = &lab->card;
    const struct ui_box field = lab_place(page, LAB_CHART);
    const uint32_t last = card->key_count - 1u;
    float most_m = 0.0f;
    for (uint32_t i = 0; i <= CHART_STEPS; i++) {
        most_m = fmaxf(most_m, life_length_m(card, (float)i / (float)CHART_STEPS));
    }
    const float most_days = card->key_age_days[last];
    draw_graph_paper(page, LAB_CHART_CARD);
    const float u = page->frame.unit;
    char words[TEXT_LINE_MAX];
    struct ui_text style = lab_text(page, 16.0f, LAB_INK_SOFT);
    line_in(page, field, (const float[4]){ 0.0f, 0.0f, 1.0f, 0.0f }, 1.8f, LAB_INK_SOFT);
    line_in(page, field, (const float[4]){ 0.0f, 0.0f, 0.0f, 1.0f }, 1.8f, LAB_INK_SOFT);
    style.align = 1.0f;
    style.fit_px = 66.0f * u;
    lab_length_words(most_m, words, sizeof words);
    ui_text(page->frame.batch, &style, field.x - 6.0f * u, field.y + 8.0f * u, words);
    style.fit_px = 0.0f;
    lab_age_words(page->frame.language, most_days, words, sizeof words);
    ui_text(page->frame.batch, &style, field.x + field.width, field.y + field.height + 20.0f * u,
            words);
    style.align = 0.0f;
    ui_text(page->frame.batch, &style, field.x, field.y + field.height + 20.0f * u,
            ui_words(&page->frame, TEXT_LAB_CHART));
    /* The points of the growth curve have equal distances in the square root of age. With equal
     * distances in the progress through life, most points would lie in the first weeks. */
    struct moment before = moment_at(card, 0.0f, most_days, most_m);
    for (uint32_t i = 1; i <= CHART_STEPS; i++) {
        const float share = (float)i / (float)CHART_STEPS;
        const float progress = life_progress(card, share * share * most_days);
        const struct moment after = moment_at(card, progress, most_days, most_m);
        line_in(page, field, (const float[4]){ before.x, before.y, after.x, after.y }, 3.0f,
                LAB_PURPLE);
        before = after;
    }
    for (uint32_t key = 0; key <= last; key++) {
        const struct moment at = moment_at(card, (float)key / (float)last, most_days, most_m);
        dot_in(page, field, at.x, at.y, 5.0f, lab_key_colour(card->key_count, key), 0xffffffffu);
    }
    const struct moment now = moment_at(card, lab->progress, most_days, most_m);
    dot_in(page, field, now.x, now.y, lab->holds == HOLD_CHART ? 11.0f : 9.0f, UI_VERMILION,
           0xffffffffu);
}
