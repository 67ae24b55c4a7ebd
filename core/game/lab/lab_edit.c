/* lab_edit.c -- functions that drag, add and remove knots. */
#include "core/game/lab/lab_edit.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

#define ROUND_GAP (5.0f * LAB_KNOT_GAP)

/* ---- Complete edits
 * --------------------------------------------------------------------------- */

void lab_edit_own(struct lab_edit *edit, const struct species_card *card)
{
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
        template_graph(&edit->graph, template_id, card->key_count, SIMULTANEOUS_PEAK);
    }
}

void lab_edit_apply(const struct lab_edit *edit, const struct species_card *card,
                    struct species_card *out)
{
    *out = *card;
    const uint32_t curves = edit->template_id == TEMPLATE_OWN ? 1u : card->curve_count;
    for (uint32_t i = 0; i < curves; i++) {
        out->curves[i] = edit->graph;
    }
    out->scale_knot_count = edit->scale_knot_count;
    memcpy(out->scale_knots, edit->scale_knots, sizeof out->scale_knots);
}

static bool scale_is_good(const struct lab_edit *edit)
{
    const uint32_t count = edit->scale_knot_count;
    if (count == 0) {
        return true;
    }
    bool good = count >= 2 && count <= GRAPH_KNOT_MAX && edit->scale_knots[0].progress == 0.0f &&
                edit->scale_knots[count - 1u].progress == 1.0f;
    for (uint32_t i = 0; good && i < count; i++) {
        const struct scale_knot *knot = &edit->scale_knots[i];
        good = knot->length_m >= LAB_LENGTH_MIN_M && knot->length_m <= LAB_LENGTH_MAX_M &&
               (i == 0 || knot->progress > knot[-1].progress);
    }
    return good;
}

bool lab_edit_is_valid(const struct lab_edit *edit, const struct species_card *card)
{
    return edit->template_id < TEMPLATE_COUNT && edit->graph.line <= GRAPH_SMOOTH &&
           edit->graph.solved <= 1u &&
           graph_check(&edit->graph, card->key_count).fault == GRAPH_GOOD && scale_is_good(edit);
}

static bool same_graph(const struct graph *a, const struct graph *b)
{
    if (a->knot_count != b->knot_count || a->line != b->line || a->solved != b->solved) {
        return false;
    }
    return memcmp(a->knots, b->knots, a->knot_count * sizeof a->knots[0]) == 0;
}

bool lab_edit_same(const struct lab_edit *a, const struct lab_edit *b)
{
    return (a->template_id == TEMPLATE_OWN) == (b->template_id == TEMPLATE_OWN) &&
           a->scale_knot_count == b->scale_knot_count && same_graph(&a->graph, &b->graph) &&
           memcmp(a->scale_knots, b->scale_knots, a->scale_knot_count * sizeof a->scale_knots[0]) ==
               0;
}

/* ---- Weights -------------------------------------------------------------------------------- */

static float sum_of_others(const struct graph_knot *knot, uint32_t key_count, uint32_t key)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < key_count; i++) {
        sum += i != key ? knot->weight[i] : 0.0f;
    }
    return sum;
}

/* Gives the remaining weight to the neighbouring keys, because all other keys have weight 0. */
static void share_among_neighbours(struct graph_knot *knot, uint32_t key_count, uint32_t key,
                                   float rest)
{
    const uint32_t before = key > 0 ? key - 1u : key + 1u;
    const uint32_t after = key + 1u < key_count ? key + 1u : key - 1u;
    for (uint32_t i = 0; i < key_count; i++) {
        if (i != key) {
            knot->weight[i] = 0.0f;
        }
    }
    knot->weight[before] += 0.5f * rest;
    knot->weight[after] += 0.5f * rest;
}

void lab_edit_weigh(struct lab_edit *edit, uint32_t key_count, uint32_t knot, uint32_t key,
                    float weight)
{
    CORE_ASSERT(knot < edit->graph.knot_count);
    CORE_ASSERT(key < key_count && key_count >= 2);
    struct graph_knot *at = &edit->graph.knots[knot];
    const float others = sum_of_others(at, key_count, key);
    at->weight[key] = f_clamp(weight, 0.0f, 1.0f);
    const float rest = 1.0f - at->weight[key];
    if (others > 1e-4f) {
        for (uint32_t i = 0; i < key_count; i++) {
            at->weight[i] *= i != key ? rest / others : 1.0f;
        }
    } else {
        share_among_neighbours(at, key_count, key, rest);
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

/* ---- Scale curve
 * ------------------------------------------------------------------------------ */

struct scale_line {
    struct scale_knot *knots;
    uint32_t count;
};

/* Inserts a knot in order of progress. The knot is omitted if the table is full or if a knot with
 * the same progress exists. */
static void draw_knot(struct scale_line *line, struct scale_knot knot)
{
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

/* Returns true if the length reverses between the two keys before and after `age_days`. The length
 * of a conger reverses before its eel shape. */
static bool is_in_a_turn(const struct species_card *card, float age_days)
{
    const float *age = card->key_age_days;
    for (uint32_t i = 1; i < card->key_count; i++) {
        if (age_days > age[i - 1u] && age_days < age[i]) {
            return !growth_is_one_way(&card->growth, age[i - 1u], age[i]);
        }
    }
    return false;
}

static bool is_turning_point(const struct growth *growth, uint32_t index)
{
    const struct growth_point *at = &growth->points[index];
    return index > 0 && index + 1u < growth->point_count &&
           (at->length_m > at[-1].length_m) == (at->length_m > at[1].length_m);
}

/* Draws the points at which the length reverses before all other points, because not all points may
 * fit. */
static void draw_turns(struct scale_line *line, const struct species_card *card)
{
    for (uint32_t turning = 2; turning-- > 0;) {
        for (uint32_t i = 0; i < card->growth.point_count; i++) {
            const struct growth_point *point = &card->growth.points[i];
            if (is_in_a_turn(card, point->age_days) &&
                is_turning_point(&card->growth, i) == (turning == 1u)) {
                draw_knot(line, (struct scale_knot){ life_progress(card, point->age_days),
                                                     point->length_m });
            }
        }
    }
}

/* Adds a knot in the middle between distant knots, because a straight line would cut off a curved
 * part. */
static void draw_rounds(struct scale_line *line, const struct species_card *card)
{
    for (uint32_t i = 1; i < line->count; i++) {
        const float from = line->knots[i - 1u].progress, to = line->knots[i].progress;
        const float middle = 0.5f * (from + to), age_days = life_age_days(card, middle);
        if (to - from > ROUND_GAP && is_in_a_turn(card, age_days)) {
            draw_knot(line,
                      (struct scale_knot){ middle, growth_length_m(&card->growth, age_days) });
        }
    }
}

uint32_t lab_edit_scale_knots(const struct lab_edit *edit, const struct species_card *card,
                              struct scale_knot out[GRAPH_KNOT_MAX])
{
    if (edit->scale_knot_count > 0) {
        memcpy(out, edit->scale_knots, sizeof edit->scale_knots);
        return edit->scale_knot_count;
    }
    struct scale_line line = { .knots = out };
    for (uint32_t i = 0; i < card->key_count; i++) {
        draw_knot(&line, (struct scale_knot){ (float)i / (float)(card->key_count - 1u),
                                              card->key_length_m[i] });
    }
    draw_turns(&line, card);
    draw_rounds(&line, card);
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
    const struct span axis = axis_of(card);
    return f_log(length_m / axis.low_m) / f_log(axis.high_m / axis.low_m);
}

float lab_length_of_share(const struct species_card *card, float share)
{
    const struct span axis = axis_of(card);
    return axis.low_m * f_exp(share * f_log(axis.high_m / axis.low_m));
}
