/* lab_edit.c -- functions that drag, add and remove knots (control points) of a species' curves. */
#include "core/game/lab/lab_edit.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

#define ROUND_GAP (5.0f * LAB_KNOT_GAP)

/* ---- Creation, validation and comparison of edited graphs ------------------------------------ */

void lab_edit_own(struct lab_edit *edit, const struct species_card *card)
{
    CORE_ASSERT(card->curve_count >= 1);
    *edit = (struct lab_edit){ .template_id = TEMPLATE_OWN,
                               .scale_knot_count = card->scale_knot_count,
                               .graph = card->curves[0] };
    memcpy(edit->scale_knots, card->scale_knots, sizeof edit->scale_knots);
}

void lab_edit_template(struct lab_edit *edit, const struct species_card *card,
                       enum graph_template template_id)
{
    CORE_ASSERT(template_id < TEMPLATE_COUNT);
    edit->template_id = (uint8_t)template_id;
    if (template_id == TEMPLATE_OWN) {
        edit->graph = card->curves[0];
    } else {
        graph_from_template(&edit->graph, template_id, card->key_count, SIMULTANEOUS_PEAK);
    }
}

void lab_edit_apply(const struct lab_edit *edit, const struct species_card *card,
                    struct species_card *out)
{
    CORE_ASSERT(out != card);
    *out = *card;
    const uint32_t curves = edit->template_id == TEMPLATE_OWN ? 1u : card->curve_count;
    for (uint32_t i = 0; i < curves; i++) {
        out->curves[i] = edit->graph;
    }
    out->scale_knot_count = edit->scale_knot_count;
    memcpy(out->scale_knots, edit->scale_knots, sizeof out->scale_knots);
}

bool lab_edit_is_valid(const struct lab_edit *edit, const struct species_card *card)
{
    const struct scale_knot *knots = edit->scale_knots;
    const uint32_t count = edit->scale_knot_count;
    bool good = edit->template_id < TEMPLATE_COUNT && edit->graph.line <= GRAPH_SMOOTH &&
                edit->graph.solved <= 1u &&
                graph_check(&edit->graph, card->key_count).fault == GRAPH_GOOD;
    if (count == 0) {
        return good;
    }
    good = good && count >= 2 && count <= GRAPH_KNOT_MAX && knots[0].progress == 0.0f &&
           knots[count - 1u].progress == 1.0f;
    for (uint32_t i = 0; good && i < count; i++) {
        good = knots[i].length_m >= LAB_LENGTH_MIN_M && knots[i].length_m <= LAB_LENGTH_MAX_M &&
               (i == 0 || knots[i].progress > knots[i - 1u].progress);
    }
    return good;
}

bool lab_edit_same(const struct lab_edit *a, const struct lab_edit *b)
{
    const struct graph *ga = &a->graph, *gb = &b->graph;
    CORE_ASSERT(a->scale_knot_count <= GRAPH_KNOT_MAX && ga->knot_count <= GRAPH_KNOT_MAX);
    return (a->template_id == TEMPLATE_OWN) == (b->template_id == TEMPLATE_OWN) &&
           a->scale_knot_count == b->scale_knot_count && ga->knot_count == gb->knot_count &&
           ga->line == gb->line && ga->solved == gb->solved &&
           memcmp(ga->knots, gb->knots, ga->knot_count * sizeof ga->knots[0]) == 0 &&
           memcmp(a->scale_knots, b->scale_knots, a->scale_knot_count * sizeof a->scale_knots[0]) ==
               0;
}

/* ---- Weights of the key shapes --------------------------------------------------------------- */

void lab_edit_weigh(struct lab_edit *edit, uint32_t key_count, uint32_t knot, uint32_t key,
                    float weight)
{
    CORE_ASSERT(knot < edit->graph.knot_count);
    CORE_ASSERT(key < key_count && key_count >= 2);
    struct graph_knot *at = &edit->graph.knots[knot];
    float others = 0.0f;
    for (uint32_t i = 0; i < key_count; i++) {
        others += i != key ? at->weight[i] : 0.0f;
    }
    at->weight[key] = f_clamp(weight, 0.0f, 1.0f);
    const float rest = 1.0f - at->weight[key];
    for (uint32_t i = 0; i < key_count; i++) {
        if (i != key) {
            at->weight[i] = others > 1e-4f ? at->weight[i] * (rest / others) : 0.0f;
        }
    }
    /* If all other keys had weight 0, the neighbouring keys receive the remaining weight. */
    if (!(others > 1e-4f)) {
        at->weight[key > 0 ? key - 1u : key + 1u] += 0.5f * rest;
        at->weight[key + 1u < key_count ? key + 1u : key - 1u] += 0.5f * rest;
    }
}

void lab_edit_move(struct lab_edit *edit, uint32_t knot, float progress)
{
    struct graph_knot *at = &edit->graph.knots[knot];
    CORE_ASSERT(knot < edit->graph.knot_count);
    if (knot == 0 || knot + 1u == edit->graph.knot_count) {
        return;
    }
    const float low = at[-1].progress + LAB_KNOT_GAP, high = at[1].progress - LAB_KNOT_GAP;
    if (low <= high) {
        at->progress = f_clamp(progress, low, high);
    }
}

uint32_t lab_edit_add(struct lab_edit *edit, uint32_t key_count, float progress)
{
    CORE_ASSERT(edit->graph.knot_count <= GRAPH_KNOT_MAX);
    struct graph *graph = &edit->graph;
    struct graph_knot added = { .progress = progress };
    uint32_t place = 0;
    if (graph->knot_count == GRAPH_KNOT_MAX) {
        return LAB_NO_KNOT;
    }
    while (place < graph->knot_count && graph->knots[place].progress < progress) {
        place++;
    }
    if (place == 0 || place == graph->knot_count ||
        progress - graph->knots[place - 1u].progress < LAB_KNOT_GAP ||
        graph->knots[place].progress - progress < LAB_KNOT_GAP) {
        return LAB_NO_KNOT;
    }
    graph_weights(graph, key_count, progress, added.weight);
    memmove(&graph->knots[place + 1u], &graph->knots[place],
            (graph->knot_count - place) * sizeof graph->knots[0]);
    graph->knots[place] = added;
    graph->knot_count++;
    return place;
}

bool lab_edit_remove(struct lab_edit *edit, float progress)
{
    CORE_ASSERT(edit->graph.knot_count <= GRAPH_KNOT_MAX);
    struct graph *graph = &edit->graph;
    uint32_t nearest = LAB_NO_KNOT;
    float way = 2.0f;
    for (uint32_t i = 1; i + 1u < graph->knot_count; i++) {
        const float away = f_abs(graph->knots[i].progress - progress);
        if (away < way) {
            nearest = i;
            way = away;
        }
    }
    if (nearest == LAB_NO_KNOT) {
        return false;
    }
    graph->knot_count--;
    memmove(&graph->knots[nearest], &graph->knots[nearest + 1u],
            (graph->knot_count - nearest) * sizeof graph->knots[0]);
    graph->knots[graph->knot_count] = (struct graph_knot){ 0 };
    return true;
}

/* ---- Scale curve, which gives the fish's length ---------------------------------------------- */

struct scale_line {
    struct scale_knot *knots;
    uint32_t count;
};

/* Inserts `knot` into `line`, which is sorted by progress. The knot is omitted if the table is full
 * or if a knot with the same progress exists. */
static void draw_knot(struct scale_line *line, struct scale_knot knot)
{
    CORE_ASSERT(line->count <= GRAPH_KNOT_MAX);
    uint32_t place = 0;
    while (place < line->count && line->knots[place].progress < knot.progress) {
        place++;
    }
    if (line->count == GRAPH_KNOT_MAX ||
        (place < line->count && line->knots[place].progress == knot.progress)) {
        return;
    }
    memmove(&line->knots[place + 1u], &line->knots[place],
            (line->count - place) * sizeof line->knots[0]);
    line->knots[place] = knot;
    line->count++;
}

/* Returns true if the fish both grows and shrinks between the two keys before and after `age_days`.
 * The larva of a conger, for example, grows and then shrinks before it takes the shape of an
 * eel. */
static bool is_in_a_turn(const struct species_card *card, float age_days)
{
    CORE_ASSERT(card->key_count <= MORPH_KEY_MAX);
    const float *age = card->key_age_days;
    for (uint32_t i = 1; i < card->key_count; i++) {
        if (age_days > age[i - 1u] && age_days < age[i]) {
            return !growth_is_one_way(&card->growth, age[i - 1u], age[i]);
        }
    }
    return false;
}

/* Writes the displayed knots of the scale curve: the edited knots, or knots computed from the
 * growth curve. The computed knots are written in the order of their importance, because `out` may
 * be too small for all of them. First come the keys, then the points of the growth curve at which
 * growing changes to shrinking or back, then the other points between the same keys. Last, the
 * function adds a knot in the middle between two distant knots, because a straight line between
 * them would differ from the curve. */
uint32_t lab_edit_scale_knots(const struct lab_edit *edit, const struct species_card *card,
                              struct scale_knot out[GRAPH_KNOT_MAX])
{
    const struct growth *growth = &card->growth;
    struct scale_line line = { .knots = out };
    if (edit->scale_knot_count > 0) {
        memcpy(out, edit->scale_knots, sizeof edit->scale_knots);
        return edit->scale_knot_count;
    }
    CORE_ASSERT(card->key_count >= 2 && card->key_count <= MORPH_KEY_MAX);
    for (uint32_t i = 0; i < card->key_count; i++) {
        draw_knot(&line, (struct scale_knot){ (float)i / (float)(card->key_count - 1u),
                                              card->key_length_m[i] });
    }
    for (uint32_t turning = 2; turning-- > 0;) {
        for (uint32_t i = 0; i < growth->point_count; i++) {
            const struct growth_point *at = &growth->points[i];
            const bool is_turn =
                i > 0 && i + 1u < growth->point_count &&
                (at->length_m > at[-1].length_m) == (at->length_m > at[1].length_m);
            if (is_in_a_turn(card, at->age_days) && is_turn == (turning == 1u)) {
                draw_knot(&line,
                          (struct scale_knot){ life_progress(card, at->age_days), at->length_m });
            }
        }
    }
    for (uint32_t i = 1; i < line.count; i++) {
        const float from = out[i - 1u].progress, to = out[i].progress;
        const float middle = 0.5f * (from + to), age_days = life_age_days(card, middle);
        if (to - from > ROUND_GAP && is_in_a_turn(card, age_days)) {
            draw_knot(&line, (struct scale_knot){ middle, growth_length_m(growth, age_days) });
        }
    }
    return line.count;
}

static void draw_by_hand(struct lab_edit *edit, const struct species_card *card)
{
    edit->scale_knot_count = (uint8_t)lab_edit_scale_knots(edit, card, edit->scale_knots);
}

void lab_edit_size(struct lab_edit *edit, const struct species_card *card, uint32_t knot,
                   float length_m)
{
    draw_by_hand(edit, card);
    CORE_ASSERT(knot < edit->scale_knot_count);
    edit->scale_knots[knot].length_m = f_clamp(length_m, LAB_LENGTH_MIN_M, LAB_LENGTH_MAX_M);
}

void lab_edit_size_move(struct lab_edit *edit, const struct species_card *card, uint32_t knot,
                        float progress)
{
    draw_by_hand(edit, card);
    CORE_ASSERT(knot < edit->scale_knot_count);
    if (knot == 0 || knot + 1u == edit->scale_knot_count) {
        return;
    }
    struct scale_knot *at = &edit->scale_knots[knot];
    const float low = at[-1].progress + LAB_KNOT_GAP, high = at[1].progress - LAB_KNOT_GAP;
    if (low <= high) {
        at->progress = f_clamp(progress, low, high);
    }
}

uint32_t lab_edit_size_add(struct lab_edit *edit, const struct species_card *card, float progress)
{
    CORE_ASSERT(edit->scale_knot_count <= GRAPH_KNOT_MAX);
    struct species_card as_edited;
    lab_edit_apply(edit, card, &as_edited);
    const struct scale_knot added = { progress, life_length_m(&as_edited, progress) };
    uint32_t place = 0;
    struct lab_edit drawn = *edit;
    draw_by_hand(&drawn, card);
    if (drawn.scale_knot_count == GRAPH_KNOT_MAX) {
        return LAB_NO_KNOT;
    }
    while (place < drawn.scale_knot_count && drawn.scale_knots[place].progress < progress) {
        place++;
    }
    if (place == 0 || place == drawn.scale_knot_count ||
        progress - drawn.scale_knots[place - 1u].progress < LAB_KNOT_GAP ||
        drawn.scale_knots[place].progress - progress < LAB_KNOT_GAP) {
        return LAB_NO_KNOT;
    }
    memmove(&drawn.scale_knots[place + 1u], &drawn.scale_knots[place],
            (drawn.scale_knot_count - place) * sizeof drawn.scale_knots[0]);
    drawn.scale_knots[place] = added;
    drawn.scale_knot_count++;
    *edit = drawn;
    return place;
}

bool lab_edit_size_remove(struct lab_edit *edit, const struct species_card *card, float progress)
{
    CORE_ASSERT(edit->scale_knot_count <= GRAPH_KNOT_MAX);
    uint32_t nearest = LAB_NO_KNOT;
    float way = 2.0f;
    struct lab_edit drawn = *edit;
    draw_by_hand(&drawn, card);
    for (uint32_t i = 1; i + 1u < drawn.scale_knot_count; i++) {
        const float away = f_abs(drawn.scale_knots[i].progress - progress);
        if (away < way) {
            nearest = i;
            way = away;
        }
    }
    if (nearest == LAB_NO_KNOT) {
        return false;
    }
    drawn.scale_knot_count--;
    memmove(&drawn.scale_knots[nearest], &drawn.scale_knots[nearest + 1u],
            (drawn.scale_knot_count - nearest) * sizeof drawn.scale_knots[0]);
    *edit = drawn;
    return true;
}

struct span {
    float low_m, high_m;
};

static struct span axis_of(const struct species_card *card)
{
    struct span span = { card->key_length_m[0], card->key_length_m[0] };
    for (uint32_t i = 1; i < card->key_count; i++) {
        span.low_m = f_min(span.low_m, card->key_length_m[i]);
        span.high_m = f_max(span.high_m, card->key_length_m[i]);
    }
    return (struct span){ 0.5f * span.low_m, 2.0f * span.high_m };
}

float lab_length_share(const struct species_card *card, float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const struct span axis = axis_of(card);
    return f_log(length_m / axis.low_m) / f_log(axis.high_m / axis.low_m);
}

float lab_length_of_share(const struct species_card *card, float share)
{
    const struct span axis = axis_of(card);
    return axis.low_m * f_exp(share * f_log(axis.high_m / axis.low_m));
}
