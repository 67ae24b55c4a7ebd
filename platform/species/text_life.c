/* text_life.c -- parses the lines that describe the whole species: its name, its kind, its
 * growth and its deformation graphs. */
#include "platform/species/text.h"

#include <math.h>
#include <string.h>

#include "core/morph/morph.h"

static bool read_choice(struct species_reader *r, const char *what, const char *const *choices,
                        uint32_t count, uint8_t *out)
{
    uint32_t chosen = 0;
    if (!species_reader_expect(r, 1, what) ||
        !species_reader_choice(r, 1, what, choices, count, &chosen)) {
        return false;
    }
    *out = (uint8_t)chosen;
    return true;
}

bool text_read_species(struct species_reader *r)
{
    return species_reader_expect(r, 1, "ID") && species_reader_name(r, 1, r->species->id);
}

bool text_read_measure(struct species_reader *r)
{
    return read_choice(r, "measure", species_measure_names, 4, &r->species->measure);
}

bool text_read_form(struct species_reader *r)
{
    return read_choice(r, "form", species_form_names, 5, &r->species->form);
}

bool text_read_motion(struct species_reader *r)
{
    return read_choice(r, "motion", species_motion_names, 5, &r->species->motion);
}

/* Parses the line `without FIN ..`, which lists the fins that the species lacks in every key. */
bool text_read_without(struct species_reader *r)
{
    for (uint32_t i = 1; i < r->word_count; i++) {
        const char *const *fins = &part_names[PART_TAIL];
        uint32_t fin = 0;
        if (!species_reader_choice(r, i, "fin", fins, PART_PELVIC - PART_TAIL + 1, &fin)) {
            return false;
        }
        r->species->without |= 1u << (PART_TAIL + fin);
    }
    return r->word_count > 1 || species_reader_error(r, "write: without FIN ..");
}

bool text_read_confluent(struct species_reader *r)
{
    r->species->confluent = true;
    return r->word_count == 1 || species_reader_error(r, "write: confluent");
}

bool text_read_growth(struct species_reader *r)
{
    struct growth *g = &r->species->growth;
    r->has_growth = true;
    return species_reader_expect(r, 3, "LENGTH_INF_M K_PER_YEAR T0_YEAR") &&
           species_reader_number(r, 1, 0.01f, 20.0f, &g->length_inf_m) &&
           species_reader_number(r, 2, 0.001f, 10.0f, &g->k_per_year) &&
           species_reader_number(r, 3, -20.0f, 20.0f, &g->t0_year);
}

bool text_read_hatch(struct species_reader *r)
{
    struct growth *g = &r->species->growth;
    if (g->point_count > 0) {
        return species_reader_error(r, "one hatch, above the points");
    }
    r->has_hatch = true;
    g->point_count = 1;
    return species_reader_expect(r, 2, "LENGTH_M FADE_YEAR") &&
           species_reader_number(r, 1, 0.0005f, 2.0f, &g->points[0].length_m) &&
           species_reader_number(r, 2, 0.001f, 5.0f, &g->fade_year);
}

/* Parses the line `point AGE_DAYS MM`, which gives a measured length in mm at an age in days after
 * hatching. */
bool text_read_point(struct species_reader *r)
{
    struct growth *g = &r->species->growth;
    if (g->point_count == 0) {
        return species_reader_error(r, "points stand below hatch, which is the first of them");
    }
    if (g->point_count == GROWTH_POINT_MAX) {
        return species_reader_error(r, "more than %u points, hatching among them",
                                    GROWTH_POINT_MAX);
    }
    struct growth_point *point = &g->points[g->point_count];
    if (!species_reader_expect(r, 2, "AGE_DAYS MM") ||
        !species_reader_number(r, 1, 0.0f, 14610.0f, &point->age_days) ||
        !species_reader_number(r, 2, 0.5f, 20000.0f, &point->length_m)) {
        return false;
    }
    if (point->age_days <= point[-1].age_days) {
        return species_reader_error(r, "points go from young to old, and hatching is at 0 days");
    }
    point->length_m /= 1000.0f;
    g->point_count++;
    return true;
}

/* Parses the line `scale PROGRESS MM`, which gives a length in mm at a progress through life [0,
 * 1]. The `scale` lines of a species replace its growth curve. */
bool text_read_scale(struct species_reader *r)
{
    struct species_text *s = r->species;
    if (s->scale_knot_count == GRAPH_KNOT_MAX) {
        return species_reader_error(r, "more than %u scale knots", GRAPH_KNOT_MAX);
    }
    struct scale_knot *knot = &s->scale_knots[s->scale_knot_count];
    if (!species_reader_expect(r, 2, "PROGRESS MM") ||
        !species_reader_number(r, 1, 0.0f, 1.0f, &knot->progress) ||
        !species_reader_number(r, 2, 0.5f, 20000.0f, &knot->length_m)) {
        return false;
    }
    if (s->scale_knot_count == 0 ? knot->progress != 0.0f : knot->progress <= knot[-1].progress) {
        return species_reader_error(r, "scale knots go from progress 0 upward");
    }
    knot->length_m /= 1000.0f;
    s->scale_knot_count++;
    return true;
}

static bool key_named(const struct species_reader *r, uint32_t index, uint8_t *out)
{
    for (uint32_t key = 0; key < r->species->key_count; key++) {
        if (strcmp(r->words[index], r->species->keys[key].name) == 0) {
            *out = (uint8_t)key;
            return true;
        }
    }
    return species_reader_error(r, "no key above is called '%.40s'", r->words[index]);
}

/* Parses the line `thesis KEY KEY KEY TEMPLATE`, which names the three keys and the template that
 * the 2005 thesis, chapter 4, blends for this species. */
bool text_read_thesis(struct species_reader *r)
{
    static const char *const templates[] = {
        [TEMPLATE_PAIRWISE] = "pairwise", [TEMPLATE_SIMULTANEOUS] = "simultaneous"
    };
    struct species_text *s = r->species;
    uint8_t *key = s->thesis_key;
    uint32_t template_id = 0;
    if (!species_reader_expect(r, 4, "KEY KEY KEY pairwise|simultaneous") ||
        !key_named(r, 1, &key[0]) || !key_named(r, 2, &key[1]) || !key_named(r, 3, &key[2]) ||
        !species_reader_choice(r, 4, "template of the thesis", templates, 4, &template_id)) {
        return false;
    }
    if (key[0] >= key[1] || key[1] >= key[2]) {
        return species_reader_error(r, "the thesis' three keys go from young to old");
    }
    s->thesis_template = (uint8_t)template_id;
    r->has_thesis = true;
    return true;
}

/* ---- Deformation graphs ---------------------------------------------------------------------- */

/* This section parses the lines of the deformation graphs: first the graph of the whole fish,
 * then the graphs of parts. */

static struct curve_text *newest_curve(const struct species_reader *r)
{
    return &r->species->curves[r->species->curve_count - 1];
}

/* Parses the line `curve NAME PART ..`, which starts a deformation graph that moves only the named
 * parts. The following lines define the graph by knots or by a template. */
bool text_read_curve(struct species_reader *r)
{
    struct species_text *s = r->species;
    if (r->word_count < 2) {
        return species_reader_error(
            r, "write: curve NAME PART .. (then its knots or template, and areas)");
    }
    if (s->key_count < 3 || newest_curve(r)->graph.knot_count == 0) {
        return species_reader_error(
            r, "a curve stands below the keys and the graph of the whole fish");
    }
    if (s->curve_count == MORPH_CURVE_MAX) {
        return species_reader_error(r, "more than %u curves besides the whole fish's",
                                    MORPH_CURVE_MAX - 1u);
    }
    struct curve_text *curve = &s->curves[s->curve_count];
    if (!species_reader_name(r, 1, curve->name)) {
        return false;
    }
    for (uint32_t i = 2; i < r->word_count; i++) {
        uint32_t part = 0;
        if (!species_reader_choice(r, i, "part", &part_names[PART_EYE], OWNED_COUNT - PART_EYE,
                                   &part)) {
            return false;
        }
        part += PART_EYE;
        for (uint32_t other = 1; other < s->curve_count; other++) {
            if (s->curves[other].parts >> part & 1u) {
                return species_reader_error(r, "the %s already moves by the curve %s",
                                            part_names[part], s->curves[other].name);
            }
        }
        curve->parts |= 1u << part;
    }
    r->curve_line[s->curve_count++] = r->line;
    return true;
}

/* Parses the line `area FROM TO LOW HIGH SOFT`, which defines a painted area of the body. The most
 * recent `curve` line moves the area. */
bool text_read_area(struct species_reader *r)
{
    struct curve_text *curve = newest_curve(r);
    if (r->species->curve_count == 1) {
        return species_reader_error(r, "an area stands under a curve");
    }
    if (curve->area_count == AREA_MAX) {
        return species_reader_error(r, "more than %d areas", AREA_MAX);
    }
    struct area *a = &curve->areas[curve->area_count++];
    return species_reader_expect(r, 5, "FROM TO LOW HIGH SOFT") &&
           species_reader_number(r, 1, 0.0f, 1.0f, &a->from) &&
           species_reader_number(r, 2, 0.0f, 1.0f, &a->to) &&
           species_reader_number(r, 3, 0.0f, 1.0f, &a->low) &&
           species_reader_number(r, 4, 0.0f, 1.0f, &a->high) &&
           species_reader_number(r, 5, 0.02f, 0.5f, &a->soft) &&
           ((a->from < a->to && a->low < a->high) ||
            species_reader_error(r, "the area ends before it starts"));
}

/* Checks that the most recently started graph may receive knots or a template. Graphs must be
 * defined after all keys (modelled growth stages), because a knot has one weight for each key. */
static bool graph_open(const struct species_reader *r, bool from_knot)
{
    const struct graph *graph = &newest_curve(r)->graph;
    if (r->species->key_count < 3) {
        return species_reader_error(r, "'%s' stands below the keys, three or more", r->words[0]);
    }
    if (!from_knot && graph->knot_count > 0) {
        return species_reader_error(r, "a graph has one template, or knots of its own");
    }
    return true;
}

/* Parses the line `knot PROGRESS W1 W2 ..`, which sets the weight of each key at a progress through
 * life [0, 1]. */
bool text_read_knot(struct species_reader *r)
{
    struct graph *graph = &newest_curve(r)->graph;
    const uint32_t key_count = r->species->key_count;
    if (!graph_open(r, true)) {
        return false;
    }
    if (graph->knot_count == GRAPH_KNOT_MAX) {
        return species_reader_error(r, "more than %u knots", GRAPH_KNOT_MAX);
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
        return species_reader_error(r, "knots go from progress 0 upward");
    }
    float sum = 0.0f;
    for (uint32_t i = 0; i < key_count; i++) {
        if (!species_reader_number(r, i + 2, 0.0f, 1.0f, &knot->weight[i])) {
            return false;
        }
        sum += knot->weight[i];
    }
    if (fabsf(sum - 1.0f) > 1e-6f) {
        return species_reader_error(r, "the weights' sum is %g, not 1", (double)sum);
    }
    graph->knot_count++;
    return true;
}

/* Parses the line `line straight|smooth|solved`, which selects the interpolation between knots. */
bool text_read_line_kind(struct species_reader *r)
{
    static const char *const kinds[] = { "straight", "smooth", "solved" };
    struct graph *graph = &newest_curve(r)->graph;
    uint32_t kind = 0;
    if (!species_reader_expect(r, 1, "straight|smooth|solved") ||
        !species_reader_choice(r, 1, "line", kinds, 3, &kind)) {
        return false;
    }
    graph->line = kind == 0 ? GRAPH_STRAIGHT : GRAPH_SMOOTH;
    graph->solved = kind == 2;
    return true;
}

/* Parses the line `template NAME [PEAK]`, which defines all knots of a deformation graph by a named
 * template. */
bool text_read_template(struct species_reader *r)
{
    static const char *const names[] = { [TEMPLATE_ORDINARY] = "ordinary",
                                         [TEMPLATE_PAIRWISE] = "pairwise",
                                         [TEMPLATE_SIMULTANEOUS] = "simultaneous",
                                         [TEMPLATE_SMOOTH] = "smooth" };
    uint32_t template_id = 0;
    float peak = SIMULTANEOUS_PEAK;
    if (r->word_count != 2 && r->word_count != 3) {
        return species_reader_error(r,
                                    "write: template pairwise|simultaneous|smooth|ordinary [PEAK]");
    }
    if (!graph_open(r, false) ||
        !species_reader_choice(r, 1, "template", names, TEMPLATE_COUNT, &template_id)) {
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
    if (newest_curve(r)->graph.line != GRAPH_STRAIGHT || newest_curve(r)->graph.solved) {
        return species_reader_error(r, "a line's kind stands below the template that it bends");
    }
    graph_from_template(&newest_curve(r)->graph, (enum graph_template)template_id,
                        r->species->key_count, peak);
    return true;
}
