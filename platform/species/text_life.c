/* text_life.c -- parses the lines that describe the whole species: its name, its kind and its
 * growth. */
#include "platform/species/reader.h"

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
    static const char *const choices[] = { [MEASURE_TOTAL] = "total",
                                           [MEASURE_STANDARD] = "standard",
                                           [MEASURE_FORK] = "fork",
                                           [MEASURE_DISC] = "disc" };
    return read_choice(r, "measure", choices, 4, &r->species->measure);
}

bool text_read_form(struct species_reader *r)
{
    static const char *const choices[] = { [FORM_FUSIFORM] = "fusiform",
                                           [FORM_COMPRESSED] = "compressed",
                                           [FORM_DEPRESSED] = "depressed",
                                           [FORM_EEL] = "eel",
                                           [FORM_PUFFER] = "puffer" };
    return read_choice(r, "form", choices, 5, &r->species->form);
}

bool text_read_motion(struct species_reader *r)
{
    static const char *const choices[] = { [MOTION_TAIL] = "tail",
                                           [MOTION_EEL] = "eel",
                                           [MOTION_FINS] = "fins",
                                           [MOTION_TUNA] = "tuna",
                                           [MOTION_WING] = "wing" };
    return read_choice(r, "motion", choices, 5, &r->species->motion);
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

/* Parses the line `scale PROGRESS MM`, which gives a length in mm at a progress through life. These
 * lines replace the growth curve. */
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
