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
/* Maximum relative difference between the length of a key (modelled growth stage) and the length
 * that the growth curve gives at the key's age. */
#define LENGTH_APART 0.02f
/* Size in bytes of the buffer for the name of a value, which begins the reason for a rejection. */
#define WHAT_SIZE 64u

bool validate_refuse(char why[VALIDATE_WHY_SIZE], const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(why, VALIDATE_WHY_SIZE, format, values);
    va_end(values);
    return false;
}

bool validate_number(char why[VALIDATE_WHY_SIZE], float x, float low, float high,
                     const char *format, ...)
{
    char what[WHAT_SIZE];
    va_list values;
    if (x >= low && x <= high) { /* If x is NaN, both comparisons are false. */
        return true;
    }
    va_start(values, format);
    vsnprintf(what, sizeof what, format, values);
    va_end(values);
    return validate_refuse(why, "%s: %g is outside %g .. %g", what, (double)x, (double)low,
                           (double)high);
}

bool species_name_is_good(const char text[SPECIES_NAME_SIZE])
{
    const size_t length = strnlen(text, SPECIES_NAME_SIZE);
    for (size_t i = length; i < SPECIES_NAME_SIZE; i++) {
        if (text[i] != '\0') {
            return false;
        }
    }
    return length > 0 && length < SPECIES_NAME_SIZE &&
           strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789_") == length;
}

/* Validates the name `text`. If the name is invalid, writes the reason to `why` and returns false.
 * The reason begins with "ITEM INDEX/name", where ITEM is `item` and INDEX is `index`. */
static bool validate_name(char why[VALIDATE_WHY_SIZE], const char *item, uint32_t index,
                          const char text[SPECIES_NAME_SIZE])
{
    return species_name_is_good(text) ||
           validate_refuse(why, "%s %u/name: the name must have 1 to %u characters a-z, 0-9 and _",
                           item, index, SPECIES_NAME_SIZE - 1u);
}

static bool validate_keys(const struct species_card *card, char why[VALIDATE_WHY_SIZE])
{
    if (card->key_count < 3 || card->key_count > MORPH_KEY_MAX) {
        return validate_refuse(why, "keys: %u, but a species has 3 to %u keys", card->key_count,
                               MORPH_KEY_MAX);
    }
    for (uint32_t key = 0; key < card->key_count; key++) {
        const float age = card->key_age_days[key];
        const char *name = card->key_names[key];
        if (!validate_name(why, "key", key, name) ||
            !validate_number(why, age, 0.0f, AGE_MAX_DAYS, "%s/age_days", name)) {
            return false;
        }
        if (key > 0 && age <= card->key_age_days[key - 1]) {
            return validate_refuse(
                why, "%s/age_days: %g is not greater than the age of the previous key", name,
                (double)age);
        }
        if (!validate_number(why, card->key_length_m[key], LENGTH_MIN_M, LENGTH_MAX_M,
                             "%s/length_m", name)) {
            return false;
        }
        for (uint32_t other = 0; other < key; other++) {
            if (strcmp(name, card->key_names[other]) == 0) {
                return validate_refuse(why, "key %u/name: '%s' exists already", key, name);
            }
        }
    }
    return true;
}

static bool validate_growth(const struct species_card *card, char why[VALIDATE_WHY_SIZE])
{
    const struct growth *g = &card->growth;
    if (!validate_number(why, g->length_inf_m, LENGTH_MIN_M, LENGTH_MAX_M, "growth/length_inf_m") ||
        !validate_number(why, g->k_per_year, 0.001f, 10.0f, "growth/k_per_year") ||
        !validate_number(why, g->t0_year, -20.0f, 20.0f, "growth/t0_year") ||
        !validate_number(why, g->fade_year, 0.001f, 5.0f, "growth/fade_year")) {
        return false;
    }
    if (g->point_count < 1 || g->point_count > GROWTH_POINT_MAX) {
        return validate_refuse(why, "growth/points: %u, but 1 to %u points are allowed",
                               g->point_count, GROWTH_POINT_MAX);
    }
    for (uint32_t i = 0; i < g->point_count; i++) {
        const struct growth_point *point = &g->points[i];
        if (!validate_number(why, point->age_days, 0.0f, AGE_MAX_DAYS, "growth/age_days") ||
            !validate_number(why, point->length_m, LENGTH_MIN_M, LENGTH_MAX_M, "growth/length_m")) {
            return false;
        }
        if (i == 0 ? point->age_days != 0.0f : point->age_days <= point[-1].age_days) {
            return validate_refuse(
                why,
                "growth/age_days: point %u (%g) breaks the order, which starts at 0 and increases",
                i, (double)point->age_days);
        }
    }
    /* The age, the progress and the length of each key must be consistent, because some parts of
     * the program compute one of the three values from the others. */
    for (uint32_t key = 0; key < card->key_count; key++) {
        const float age = card->key_age_days[key], length = card->key_length_m[key];
        const float grown = growth_length_m(g, age);
        if (!(f_abs(grown / length - 1.0f) <= LENGTH_APART)) {
            return validate_refuse(
                why, "%s/length_m: %.4g at %.4g days, but the growth curve gives %.4g",
                card->key_names[key], (double)length, (double)age, (double)grown);
        }
    }
    return true;
}

static bool validate_scale(const struct species_card *card, char why[VALIDATE_WHY_SIZE])
{
    const uint32_t count = card->scale_knot_count;
    if (count == 1 || count > GRAPH_KNOT_MAX) {
        return validate_refuse(why, "scale knots: %u, but 0 or 2 to %u knots are allowed", count,
                               GRAPH_KNOT_MAX);
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct scale_knot *knot = &card->scale_knots[i];
        const float first = i == 0 ? 0.0f : i + 1 == count ? 1.0f : knot->progress;
        if (!validate_number(why, knot->progress, 0.0f, 1.0f, "scale knot/progress") ||
            !validate_number(why, knot->length_m, LENGTH_MIN_M, LENGTH_MAX_M,
                             "scale knot/length_m")) {
            return false;
        }
        if (knot->progress != first || (i > 0 && knot->progress <= knot[-1].progress)) {
            return validate_refuse(
                why, "scale knot/progress: %g breaks the order, which increases from 0 to 1",
                (double)knot->progress);
        }
    }
    return true;
}

static bool validate_curves(const struct species_card *card, char why[VALIDATE_WHY_SIZE])
{
    static const char *const reasons[] = {
        [GRAPH_KNOT_COUNT] = "the number of knots is not allowed",
        [GRAPH_ENDS] = "the first knot must be at progress 0 and the last knot at 1",
        [GRAPH_ORDER] = "the progress is not greater than that of the previous knot",
        [GRAPH_NEGATIVE] = "a weight is negative or not a number",
        [GRAPH_SUM] = "the sum of the weights is not 1",
        [GRAPH_UNSOLVABLE] = "unsolvable: a key has too little weight at its own progress",
    };
    if (card->curve_count < 1 || card->curve_count > MORPH_CURVE_MAX) {
        return validate_refuse(why, "curves: %u, but 1 to %u curves are allowed", card->curve_count,
                               MORPH_CURVE_MAX);
    }
    for (uint32_t i = 0; i < card->curve_count; i++) {
        const struct graph *graph = &card->curves[i];
        const char *name = card->curve_names[i];
        if (!validate_name(why, "curve", i, name) ||
            !validate_choice(why, graph->line, GRAPH_SMOOTH + 1u, "curve %s/line", name) ||
            !validate_choice(why, graph->solved, 2, "curve %s/solved", name)) {
            return false;
        }
        const struct graph_verdict verdict = graph_check(graph, card->key_count);
        if (verdict.fault != GRAPH_GOOD) {
            return validate_refuse(why, "curve %s/knot %u: %s (%g)", name, verdict.knot,
                                   reasons[verdict.fault], (double)verdict.value);
        }
    }
    return true;
}

static bool validate_coats(const struct species *species, char why[VALIDATE_WHY_SIZE])
{
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        const struct species_coat *coat = &species->coats[key];
        const char *name = species->card.key_names[key];
        if ((coat->back | coat->flank | coat->belly | coat->fin | coat->iris) > 0xffffffu) {
            return validate_refuse(why, "%s/coat: a colour is greater than ffffff", name);
        }
        if (coat->mark_count > MARK_MAX) {
            return validate_refuse(why, "%s/marks: more than %u", name, MARK_MAX);
        }
        for (uint32_t i = 0; i < coat->mark_count; i++) {
            const struct species_mark *mark = &coat->marks[i];
            const float numbers[] = { mark->from,  mark->to,  mark->width,
                                      mark->slant, mark->low, mark->high };
            for (uint32_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
                if (!validate_number(why, numbers[k], -1000.0f, 1000.0f, "%s/mark", name)) {
                    return false;
                }
            }
            if (!validate_choice(why, mark->kind, MARK_COUNT, "%s/mark", name) ||
                !validate_choice(why, mark->part, PART_COUNT, "%s/mark", name)) {
                return false;
            }
        }
    }
    return true;
}

bool species_validate(const struct species *species, char why[VALIDATE_WHY_SIZE])
{
    const struct species_card *card = &species->card;
    if (!species_name_is_good(card->id)) {
        return validate_refuse(why, "id: the name must have 1 to %u characters a-z, 0-9 and _",
                               SPECIES_NAME_SIZE - 1u);
    }
    if (!validate_keys(card, why) ||
        !validate_choice(why, card->measure, MEASURE_DISC + 1u, "measure") ||
        !validate_choice(why, card->motion, MOTION_WING + 1u, "motion") ||
        !validate_choice(why, card->form, FORM_PUFFER + 1u, "form")) {
        return false;
    }
    for (uint32_t i = 0; i < 3; i++) {
        if (!validate_choice(why, card->thesis_key[i], card->key_count, "thesis keys")) {
            return false;
        }
        if (i > 0 && card->thesis_key[i] <= card->thesis_key[i - 1]) {
            return validate_refuse(why, "thesis keys: the keys must be in the order of their ages");
        }
    }
    if (card->thesis_template == TEMPLATE_OWN) {
        return validate_refuse(why, "thesis template: the species' own graph is not allowed");
    }
    return validate_choice(why, card->thesis_template, TEMPLATE_COUNT, "thesis template") &&
           validate_growth(card, why) && validate_scale(card, why) && validate_curves(card, why) &&
           validate_coats(species, why) && validate_meshes(species, why);
}
