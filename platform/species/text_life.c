/* text_life.c -- parses the lines that describe the whole species: its name, its kind, its
 * growth and its deformation graphs. */
#include "platform/species/text.h"

#include <math.h>
#include <string.h>

#include "core/morph/morph.h"

static bool read_species(struct species_reader *r)
{
    return species_reader_name(r, 1, r->species->card.id);
}

/* Parses the lines `measure NAME`, `form NAME` and `motion NAME`. */
static bool read_kind(struct species_reader *r)
{
    struct species_card *card = &r->species->card;
    const struct {
        const char *word;
        const char *const *names;
        uint32_t count;
        uint8_t *out;
    } kinds[] = {
        { "measure", species_measure_names, MEASURE_DISC + 1, &card->measure },
        { "form", species_form_names, FORM_PUFFER + 1, &card->form },
        { "motion", species_motion_names, MOTION_WING + 1, &card->motion },
    };
    uint32_t kind = 0;
    while (kind + 1u < sizeof kinds / sizeof kinds[0] &&
           strcmp(kinds[kind].word, r->words[0]) != 0) {
        kind++;
    }
    return species_reader_choice(r, 1, kinds[kind].word, kinds[kind].names, kinds[kind].count,
                                 kinds[kind].out);
}

/* Parses the line `without FIN ..`, which lists the fins that the species lacks in every key. */
static bool read_without(struct species_reader *r)
{
    for (uint32_t i = 1; i < r->word_count; i++) {
        uint8_t fin = 0;
        if (!species_reader_choice(r, i, "fin", &part_names[PART_TAIL], PART_PELVIC - PART_TAIL + 1,
                                   &fin)) {
            return false;
        }
        r->species->without |= 1u << (PART_TAIL + fin);
    }
    return true;
}

static bool read_double(struct species_reader *r)
{
    r->species->double_tail = true;
    return true;
}

static bool read_confluent(struct species_reader *r)
{
    r->species->confluent = true;
    return true;
}

static bool read_growth(struct species_reader *r)
{
    static const struct range ranges[] = { { 0.01f, 20.0f }, { 0.001f, 10.0f }, { -20.0f, 20.0f } };
    r->has_growth = true;
    return species_reader_numbers(r, 1, ranges, 3, &r->species->card.growth);
}

static bool read_hatch(struct species_reader *r)
{
    struct growth *g = &r->species->card.growth;
    if (g->point_count > 0) {
        return species_reader_error(r, "only one 'hatch' line is allowed, above the points");
    }
    g->point_count = 1;
    return species_reader_number(r, 1, 0.0005f, 2.0f, &g->points[0].length_m) &&
           species_reader_number(r, 2, 0.001f, 5.0f, &g->fade_year);
}

/* Parses the line `point AGE_DAYS MM`, which gives a measured length in mm at an age in days after
 * hatching. */
static bool read_point(struct species_reader *r)
{
    static const struct range ranges[] = { { 0.0f, 14610.0f }, { 0.5f, 20000.0f } };
    struct growth *g = &r->species->card.growth;
    if (g->point_count == 0) {
        return species_reader_error(r, "a 'point' line must be below the 'hatch' line");
    }
    struct growth_point *point = &g->points[g->point_count];
    if (!species_reader_room(r, g->point_count, GROWTH_POINT_MAX, "points, hatching among them") ||
        !species_reader_numbers(r, 1, ranges, 2, point)) {
        return false;
    }
    if (point->age_days <= point[-1].age_days) {
        return species_reader_error(
            r, "the age must increase from point to point, and must be above 0 days");
    }
    point->length_m /= 1000.0f;
    g->point_count++;
    return true;
}

/* Parses the line `scale PROGRESS MM`, which gives a length in mm at a progress through life [0,
 * 1]. If a species has `scale` lines, they determine the length over its life instead of the growth
 * curve. */
static bool read_scale(struct species_reader *r)
{
    static const struct range ranges[] = { { 0.0f, 1.0f }, { 0.5f, 20000.0f } };
    struct species_card *card = &r->species->card;
    struct scale_knot *knot = &card->scale_knots[card->scale_knot_count];
    if (!species_reader_room(r, card->scale_knot_count, GRAPH_KNOT_MAX, "scale knots") ||
        !species_reader_numbers(r, 1, ranges, 2, knot)) {
        return false;
    }
    if (card->scale_knot_count == 0 ? knot->progress != 0.0f
                                    : knot->progress <= knot[-1].progress) {
        return species_reader_error(
            r, "the first scale knot must be at progress 0, and progress must increase");
    }
    knot->length_m /= 1000.0f;
    card->scale_knot_count++;
    return true;
}

static bool key_named(const struct species_reader *r, uint32_t index, uint8_t *out)
{
    const struct species_card *card = &r->species->card;
    for (uint8_t key = 0; key < card->key_count; key++) {
        if (strcmp(r->words[index], card->key_names[key]) == 0) {
            *out = key;
            return true;
        }
    }
    return species_reader_error(r, "no key above has the name '%.40s'", r->words[index]);
}

/* Parses the line `thesis KEY KEY KEY TEMPLATE`, which names three keys and a template (a
 * ready-made deformation graph). They are the input of the blending method of the 2005 thesis,
 * chapter 4. */
static bool read_thesis(struct species_reader *r)
{
    static const char *const templates[] = {
        [TEMPLATE_PAIRWISE] = "pairwise", [TEMPLATE_SIMULTANEOUS] = "simultaneous"
    };
    uint8_t *key = r->species->card.thesis_key;
    if (!key_named(r, 1, &key[0]) || !key_named(r, 2, &key[1]) || !key_named(r, 3, &key[2]) ||
        !species_reader_choice(r, 4, "template of the thesis", templates, 4,
                               &r->species->card.thesis_template)) {
        return false;
    }
    if (key[0] >= key[1] || key[1] >= key[2]) {
        return species_reader_error(
            r, "the three keys of the thesis must be in the order of their ages");
    }
    r->has_thesis = true;
    return true;
}

/* ---- Deformation graphs ---------------------------------------------------------------------- */

/* This section parses the lines of the deformation graphs: first the graph of the whole fish,
 * then the graphs of parts. */

static struct graph *newest_graph(const struct species_reader *r)
{
    return &r->species->card.curves[r->species->card.curve_count - 1];
}

/* Parses the line `curve NAME PART ..`, which starts a deformation graph that moves only the named
 * parts. The following lines define the graph by knots or by a template. */
static bool read_curve(struct species_reader *r)
{
    struct species_text *s = r->species;
    const uint32_t curve = s->card.curve_count;
    if (s->card.key_count < 3 || newest_graph(r)->knot_count == 0) {
        return species_reader_error(
            r, "a 'curve' line must be below the keys and the graph of the whole fish");
    }
    if (!species_reader_room(r, curve - 1u, MORPH_CURVE_MAX - 1u,
                             "curves besides the whole fish's") ||
        !species_reader_name(r, 1, s->card.curve_names[curve])) {
        return false;
    }
    for (uint32_t i = 2; i < r->word_count; i++) {
        uint8_t part = 0;
        if (!species_reader_choice(r, i, "part", &part_names[PART_EYE], OWNED_COUNT - PART_EYE,
                                   &part)) {
            return false;
        }
        part = (uint8_t)(part + PART_EYE);
        for (uint32_t other = 1; other < curve; other++) {
            if (s->curves[other].parts >> part & 1u) {
                return species_reader_error(r, "the %s already moves by the curve %s",
                                            part_names[part], s->card.curve_names[other]);
            }
        }
        s->curves[curve].parts |= 1u << part;
    }
    r->curve_line[s->card.curve_count++] = r->line;
    return true;
}

/* Parses the line `area FROM TO LOW HIGH SOFT`, which selects an area of the body (struct area).
 * The deformation graph of the most recent `curve` line moves the skin inside this area. */
static bool read_area(struct species_reader *r)
{
    static const struct range ranges[] = {
        { 0.0f, 1.0f }, { 0.0f, 1.0f }, { 0.0f, 1.0f }, { 0.0f, 1.0f }, { 0.02f, 0.5f }
    };
    struct curve_text *curve = &r->species->curves[r->species->card.curve_count - 1];
    if (r->species->card.curve_count == 1) {
        return species_reader_error(r, "an 'area' line must be below a 'curve' line");
    }
    if (!species_reader_room(r, curve->area_count, AREA_MAX, "areas")) {
        return false;
    }
    struct area *a = &curve->areas[curve->area_count++];
    return species_reader_numbers(r, 1, ranges, 5, a) &&
           ((a->from < a->to && a->low < a->high) ||
            species_reader_error(r, "the area ends before it starts"));
}

/* Checks that the species has its keys (modelled growth stages) before its first deformation graph.
 * The keys are needed because each knot (support point) of a graph has one weight for each key. */
static bool are_keys_complete(const struct species_reader *r)
{
    return r->species->card.key_count >= 3 ||
           species_reader_error(
               r, "'%s' must be below the keys, and there must be three or more keys", r->words[0]);
}

/* Parses the line `knot PROGRESS W1 W2 ..`, which sets the weight of each key at a progress through
 * life [0, 1]. */
static bool read_knot(struct species_reader *r)
{
    struct graph *graph = newest_graph(r);
    const uint32_t key_count = r->species->card.key_count;
    if (!are_keys_complete(r) ||
        !species_reader_room(r, graph->knot_count, GRAPH_KNOT_MAX, "knots")) {
        return false;
    }
    if (r->word_count != key_count + 2) {
        return species_reader_error(
            r, "write: knot PROGRESS and one weight for each of the %u keys above", key_count);
    }
    struct graph_knot *knot = &graph->knots[graph->knot_count];
    if (!species_reader_number(r, 1, 0.0f, 1.0f, &knot->progress)) {
        return false;
    }
    if (graph->knot_count == 0 ? knot->progress != 0.0f : knot->progress <= knot[-1].progress) {
        return species_reader_error(
            r, "the first knot must be at progress 0, and progress must increase");
    }
    float sum = 0.0f;
    for (uint32_t i = 0; i < key_count; i++) {
        if (!species_reader_number(r, i + 2, 0.0f, 1.0f, &knot->weight[i])) {
            return false;
        }
        sum += knot->weight[i];
    }
    if (fabsf(sum - 1.0f) > 1e-6f) {
        return species_reader_error(r, "the sum of the weights is %g, but must be 1", (double)sum);
    }
    graph->knot_count++;
    return true;
}

/* Parses the line `line straight|smooth|solved`, which selects the interpolation between knots. */
static bool read_line_kind(struct species_reader *r)
{
    static const char *const kinds[] = { "straight", "smooth", "solved" };
    uint8_t kind = 0;
    if (!species_reader_choice(r, 1, "line", kinds, 3, &kind)) {
        return false;
    }
    newest_graph(r)->line = kind == 0 ? GRAPH_STRAIGHT : GRAPH_SMOOTH;
    newest_graph(r)->solved = kind == 2;
    return true;
}

/* Parses the line `template NAME [PEAK]`, which defines all knots of a deformation graph by a named
 * template. */
static bool read_template(struct species_reader *r)
{
    static const char *const names[] = { [TEMPLATE_ORDINARY] = "ordinary",
                                         [TEMPLATE_PAIRWISE] = "pairwise",
                                         [TEMPLATE_SIMULTANEOUS] = "simultaneous",
                                         [TEMPLATE_SMOOTH] = "smooth" };
    struct graph *graph = newest_graph(r);
    uint8_t template_id = 0;
    float peak = SIMULTANEOUS_PEAK;
    if (!are_keys_complete(r)) {
        return false;
    }
    if (graph->knot_count > 0) {
        return species_reader_error(r, "a graph has either one template or knots");
    }
    if (!species_reader_choice(r, 1, "template", names, TEMPLATE_COUNT, &template_id)) {
        return false;
    }
    if (r->word_count == 3) {
        if (template_id != TEMPLATE_SIMULTANEOUS) {
            return species_reader_error(r, "only the simultaneous template has a peak");
        }
        if (!species_reader_number(r, 2, 0.51f, 0.99f, &peak)) {
            return false;
        }
    }
    if (graph->line != GRAPH_STRAIGHT || graph->solved) {
        return species_reader_error(r, "a 'line' line must be below the 'template' line");
    }
    graph_from_template(graph, (enum graph_template)template_id, r->species->card.key_count, peak);
    return true;
}

const struct line_word text_life_words[] = {
    { "species", 1, 1, "ID", read_species },
    { "measure", 1, 1, "measure", read_kind },
    { "form", 1, 1, "form", read_kind },
    { "motion", 1, 1, "motion", read_kind },
    { "without", 1, TEXT_WORD_MAX, "FIN ..", read_without },
    { "confluent", 0, 0, "", read_confluent },
    { "double", 0, 0, "", read_double },
    { "growth", 3, 3, "LENGTH_INF_M K_PER_YEAR T0_YEAR", read_growth },
    { "hatch", 2, 2, "LENGTH_M FADE_YEAR", read_hatch },
    { "point", 2, 2, "AGE_DAYS MM", read_point },
    { "scale", 2, 2, "PROGRESS MM", read_scale },
    { "thesis", 4, 4, "KEY KEY KEY pairwise|simultaneous", read_thesis },
    { "curve", 1, TEXT_WORD_MAX, "NAME PART .. (then its knots or template, and areas)",
      read_curve },
    { "area", 5, 5, "FROM TO LOW HIGH SOFT", read_area },
    { "knot", 0, TEXT_WORD_MAX, "", read_knot },
    { "line", 1, 1, "straight|smooth|solved", read_line_kind },
    { "template", 1, 2, "pairwise|simultaneous|smooth|ordinary [PEAK]", read_template },
    { NULL, 0, 0, NULL, NULL },
};
