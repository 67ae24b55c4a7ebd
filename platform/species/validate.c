/* validate.c -- validates the card and the coats of an untrusted species. */
#include "platform/species/validate.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/morph/morph.h"

/* Maximum age in days. The growth curves (growth.c) are defined for ages of up to 40 years. */
#define AGE_MAX_DAYS 14610.0f
/* Minimum length of a key in metres. The smallest fish larvae are 1.5 mm long. A length below a
 * third of this size is certainly an error. */
#define LENGTH_MIN_M 0.0005f
#define LENGTH_MAX_M 20.0f /* Maximum length of a key in metres. A whale shark is 20 m long. */
/* Maximum relative difference between a key's length and the length on the growth curve at the
 * key's age. */
#define LENGTH_APART 0.02f

bool validate_refuse(struct vetting *v, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(v->why, VALIDATE_WHY_SIZE, format, values);
    va_end(values);
    return false;
}

bool validate_number(struct vetting *v, const char *what, float x, float low, float high)
{
    if (!(x >= low && x <= high)) { /* The negated comparison also rejects NaN. */
        return validate_refuse(v, "%s: %g is outside %g .. %g", what, (double)x, (double)low,
                               (double)high);
    }
    return true;
}

bool validate_choice(struct vetting *v, const char *what, uint32_t x, uint32_t count)
{
    return x < count || validate_refuse(v, "%s: %u is outside 0 .. %u", what, x, count - 1u);
}

bool species_name_is_good(const char text[SPECIES_NAME_SIZE])
{
    const char *end = memchr(text, 0, SPECIES_NAME_SIZE);
    if (!end || end == text) {
        return false;
    }
    for (const char *c = text; c < text + SPECIES_NAME_SIZE; c++) {
        if (c < end ? !strchr("abcdefghijklmnopqrstuvwxyz0123456789_", *c) : *c != 0) {
            return false;
        }
    }
    return true;
}

static bool vet_name(struct vetting *v, const char *what, const char text[SPECIES_NAME_SIZE])
{
    return species_name_is_good(text) ||
           validate_refuse(v, "%s: no name of a-z, 0-9 and _, 1 to %u long", what,
                           SPECIES_NAME_SIZE - 1u);
}

static bool vet_keys(struct vetting *v)
{
    const struct species_card *card = &v->species->card;
    if (card->key_count < 3 || card->key_count > MORPH_KEY_MAX) {
        return validate_refuse(v, "keys: %u, and a species has 3 to %u", card->key_count,
                               MORPH_KEY_MAX);
    }
    for (uint32_t key = 0; key < card->key_count; key++) {
        char what[VALIDATE_WHAT_SIZE];
        const float age = card->key_age_days[key];
        snprintf(what, sizeof what, "key %u/name", key);
        if (!vet_name(v, what, card->key_names[key])) {
            return false;
        }
        snprintf(what, sizeof what, "%s/age_days", card->key_names[key]);
        if (!validate_number(v, what, age, 0.0f, AGE_MAX_DAYS)) {
            return false;
        }
        if (key > 0 && age <= card->key_age_days[key - 1]) {
            return validate_refuse(v, "%s: %g is not above the key before", what, (double)age);
        }
        snprintf(what, sizeof what, "%s/length_m", card->key_names[key]);
        if (!validate_number(v, what, card->key_length_m[key], LENGTH_MIN_M, LENGTH_MAX_M)) {
            return false;
        }
        for (uint32_t other = 0; other < key; other++) {
            if (strcmp(card->key_names[key], card->key_names[other]) == 0) {
                return validate_refuse(v, "key %u/name: '%s' is there already", key,
                                       card->key_names[key]);
            }
        }
    }
    return true;
}

static bool vet_scale(struct vetting *v)
{
    const struct species_card *card = &v->species->card;
    const uint32_t count = card->scale_knot_count;
    if (count == 1 || count > GRAPH_KNOT_MAX) {
        return validate_refuse(v, "scale knots: %u, and there are none or 2 to %u", count,
                               GRAPH_KNOT_MAX);
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct scale_knot *knot = &card->scale_knots[i];
        const float first = i == 0 ? 0.0f : i + 1 == count ? 1.0f : knot->progress;
        if (!validate_number(v, "scale knot/progress", knot->progress, 0.0f, 1.0f) ||
            !validate_number(v, "scale knot/length_m", knot->length_m, LENGTH_MIN_M,
                             LENGTH_MAX_M)) {
            return false;
        }
        if (knot->progress != first || (i > 0 && knot->progress <= knot[-1].progress)) {
            return validate_refuse(v, "scale knot/progress: %g does not go from 0 to 1",
                                   (double)knot->progress);
        }
    }
    return true;
}

bool species_validate_graph(const struct graph *graph, uint32_t key_count, const char *curve,
                            char why[VALIDATE_WHY_SIZE])
{
    static const char *const reasons[] = {
        [GRAPH_KNOT_COUNT] = "fewer than 2 knots or more than there may be",
        [GRAPH_ENDS] = "the knots do not go from progress 0 to 1",
        [GRAPH_ORDER] = "a knot not behind the one before",
        [GRAPH_NEGATIVE] = "a weight that is negative or no number",
        [GRAPH_SUM] = "weights whose sum is not 1",
        [GRAPH_UNSOLVABLE] = "to be solved, but a key is hardly seen at its own progress",
    };
    struct vetting v = { .why = why };
    char what[VALIDATE_WHAT_SIZE];
    snprintf(what, sizeof what, "curve %s/line", curve);
    if (!validate_choice(&v, what, graph->line, GRAPH_SMOOTH + 1u)) {
        return false;
    }
    snprintf(what, sizeof what, "curve %s/solved", curve);
    if (!validate_choice(&v, what, graph->solved, 2)) {
        return false;
    }
    const struct graph_verdict verdict = graph_check(graph, key_count);
    if (verdict.fault != GRAPH_GOOD) {
        const bool known = verdict.fault < sizeof reasons / sizeof reasons[0];
        return validate_refuse(&v, "curve %s/knot %u: %s (%g)", curve, verdict.knot,
                               known ? reasons[verdict.fault] : "no graph", (double)verdict.value);
    }
    return true;
}

static bool vet_curves(struct vetting *v)
{
    const struct species_card *card = &v->species->card;
    if (card->curve_count < 1 || card->curve_count > MORPH_CURVE_MAX) {
        return validate_refuse(v, "curves: %u, and there are 1 to %u", card->curve_count,
                               MORPH_CURVE_MAX);
    }
    for (uint32_t i = 0; i < card->curve_count; i++) {
        char what[VALIDATE_WHAT_SIZE];
        snprintf(what, sizeof what, "curve %u/name", i);
        if (!vet_name(v, what, card->curve_names[i]) ||
            !species_validate_graph(&card->curves[i], card->key_count, card->curve_names[i],
                                    v->why)) {
            return false;
        }
    }
    return true;
}

static bool vet_coats(struct vetting *v)
{
    const struct species_card *card = &v->species->card;
    for (uint32_t key = 0; key < card->key_count; key++) {
        const struct species_coat *coat = &v->species->coats[key];
        const uint32_t all = coat->back | coat->flank | coat->belly | coat->fin | coat->iris;
        if (all > 0xffffffu) {
            return validate_refuse(v, "%s/coat: a colour beyond ffffff", card->key_names[key]);
        }
        if (coat->mark_count > MARK_MAX) {
            return validate_refuse(v, "%s/marks: more than %u", card->key_names[key], MARK_MAX);
        }
        for (uint32_t i = 0; i < coat->mark_count; i++) {
            const struct species_mark *mark = &coat->marks[i];
            char what[VALIDATE_WHAT_SIZE];
            const float *const numbers[] = { &mark->from,  &mark->to,  &mark->width,
                                             &mark->slant, &mark->low, &mark->high };
            snprintf(what, sizeof what, "%s/mark", card->key_names[key]);
            for (uint32_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
                if (!validate_number(v, what, *numbers[k], -1000.0f, 1000.0f)) {
                    return false;
                }
            }
            if (!validate_choice(v, what, mark->kind, MARK_COUNT) ||
                !validate_choice(v, what, mark->part, PART_COUNT)) {
                return false;
            }
        }
    }
    return true;
}

bool species_validate(const struct species *species, char why[VALIDATE_WHY_SIZE])
{
    struct vetting v = { .species = species, .why = why };
    const struct species_card *card = &species->card;
    if (!vet_name(&v, "id", card->id) || !vet_keys(&v) ||
        !validate_choice(&v, "measure", card->measure, MEASURE_DISC + 1u) ||
        !validate_choice(&v, "motion", card->motion, MOTION_WING + 1u) ||
        !validate_choice(&v, "form", card->form, FORM_PUFFER + 1u)) {
        return false;
    }
    for (uint32_t i = 0; i < 3; i++) {
        if (!validate_choice(&v, "thesis keys", card->thesis_key[i], card->key_count)) {
            return false;
        }
        if (i > 0 && card->thesis_key[i] <= card->thesis_key[i - 1]) {
            return validate_refuse(&v, "thesis keys: they go from young to old");
        }
    }
    if (card->thesis_template == TEMPLATE_OWN) {
        return validate_refuse(&v, "thesis template: it is one of its own");
    }
    if (!validate_choice(&v, "thesis template", card->thesis_template, TEMPLATE_COUNT)) {
        return false;
    }
    const struct growth *g = &v.species->card.growth;
    if (!validate_number(&v, "growth/length_inf_m", g->length_inf_m, LENGTH_MIN_M, LENGTH_MAX_M) ||
        !validate_number(&v, "growth/k_per_year", g->k_per_year, 0.001f, 10.0f) ||
        !validate_number(&v, "growth/t0_year", g->t0_year, -20.0f, 20.0f) ||
        !validate_number(&v, "growth/fade_year", g->fade_year, 0.001f, 5.0f)) {
        return false;
    }
    if (g->point_count < 1 || g->point_count > GROWTH_POINT_MAX) {
        return validate_refuse(&v, "growth/points: %u, and there are 1 to %u", g->point_count,
                               GROWTH_POINT_MAX);
    }
    for (uint32_t i = 0; i < g->point_count; i++) {
        const struct growth_point *point = &g->points[i];
        if (!validate_number(&v, "growth/age_days", point->age_days, 0.0f, AGE_MAX_DAYS) ||
            !validate_number(&v, "growth/length_m", point->length_m, LENGTH_MIN_M, LENGTH_MAX_M)) {
            return false;
        }
        if (i == 0 ? point->age_days != 0.0f : point->age_days <= point[-1].age_days) {
            return validate_refuse(&v, "growth/age_days: point %u (%g) does not go on from 0", i,
                                   (double)point->age_days);
        }
    }
    /* The age, the progress and the length of each key must be consistent, because some parts of
     * the program compute one of the three values from the others. */
    for (uint32_t key = 0; key < card->key_count; key++) {
        const float age = card->key_age_days[key], length = card->key_length_m[key];
        const float grown = growth_length_m(&card->growth, age);
        if (!(f_abs(grown / length - 1.0f) <= LENGTH_APART)) {
            return validate_refuse(&v, "%s/length_m: %.4g at %.4g days, where growth says %.4g",
                                   card->key_names[key], (double)length, (double)age,
                                   (double)grown);
        }
    }
    return vet_scale(&v) && vet_curves(&v) && vet_coats(&v) && validate_meshes(&v);
}
