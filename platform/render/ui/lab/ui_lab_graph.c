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

static void draw_graph_paper(const struct ui_frame *frame, enum lab_part part)
{
    const float u = frame->unit;
    const struct ui_box box = lab_place(frame, part);
    const struct ui_box shade = { box.x + 3.0f * u, box.y + 5.0f * u, box.width, box.height };
    ui_panel(frame, UI_PANEL, shade, 12.0f * u, 0.0f, 0x04061880u, 0);
    ui_panel(frame, UI_WASHI, box, 12.0f * u, 2.0f * u, LAB_PAPER, LAB_PAPER_LINE);
}

/* A point of a graph. `x` is a fraction of the graph's width from the left, and `y` is a fraction
 * of the graph's height from below. */
struct moment {
    float x, y;
};

static void in_field(struct ui_box field, struct moment at, float out[2])
{
    out[0] = field.x + at.x * field.width;
    out[1] = field.y + (1.0f - at.y) * field.height;
}

static void line_in(const struct ui_frame *frame, struct ui_box field, struct moment start,
                    struct moment end, float width, uint32_t colour)
{
    float from[2], to[2];
    in_field(field, start, from);
    in_field(field, end, to);
    ui_segment(frame->batch, from, to, width * frame->unit, colour);
}

static void dot_in(const struct ui_frame *frame, struct ui_box field, struct moment dot,
                   float radius, uint32_t fill, uint32_t line)
{
    float at[2];
    in_field(field, dot, at);
    ui_disc(frame, at[0], at[1], radius * frame->unit, 2.0f * frame->unit, fill, line);
}

/* ---- Deformation graph ---------------------------------------------------------------------- */

/* Draws the right-hand axis of lengths. The axis has labels at 1 mm, 10 mm, 100 mm and 1 m, as far
 * as these lengths lie in the range of the length curve. */
static void length_axis(const struct ui_frame *frame, struct ui_box field)
{
    static const struct {
        float length_m;
        const char *words;
    } marks[] = {
        { 0.001f, "1mm" }, { 0.01f, "1cm" }, { 0.1f, "10cm" }, { 1.0f, "1m" }, { 10.0f, "10m" }
    };
    const float u = frame->unit;
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++) {
        const float share = lab_length_share(&frame->scene->lab.card, marks[i].length_m);
        if (share < 0.0f || share > 1.0f) {
            continue;
        }
        float from[2];
        in_field(field, (struct moment){ 1.0f, share }, from);
        ui_segment(frame->batch, from, (const float[2]){ from[0] + 5.0f * u, from[1] }, 1.6f * u,
                   LAB_PURPLE);
        ui_text_at(frame, ui_body(frame, 15.5f, LAB_PURPLE), from[0] + 8.0f * u, from[1],
                   marks[i].words);
    }
}

/* Draws the weight curve of a key (modelled growth stage). If the curve is straight between two
 * knots (support points), this part is drawn as one segment. */
static void weight_curve(const struct ui_frame *frame, struct ui_box field, uint32_t key,
                         float width)
{
    const struct species_card *const card = &frame->scene->lab.card;
    CORE_ASSERT(key < card->key_count);
    const struct graph *const graph = &card->curves[0];
    const bool is_straight = graph->line == GRAPH_STRAIGHT;
    const uint32_t steps = is_straight ? graph->knot_count - 1u : CURVE_STEPS;
    struct moment from = { 0.0f, 0.0f };
    for (uint32_t i = 0; i <= steps; i++) {
        const float curve_x = (float)i / (float)steps;
        const float x = i > 0 && is_straight ? graph->knots[i].progress : curve_x;
        float weights[MORPH_KEY_MAX];
        graph_weights(graph, card->key_count, x, weights);
        const struct moment to = { x, weights[key] };
        if (i > 0) {
            line_in(frame, field, from, to, width, lab_key_colour(card->key_count, key));
        }
        from = to;
    }
}

/* Returns the point of the length curve at `progress` through life. */
static struct moment size_at(const struct species_card *card, float progress)
{
    const float share = lab_length_share(card, life_length_m(card, progress));
    return (struct moment){ progress, f_clamp(share, 0.0f, 1.0f) };
}

static void size_curve(const struct ui_frame *frame, struct ui_box field, float width)
{
    const struct species_card *const card = &frame->scene->lab.card;
    for (uint32_t i = 1; i <= CURVE_STEPS; i++) {
        line_in(frame, field, size_at(card, (float)(i - 1u) / (float)CURVE_STEPS),
                size_at(card, (float)i / (float)CURVE_STEPS), width, LAB_PURPLE);
    }
}

static void weight_knots(const struct ui_frame *frame, struct ui_box field, uint32_t key)
{
    CORE_ASSERT(key < MORPH_KEY_MAX);
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct graph *const graph = &lab->card.curves[0];
    const bool is_edited = lab->layer == key;
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        const bool is_held = is_edited && lab->holds == HOLD_WEIGHT && lab->held_knot == i;
        dot_in(frame, field,
               (struct moment){ graph->knots[i].progress, graph->knots[i].weight[key] },
               is_held     ? 12.0f
               : is_edited ? 9.0f
                           : 5.5f,
               lab_key_colour(lab->card.key_count, key), is_held ? LAB_INK : 0xffffffffu);
    }
}

/* Draws all curves of the deformation graph. The curve that the player drags is drawn last. */
static void draw_graph_curves(const struct ui_frame *frame, struct ui_box field)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const uint32_t count = lab->card.key_count;
    const bool edits_size = lab->layer >= MORPH_KEY_MAX;
    if (!edits_size) {
        size_curve(frame, field, 2.4f);
    }
    for (uint32_t key = 0; key < count; key++) {
        if (lab->layer != key) {
            weight_curve(frame, field, key, edits_size ? 2.0f : 3.0f);
        }
    }
    for (uint32_t key = 0; key < count && !edits_size; key++) {
        if (lab->layer != key) {
            weight_knots(frame, field, key);
        }
    }
    if (!edits_size) {
        weight_curve(frame, field, lab->layer, 4.2f);
        weight_knots(frame, field, lab->layer);
        return;
    }
    size_curve(frame, field, 4.2f);
    for (uint32_t i = 0; i < lab->scale_knot_count; i++) {
        const bool is_held = lab->holds == HOLD_SIZE && lab->held_knot == i;
        const float share = lab_length_share(&lab->card, lab->scale_knots[i].length_m);
        dot_in(frame, field,
               (struct moment){ lab->scale_knots[i].progress, f_clamp(share, 0.0f, 1.0f) },
               is_held ? 12.0f : 9.0f, LAB_PURPLE, is_held ? LAB_INK : 0xffffffffu);
    }
}

/* Draws a small tool button on the paper. The button has a bright surface while the pointer is over
 * it, and a coloured surface if `is_on` is true. */
static void tool(const struct ui_frame *frame, enum lab_part part, enum text_key key, bool is_on,
                 uint32_t colour)
{
    const float u = frame->unit;
    const struct ui_box box = lab_place(frame, part);
    const bool is_pointed = lab_is_pointed(frame, part);
    ui_panel(frame, UI_PANEL, box, 9.0f * u, (is_pointed ? 2.6f : 1.6f) * u,
             is_on        ? colour
             : is_pointed ? 0xffffffffu
                          : 0xf0e2c4ffu,
             colour);
    ui_label_in(frame, ui_inset(box, 6.0f * u), 19.5f, is_on ? 0xffffffffu : colour, key);
}

void lab_graph(const struct ui_frame *frame)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct ui_box field = lab_place(frame, LAB_PLOT), card = lab_place(frame, LAB_CARD);
    const float u = frame->unit, x = lab->progress;
    draw_graph_paper(frame, LAB_CARD);
    const struct ui_box title = { card.x + 16.0f * u, card.y + 4.0f * u, card.width - 32.0f * u,
                                  field.y - card.y - 8.0f * u };
    ui_label_in(frame, title, 22.0f, LAB_INK, TEXT_LAB_TITLE);
    for (uint32_t key = 0; key < lab->card.key_count; key++) {
        const float key_x = (float)key / (float)(lab->card.key_count - 1u);
        line_in(frame, field, (struct moment){ key_x, 0.0f }, (struct moment){ key_x, 1.0f }, 1.0f,
                GRID);
    }
    /* Draws the left axis, which shows the weights in per cent. The labels have a maximum width,
     * which keeps them away from the paper's frame and from a dragged knot. */
    for (uint32_t i = 0; i <= 4u; i++) {
        const float share = 0.25f * (float)i;
        line_in(frame, field, (struct moment){ 0.0f, share }, (struct moment){ 1.0f, share },
                i % 4u ? 1.0f : 1.8f, i % 4u ? GRID : LAB_INK_SOFT);
        if (i % 2u == 0) {
            float at[2];
            char words[8];
            in_field(field, (struct moment){ 0.0f, share }, at);
            snprintf(words, sizeof words, "%u%%", i * 25u);
            ui_text_at(frame, ui_style(frame, FONT_BODY, 15.0f, 1.0f, LAB_INK_SOFT, 38.0f * u),
                       at[0] - 10.0f * u, at[1], words);
        }
    }
    length_axis(frame, field);
    line_in(frame, field, (struct moment){ x, -0.03f }, (struct moment){ x, 1.03f }, 2.2f,
            UI_VERMILION);
    draw_graph_curves(frame, field);
    tool(frame, LAB_SIZE, TEXT_LAB_SIZE, lab->layer >= MORPH_KEY_MAX, LAB_PURPLE);
    tool(frame, LAB_ADD, TEXT_LAB_ADD, false, LAB_INK_SOFT);
    tool(frame, LAB_REMOVE, TEXT_LAB_REMOVE, false, LAB_INK_SOFT);
}

/* ---- Growth curve: length over age ---------------------------------------------------------- */

/* Returns the point of the growth curve at `progress` through life. `most` is the largest age in
 * days (x) and the largest length in metres (y). */
static struct moment moment_at(const struct species_card *card, float progress, struct moment most)
{
    return (struct moment){ life_age_days(card, progress) / most.x,
                            life_length_m(card, progress) / most.y };
}

void lab_chart(const struct ui_frame *frame)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct species_card *const card = &lab->card;
    const struct ui_box field = lab_place(frame, LAB_CHART);
    const uint32_t last = card->key_count - 1u;
    struct moment most = { card->key_age_days[last], 0.0f };
    for (uint32_t i = 0; i <= CHART_STEPS; i++) {
        most.y = fmaxf(most.y, life_length_m(card, (float)i / (float)CHART_STEPS));
    }
    draw_graph_paper(frame, LAB_CHART_CARD);
    const float u = frame->unit, foot = field.y + field.height + 20.0f * u;
    const struct moment zero = { 0.0f, 0.0f };
    char words[TEXT_LINE_MAX];
    struct ui_text style = ui_style(frame, FONT_BODY, 16.0f, 1.0f, LAB_INK_SOFT, 66.0f * u);
    line_in(frame, field, zero, (struct moment){ 1.0f, 0.0f }, 1.8f, LAB_INK_SOFT);
    line_in(frame, field, zero, (struct moment){ 0.0f, 1.0f }, 1.8f, LAB_INK_SOFT);
    lab_length_words(most.y, words, sizeof words);
    ui_text(frame->batch, style, field.x - 6.0f * u, field.y + 8.0f * u, words);
    style.fit_px = 0.0f;
    lab_age_words(frame->language, most.x, words, sizeof words);
    ui_text(frame->batch, style, field.x + field.width, foot, words);
    ui_text(frame->batch, ui_body(frame, 16.0f, LAB_INK_SOFT), field.x, foot,
            ui_words(frame, TEXT_LAB_CHART));
    /* The points of the growth curve are evenly spaced in the square root of age. If they were
     * evenly spaced in the progress through life, most points would lie in the first weeks. */
    struct moment before = moment_at(card, 0.0f, most);
    for (uint32_t i = 1; i <= CHART_STEPS; i++) {
        const float share = (float)i / (float)CHART_STEPS;
        const struct moment after =
            moment_at(card, life_progress(card, share * share * most.x), most);
        line_in(frame, field, before, after, 3.0f, LAB_PURPLE);
        before = after;
    }
    for (uint32_t key = 0; key <= last; key++) {
        dot_in(frame, field, moment_at(card, (float)key / (float)last, most), 5.0f,
               lab_key_colour(card->key_count, key), 0xffffffffu);
    }
    dot_in(frame, field, moment_at(card, lab->progress, most),
           lab->holds == HOLD_CHART ? 11.0f : 9.0f, UI_VERMILION, 0xffffffffu);
}
